// ikbench reproduce: every study of a paper in one store, the interpretations and the audit, with one report.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <thread>
#include <utility>

#include "analysis/papers.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/readings.hpp"
#include "cli/reporting.hpp"
#include "experiments/study_reader.hpp"
#include "experiments/study_writer.hpp"
#include "results/fingerprint.hpp"

namespace ikbench::cli {

using namespace results;
using namespace experiments;
using namespace report;

namespace {

// The fingerprint of a study in one line, and whether it is the reference that every machine should give.
std::string compared_with_reference(const Store& store, const std::string& name) {
  const std::string ours = fingerprint(store.solves(name));
  const std::string_view reference = reference_fingerprint(name);
  const bool is_as_built_in = store.study(name).definition == to_json(load_study(name));
  return fmt::format("Fingerprint of {}: {}, {}", name, ours,
                     reference.empty()   ? "this study has no reference"
                     : !is_as_built_in   ? "no reference for this seed and number of runs"
                     : ours == reference ? "equal to the reference"
                                         : fmt::format("different from the reference {}", reference));
}

// The paper's studies, each with those of the overrides that it takes.
std::vector<std::pair<std::string, Overrides>> studies_of(const Paper& paper,
                                                          const std::map<std::string, std::string>& given) {
  std::vector<std::pair<std::string, Overrides>> studies;
  for (const PaperStudy& study : paper.studies) {
    Overrides& overrides = studies.emplace_back(study.name, Overrides()).second;
    for (const std::string& option : study.takes) overrides.push_back(given.at(option));
  }
  return studies;
}

}  // namespace

void add_reproduce(CLI::App& app, Invocation& invocation) {
  struct Arguments {
    std::string paper;
    std::int64_t seed = 1;
    int runs = 20;
    int seeds = 3;
    RunArguments run;
    ReportArguments report;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("reproduce", "Repeat the experiments of a paper and report beside the printed results");
  add_paper_option(*command, arguments->paper);
  add_run_options(*command, arguments->run);
  command->add_option("--seed", arguments->seed, "seed of the studies")->check(whole_number())->capture_default_str();
  command->add_option("--runs", arguments->runs, "runs of each solver on the helix")
      ->check(whole_number())
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  command
      ->add_option("--readings", arguments->seeds,
                   "number of seeds for comparing the interpretations of the paper; 0: skip them")
      ->check(whole_number())
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  add_report_options(*command, arguments->report);
  command->footer(
      "Examples:\n"
      "  ikbench reproduce\n"
      "  ikbench reproduce --seed 2 --out out/seed-2\n"
      "  ikbench reproduce --readings 0           faster: skip the interpretations\n"
      "  ikbench reproduce --jobs 2               faster: two solves at once, but times are not comparable");
  command->callback([arguments, &invocation] {
    refuse_points(arguments->report);
    const Paper& paper = analysis::paper(arguments->paper);
    const std::string& first = paper.studies.front().name;
    const std::filesystem::path folder =
        arguments->run.out.empty() ? default_folder(first) : std::filesystem::path(arguments->run.out);
    const std::string seed = fmt::format("seed={}", arguments->seed), runs = fmt::format("runs={}", arguments->runs);
    const auto studies = studies_of(paper, {{"seed", seed}, {"runs", runs}});
    for (const auto& [name, overrides] : studies) {
      if (run_and_tell(load_study(name, overrides), folder,
                       {.jobs = arguments->run.jobs, .command = invocation.command}) == Ended::stopped) {
        invocation.exit_code = 130;
        return;
      }
    }
    WrittenReport wanted{.study = first, .folder = folder, .arguments = arguments->report};
    if (paper.readings && arguments->seeds > 0) {
      const CancelOnSignal signals;
      const ReadingsPlan plan = plan_readings(first, one_at_a_time(readings(first)), arguments->seeds, {runs});
      // No time is measured here, so all processors may work.
      const int processors = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
      const Read answer = read(paper, plan, std::max(arguments->run.jobs, processors), signals.requested());
      if (!answer.is_complete) {
        say("Stopped before the report. The solves are kept; run the same command again to continue.");
        invocation.exit_code = 130;
        return;
      }
      wanted.tables.push_back(answer.report->table);
      wanted.figures.push_back(answer.report->figure);
    }
    if (paper.audit) wanted.tables.push_back(audit_table(paper.audit()));
    const Store store(store_in(folder), Store::Mode::read);
    for (const auto& [name, overrides] : studies) {
      check_is_stored(load_study(name, overrides), store);
      wanted.remarks.push_back(compared_with_reference(store, name));
    }
    write_and_announce(store, std::move(wanted));
  });
}

}  // namespace ikbench::cli
