// ikbench report: writes tables and figures from any store, without solving.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/names.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "cli/studies.hpp"

namespace ikbench::cli {

namespace {

// Returns the first list that names each study differently: names of studies, arms or folders; otherwise the files.
const std::vector<std::string>& distinct_names(const std::vector<std::string>& names,
                                               const std::vector<std::string>& arms,
                                               const std::vector<std::string>& folders,
                                               const std::vector<std::string>& files) {
  const auto are_distinct = [](const std::vector<std::string>& texts) {
    return std::set<std::string>(texts.begin(), texts.end()).size() == texts.size();
  };
  for (const std::vector<std::string>* const texts : {&names, &arms, &folders})
    if (are_distinct(*texts)) return *texts;
  return files;
}

// Reports the studies of several stores. Returns the exit code.
int report_stores(const std::vector<std::string>& files, const std::string& study, const std::string& out,
                  const ReportArguments& report) {
  if (out.empty()) throw std::invalid_argument("several stores make one table; say where to write it: --out FOLDER");
  std::vector<std::unique_ptr<Store>> stores;
  std::vector<StoredStudy> studies;
  std::vector<std::string> names, arms, folders;
  std::set<std::string> keys;  // of the series of all stores
  for (const std::string& file : files) {
    const Store& store = *stores.emplace_back(std::make_unique<Store>(file, Store::Mode::read));
    const StoredStudy& entry = studies.emplace_back(store.study(study));
    for (const results::Series& series : entry.series)
      if (!keys.insert(series.key).second)
        throw std::invalid_argument(file + ": an earlier store has the same " + series.label +
                                    "; leave this store out");
    names.push_back(entry.name);
    arms.push_back(entry.definition.robot);
    folders.push_back(std::filesystem::path(file).parent_path().filename());
  }
  const std::vector<std::string>& shown = distinct_names(names, arms, folders, files);
  StudiesToReport all{.title = base::counted(std::ssize(files), "studies"), .keys = {}, .studies = {}};
  for (std::size_t i = 0; i < files.size(); ++i)
    all.studies.push_back({.store = *stores[i], .study = studies[i], .name = shown[i]});
  return report_studies(all, out, report);
}

}  // namespace

void add_report(const Command& command, Invocation& invocation) {
  struct Arguments {
    std::vector<std::string> stores;
    std::string study, out;
    ReportArguments report;
  };
  auto arguments = std::make_shared<Arguments>();
  command
      .add("STORE", &arguments->stores,
           "path of a store.sqlite; several stores make one table, with a column per study")
      .required();
  add_study_option(command, arguments->study,
                   "name of the study; default: all studies of a sweep, otherwise the first in the store");
  add_out_option(command, arguments->out, "folder to write to; default: the folder of the store");
  add_report_options(command, arguments->report, true);
  command.footer(
      "  ikbench report out/my/store.sqlite\n"
      "  ikbench report theirs.sqlite --out out/theirs\n"
      "  ikbench report out/panda/store.sqlite out/ur5e/store.sqlite --out out/both\n"
      "  ikbench report out/my/store.sqlite --style journal.toml");
  command.callback([arguments, &invocation] {
    if (arguments->stores.size() > 1) {
      invocation.exit_code = report_stores(arguments->stores, arguments->study, arguments->out, arguments->report);
      return;
    }
    const std::string& file = arguments->stores.front();
    const std::filesystem::path folder =
        arguments->out.empty() ? std::filesystem::path(file).parent_path() : std::filesystem::path(arguments->out);
    const Store store(file, Store::Mode::read);
    if (const std::vector<StoredStudy> sweep = store.sweep(arguments->study); !sweep.empty()) {
      invocation.exit_code =
          report_studies(studies_of_sweep(store, sweep), folder.empty() ? "." : folder, arguments->report);
      return;
    }
    const StoredStudy study = store.study(arguments->study);
    invocation.exit_code = write_and_announce(store, study, folder.empty() ? "." : folder, arguments->report,
                                              imported_results(study, arguments->report));
  });
}

}  // namespace ikbench::cli
