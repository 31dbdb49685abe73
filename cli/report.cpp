// ikbench report: tables and figures from any store, without solving.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "cli/commands.hpp"
#include "cli/reporting.hpp"
#include "experiments/collection.hpp"

namespace ikbench::cli {

using namespace results;
using namespace experiments;

void add_report(CLI::App& app, Invocation&) {
  struct Arguments {
    std::string store, study, out;
    ReportArguments report;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("report", "Write tables, figures and the report from a store, without solving");
  command->add_option("STORE", arguments->store, "path of a store.sqlite")->required();
  command->add_option(
      "--study", arguments->study,
      "name of the study, or path of the TOML file of a collection, whose studies are reported together; "
      "default: the first in the store");
  command->add_option("--out", arguments->out, "folder to write to; default: the folder of the store")
      ->check(not_empty());
  add_report_options(*command, arguments->report);
  command->footer(
      "Examples:\n"
      "  ikbench report out/my/store.sqlite\n"
      "  ikbench report theirs.sqlite --out out/theirs --quartiles 7\n"
      "  ikbench report out/arms/store.sqlite --study arms.toml    a collection, as ikbench run arms.toml reports it\n"
      "  ikbench report out/my/store.sqlite --style journal.toml");
  command->callback([arguments] {
    const std::filesystem::path folder = arguments->out.empty() ? std::filesystem::path(arguments->store).parent_path()
                                                                : std::filesystem::path(arguments->out);
    const Store store = checked_store(arguments->store);
    refuse_reproduction(folder.empty() ? "." : folder);
    const std::optional<StudyCollection> file = load_collection(arguments->study);
    std::optional<report::Collection> collection;
    if (file) collection = reported_collection(*file, arguments->report);
    const StudyEntry study = chosen_study(store, file ? file->studies.front().name : arguments->study);
    if (file) {
      for (const Study& each : file->studies) static_cast<void>(store.study(each.name));  // all are there
    }
    write_and_announce(store, {.study = study.name,
                               .folder = folder.empty() ? "." : folder,
                               .arguments = arguments->report,
                               .collection = std::move(collection),
                               .tells_of_further = arguments->study.empty()});
  });
}

}  // namespace ikbench::cli
