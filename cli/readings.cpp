// ikbench readings: each interpretation of the paper against the default, over several seeds.
#include "cli/readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "analysis/papers.hpp"
#include "analysis/report/report.hpp"
#include "cli/commands.hpp"
#include "cli/console.hpp"
#include "cli/reporting.hpp"

namespace ikbench::cli {

using namespace numerics;
using namespace experiments;
using namespace figures;
using namespace report;

namespace {

struct ReadingsArguments {
  std::string paper, out;
  std::vector<std::string> grid;
  Overrides overrides;
  int seeds = 3, jobs = 1;
  bool list = false, without_figures = false;
};

std::string name_of(const Combination& combination) {
  if (combination.empty()) return "default";
  std::string name;
  for (const Reading& reading : combination) name += fmt::format("{}{}", name.empty() ? "" : " + ", reading.set);
  return name;
}

// The rows of which all parts are there.
std::vector<ReadingResults> results_of(const ReadingsPlan& plan, const std::vector<RunMeans>& means) {
  std::vector<ReadingResults> results;
  for (const ReadingsPlan::Row& row : plan.rows) {
    const auto is_there = [&](const auto& seeds) { return std::ranges::max(seeds) < means.size(); };
    if (!std::ranges::all_of(row.parts, is_there)) continue;
    ReadingResults& result = results.emplace_back();
    result.name = name_of(row.readings);
    result.out_of_reach = row.out_of_reach;
    if (row.readings.size() == 1) {
      result.section = row.readings.front().section;
      result.sentence = row.readings.front().sentence;
    }
    for (std::size_t s = 0; s < plan.solvers.size(); ++s) {
      ReadSolver& solver = result.solvers.emplace_back();
      solver.label = plan.solvers[s];
      solver.is_moved = row.parts[s] != plan.rows.front().parts[s];
      for (const std::size_t part : row.parts[s]) {
        solver.error_cm.push_back(means[part].error_cm);
        solver.variation_deg.push_back(means[part].variation_deg);
      }
    }
  }
  return results;
}

std::string reading_list(const std::vector<Reading>& readings) {
  std::vector<std::vector<std::string>> rows{{"INTERPRETATION", "NOTES", "MEANING"}};
  for (const Reading& reading : readings) rows.push_back({reading.set, reading.section, reading.sentence});
  return aligned(rows);
}

void write_and_tell(const ReadingsReport& report, const ReadingsArguments& arguments) {
  fmt::print("{}\n", aligned(readable_cells(report.table)));
  for (const std::string& note : report.table.notes) fmt::print("{}\n", printable(note));
  if (arguments.out.empty()) return;
  const std::filesystem::path folder = arguments.out;
  write_table(report.table, folder / "tables");
  draw({report.figure}, folder / "figures", {.render = !arguments.without_figures, .jobs = 1});
  fmt::print("Table: {}\nFigure: {}\n", printable((folder / "tables" / "readings.md").string()),
             printable((folder / "figures" / (arguments.without_figures ? "readings.gp" : "readings.png")).string()));
}

}  // namespace

Read read(const Paper& paper, const ReadingsPlan& plan, const SeriesArguments& arguments) {
  const std::vector<RunMeans> means = solved(plan.parts, arguments);
  const std::vector<ReadingResults> results = results_of(plan, means);
  Read answer{.done = results.size(), .is_complete = means.size() == plan.parts.size()};
  if (!results.empty()) answer.report = paper.readings(results);
  return answer;
}

std::vector<ReadSolver> repetitions(const ReadingsPlan& plan, const SeriesArguments& arguments) {
  std::vector<ReadingResults> results = results_of(plan, solved(plan.parts, arguments));
  return results.empty() ? std::vector<ReadSolver>() : std::move(results.front().solvers);
}

void add_readings(CLI::App& app, Invocation& invocation) {
  auto arguments = std::make_shared<ReadingsArguments>();
  CLI::App* command = app.add_subcommand(
      "readings", "Compare interpretations of what a paper leaves open, one by one, with the default");
  add_paper_option(*command, arguments->paper);
  command->add_flag("--list", arguments->list, "list the interpretations without solving");
  command->add_option("--grid", arguments->grid, "try all combinations of these instead of one at a time")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_series_options(*command, arguments->seeds, arguments->jobs);
  command
      ->add_option("--set", arguments->overrides,
                   "change a key in the default and in every interpretation: runs=5, population=20")
      ->allow_extra_args(false);
  command->add_option(
      "--out", arguments->out,
      "folder for tables/readings, figures/readings and series.csv, which keeps what is solved; default: print "
      "only");
  command->add_flag("--no-figures", arguments->without_figures,
                    "write the script and data of the figure, but do not draw it");
  command->footer(
      "Examples:\n"
      "  ikbench readings slim2023 --jobs 2 --out out/readings\n"
      "  ikbench readings slim2023 --list\n"
      "  ikbench readings slim2023 --grid search=all_joints,IK-BA.step_factor=1,IK-BA.epsilon=truncated\n\n"
      "Solvers that an interpretation does not affect are not run again. Ctrl-C shows what is finished.");
  command->callback([arguments, &invocation] {
    const Paper& paper = analysis::paper(arguments->paper);
    if (!paper.readings)
      throw std::invalid_argument(fmt::format("the program has no interpretations of the paper {}", paper.name));
    const std::string& study = paper.studies.front().name;
    const std::vector<Reading> all = readings(study);
    if (arguments->list) {
      fmt::print("{}", reading_list(all));
      return;
    }
    const CancelOnSignal signals;
    const ReadingsPlan plan =
        plan_readings(study, arguments->grid.empty() ? one_at_a_time(all) : full_grid(all, arguments->grid),
                      arguments->seeds, arguments->overrides);
    const Read answer = read(paper, plan, {"interpretations", arguments->out, arguments->jobs, &signals.requested()});
    if (answer.report) write_and_tell(*answer.report, *arguments);
    if (answer.is_complete) return;
    say(fmt::format("Stopped: {} of {} interpretations are done, including the default.", answer.done,
                    plan.rows.size()));
    invocation.exit_code = 130;
  });
}

}  // namespace ikbench::cli
