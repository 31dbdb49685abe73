// ikbench reproduce: the paper's study and its context, into one store, with one report.
#include <fmt/format.h>

#include <memory>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "experiments/study_file.hpp"

namespace ikbench::cli {

void add_reproduce(CLI::App& app, Invocation& invocation) {
  struct Arguments {
    std::int64_t seed = 1;
    int runs = 20;
    RunArguments run;
    ReportArguments report;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("reproduce", "Make the tables and figures of Slim et al. 2023, beside the printed");
  add_run_options(*command, arguments->run);
  command->add_option("--seed", arguments->seed, "")->check(whole_number())->capture_default_str();
  command->add_option("--runs", arguments->runs, "")
      ->check(whole_number())
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  add_report_options(*command, arguments->report);
  command->footer(
      "Examples:\n"
      "  ikbench reproduce\n"
      "  ikbench reproduce --seed 2 --out out/seed-2\n"
      "  ikbench reproduce --jobs 2               faster; times are marked as not comparable");
  command->callback([arguments, &invocation] {
    const Overrides overrides{fmt::format("seed={}", arguments->seed), fmt::format("runs={}", arguments->runs)};
    const std::filesystem::path folder =
        arguments->run.out.empty() ? default_folder("slim2023") : std::filesystem::path(arguments->run.out);
    for (const char* name : {"slim2023", "slim2023-context"}) {
      if (run_and_tell(load_study(name, overrides), folder,
                       {.jobs = arguments->run.jobs, .command = invocation.command}) == Ended::stopped) {
        invocation.exit_code = 130;
        return;
      }
    }
    write_and_announce(Store(store_in(folder), Store::Mode::read), "slim2023", folder, arguments->report);
  });
}

}  // namespace ikbench::cli
