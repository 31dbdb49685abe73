// ikbench report: tables and figures from any store, without solving.
#include <filesystem>
#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/reporting.hpp"

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
  command->add_option("--study", arguments->study, "name of the study; default: the first in the store");
  command->add_option("--out", arguments->out, "folder to write to; default: the folder of the store")
      ->check(not_empty());
  add_report_options(*command, arguments->report);
  command->footer(
      "Examples:\n"
      "  ikbench report out/my/store.sqlite\n"
      "  ikbench report theirs.sqlite --out out/theirs\n"
      "  ikbench report out/my/store.sqlite --style journal.toml");
  command->callback([arguments] {
    const std::filesystem::path folder = arguments->out.empty() ? std::filesystem::path(arguments->store).parent_path()
                                                                : std::filesystem::path(arguments->out);
    const Store store(arguments->store, Store::Mode::read);
    const StudyEntry study = chosen_study(store, arguments->study);
    write_and_announce(store, study.name, folder.empty() ? "." : folder, arguments->report);
  });
}

}  // namespace ikbench::cli
