// ikbench report: tables and figures from any store, without solving.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "cli/commands.hpp"
#include "cli/reporting.hpp"
#include "results/looks.hpp"

namespace ikbench::cli {

using namespace results;

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
  command
      ->add_option("--solvers", arguments->report.solvers,
                   "report on these solvers alone, by label: A,B; fewer pairs are compared, and the report says so")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->footer(
      "Examples:\n"
      "  ikbench report out/my/store.sqlite\n"
      "  ikbench report theirs.sqlite --out out/theirs --quartiles 7\n"
      "  ikbench report out/my/store.sqlite --out out/pair --solvers mine,newton\n"
      "  ikbench report out/my/store.sqlite --style journal.toml");
  command->callback([arguments] {
    const std::filesystem::path folder = arguments->out.empty() ? std::filesystem::path(arguments->store).parent_path()
                                                                : std::filesystem::path(arguments->out);
    const Store store = open_to_look(arguments->store);
    refuse_reproduction(folder.empty() ? "." : folder);
    write_and_announce(store, {.study = chosen_study(store, arguments->study).name,
                               .folder = folder.empty() ? "." : folder,
                               .arguments = arguments->report});
  });
}

}  // namespace ikbench::cli
