// ikbench reproduce: the paper's study and its context, into one store, with one report.
#include <fmt/format.h>

#include <memory>

#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"
#include "experiments/study_file.hpp"
#include "results/fingerprint.hpp"

namespace ikbench::cli {

namespace {

// What the numbers of a study are, in a line, and whether they are those that everybody should get.
std::string compared_with_reference(const Store& store, const std::string& name) {
  const std::string ours = fingerprint(store.solves(name));
  const std::string_view reference = reference_fingerprint(name);
  const bool is_as_built_in = store.study(name).definition == to_json(load_study(name));
  return fmt::format("Fingerprint of {}: {}, {}", name, ours,
                     !is_as_built_in     ? "of a study with another seed or number of runs than the reference"
                     : ours == reference ? "the reference numbers"
                                         : fmt::format("not the reference numbers: {}", reference));
}

}  // namespace

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
    const std::vector<std::string> names{"slim2023", "slim2023-context"};
    for (const std::string& name : names) {
      if (run_and_tell(load_study(name, overrides), folder,
                       {.jobs = arguments->run.jobs, .command = invocation.command}) == Ended::stopped) {
        invocation.exit_code = 130;
        return;
      }
    }
    const Store store(store_in(folder), Store::Mode::read);
    std::vector<std::string> remarks;
    for (const std::string& name : names) remarks.push_back(compared_with_reference(store, name));
    write_and_announce(store, names.front(), folder, arguments->report, remarks);
  });
}

}  // namespace ikbench::cli
