#include "analysis/report/cost_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>

#include "analysis/inference/clusters.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/cost_comparison.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/inference/times.hpp"
#include "analysis/report/cost_pair_tables.hpp"
#include "analysis/statistics/proportion.hpp"
#include "analysis/statistics/survival.hpp"

namespace ikbench::report {

using namespace results;
using namespace statistics;
using namespace inference;

namespace {

using Groups = std::vector<std::vector<CensoredCost>>;

// One trial a target, however often it was solved.
Proportion share_reached(const Solves& solves, const std::vector<std::uint32_t>& targets, const StudyResults& study) {
  const Tolerance within = tolerance(study);
  std::map<std::size_t, Successes> counts;
  for (const Solve* solve : solves) {
    Successes& count = counts[targets[static_cast<std::size_t>(solve - study.solves.data())]];
    ++count.trials;
    if (reaches(*solve, within)) ++count.successes;
  }
  double shares = 0;
  for (const auto& [target, count] : counts) shares += static_cast<double>(count.successes) / count.trials;
  return wilson_of_mean(shares / static_cast<double>(counts.size()), static_cast<int>(counts.size()),
                        1 - study.plan.significance);
}

// The complete runs, and those among them in which every point came to the tolerance.
Successes runs_reached(const Solves& solves, const StudyResults& study) {
  const Tolerance within = tolerance(study);
  std::map<int, Successes> runs;
  for (const Solve* solve : solves) {
    Successes& run = runs[solve->run];
    ++run.trials;
    if (reaches(*solve, within)) ++run.successes;
  }
  Successes result;
  for (const auto& [number, run] : runs) {
    if (run.trials != study.points) continue;
    ++result.trials;
    if (run.successes == run.trials) ++result.successes;
  }
  return result;
}

void append(std::vector<Cell>& cells, const Successes& count, const Proportion& share) {
  cells.emplace_back(std::int64_t{count.trials});
  cells.emplace_back(std::int64_t{count.successes});
  cells.emplace_back(share.low);
  cells.emplace_back(share.high);
}

std::string dependence_note(Trials trials, const std::string& level) {
  if (trials == Trials::targets) {
    return fmt::format(
        "Each solve starts at the initial configuration, and targets repeat, so one trial is a target: the share of "
        "its solves that reach the tolerance. The interval is the {} Wilson interval of the mean share.",
        level);
  }
  if (trials == Trials::solves) {
    return fmt::format(
        "Solves are independent: each starts at the initial configuration. The interval is the {} Wilson interval.",
        level);
  }
  return fmt::format(
      "The solves of a run depend on each other, because each starts where the last answer left the arm. Therefore no "
      "interval or test uses single solves. Runs are independent: the interval is the {} Wilson interval of the share "
      "of complete runs in which every point reaches the tolerance.",
      level);
}

// The mean costs with their intervals, in the order of the columns.
void append(std::vector<Cell>& cells, const SolverCost& solver, const Clusters& clusters) {
  const auto interval_of = [&](const MeanCost& mean) {
    const Interval interval = clusters.interval(mean.replicates);
    return std::isnan(interval.low) ? Cell() : Cell(Range{interval.low, interval.high});
  };
  cells.insert(cells.end(), {solver.expected.estimate, interval_of(solver.expected), solver.time.sp1,
                             solver.curve.median, solver.restricted.estimate, interval_of(solver.restricted)});
}

std::string cost_interval_note(const Clusters& clusters) {
  if (!clusters.undefined().empty()) {
    return fmt::format("The mean costs have no intervals: {}.", clusters.undefined());
  }
  return fmt::format(
      "Intervals of ert and restricted_mean: {}, from {} bootstrap samples of the {} with all their solves (expanded "
      "percentiles). An end of inf: in some samples no solve succeeds.",
      percent(clusters.level()), clusters.replicates().size(), clusters.noun());
}

Table cost_table(const StudyResults& study, Cost cost, const Clusters& clusters) {
  const bool in_seconds = cost == Cost::seconds;
  const std::string_view unit = in_seconds ? "seconds" : "evaluations";
  Table table{.name = in_seconds ? "statistics-cost-seconds" : "statistics-cost",
              .caption = fmt::format("Cost [{}] until {}", unit, words(tolerance(study))),
              .columns = {{"solver", Align::left},
                          {"solves"},
                          {"reached"},
                          {"share_low"},
                          {"share_high"},
                          {"runs"},
                          {"runs_reached"},
                          {"runs_low"},
                          {"runs_high"},
                          {"ert"},
                          {"ert interval"},
                          {"sp1"},
                          {"median"},
                          {"restricted_mean"},
                          {"restricted_mean interval"}}};
  const Groups groups = censored_costs(study, cost);
  const std::vector<Solves> solves = solves_by_solver(study);
  const Trials trials = trials_of(study);
  const std::vector<std::uint32_t> targets = target_numbers(study);
  const Costs costs = costs_of(study, cost, clusters);
  std::vector<std::string> undefined;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const SolverCost& solver = costs.solvers[i];
    const Successes reached{.successes = static_cast<int>(std::ranges::count_if(groups[i], &CensoredCost::reached)),
                            .trials = static_cast<int>(groups[i].size())};
    std::vector<Cell> cells{study.solvers[i]};
    if (trials == Trials::runs) {
      cells.insert(cells.end(), {std::int64_t{reached.trials}, std::int64_t{reached.successes}, Cell(), Cell()});
      const Successes runs = runs_reached(solves[i], study);
      append(cells, runs, wilson(runs, 1 - study.plan.significance));
    } else {
      append(cells, reached, share_reached(solves[i], targets, study));
      cells.resize(cells.size() + 4);
    }
    append(cells, solver, clusters);
    table.rows.push_back(std::move(cells));
    const std::string& reason = solver.time.undefined.empty() ? solver.curve.undefined : solver.time.undefined;
    if (!reason.empty()) undefined.push_back(fmt::format("{}: {}", study.solvers[i], reason));
  }
  table.notes.push_back(
      fmt::format("A solve reaches the tolerance where, by the verifier, {} or less, inside the joint limits or "
                  "not. ert: cost of all solves divided by the number of successful ones. sp1: mean cost of the "
                  "successful solves divided by their share.",
                  words(tolerance(study))));
  table.notes.push_back(
      fmt::format("The Kaplan-Meier curve assumes that unsuccessful solves would have continued as the others did. "
                  "median: the first cost at which half have reached the tolerance, not defined if they never do. "
                  "restricted_mean: the mean up to {} {}, to which the curves of all solvers are known.",
                  rounded_number(costs.horizon, 6), unit));
  table.notes.push_back(cost_interval_note(clusters));
  if (in_seconds) table.notes.push_back(speed_note(study));
  const auto diverged = std::ranges::count(study.solves, StopReason::not_finite, &Solve::stop_reason);
  if (diverged > 0) {
    table.notes.push_back(
        fmt::format("Solves that ended with an error that is not finite: {}. They would not have continued, so median "
                    "and restricted_mean flatter their solvers.",
                    diverged));
  }
  table.notes.push_back(dependence_note(trials, percent(clusters.level())));
  for (const std::string& reason : undefined) table.notes.push_back(fmt::format("Not defined for {}.", reason));
  for (std::string& note : status_notes(study)) table.notes.push_back(std::move(note));
  return table;
}

}  // namespace

std::vector<Table> cost_tables(const StudyResults& measured) {
  if (measured.solves.empty()) return {};
  const StudyResults study = at_median_speed(measured), of_evaluations = compared_in(study, Metric::evaluations),
                     of_seconds = compared_in(study, Metric::seconds);
  const Clusters clusters(of_seconds), clusters_of_evaluations(of_evaluations, &clusters);
  const auto study_of = [&](Cost cost) -> const StudyResults& {
    return cost == Cost::evaluations ? of_evaluations : of_seconds;
  };
  const auto clusters_of = [&](Cost cost) -> const Clusters& {
    return cost == Cost::evaluations ? clusters_of_evaluations : clusters;
  };
  std::vector<Cost> costs;
  if (std::isfinite(tolerance_cm(study))) {
    if (!of_evaluations.solves.empty()) costs.push_back(Cost::evaluations);
    if (times_are_comparable(study)) costs.push_back(Cost::seconds);
  }
  std::vector<Table> tables;
  for (const Cost cost : costs) tables.push_back(cost_table(study_of(cost), cost, clusters_of(cost)));
  for (const Cost cost : costs) {
    if (study_of(cost).solvers.size() > 1) {
      tables.push_back(cost_pair_table(study_of(cost), cost, clusters_of(cost)));
    }
  }
  if (std::optional<Table> table = anytime_table(of_evaluations, clusters_of_evaluations)) {
    tables.push_back(std::move(*table));
  }
  for (Table& table : tables) {
    const bool is_of_seconds = table.name.find("-seconds") != std::string::npos;
    const std::string note = left_out(study, is_of_seconds ? Metric::seconds : Metric::evaluations).note;
    if (!note.empty()) table.notes.push_back(note);
  }
  return tables;
}

}  // namespace ikbench::report
