#include "analysis/report/cost_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <map>
#include <string>
#include <string_view>

#include "analysis/figures/figure_parts.hpp"
#include "analysis/inference/definition.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/log_rank.hpp"
#include "analysis/statistics/proportion.hpp"
#include "analysis/statistics/survival.hpp"

namespace ikbench::report {

using namespace results;
using namespace statistics;
using namespace inference;

namespace {

using Groups = std::vector<std::vector<CensoredCost>>;

bool is_empty_of_costs(const StudyResults& study) {
  return study.solves.empty() || !std::isfinite(tolerance_cm(study));
}

// Orders whatever numbers a target has, NaN too.
struct InOrder {
  bool operator()(const std::vector<double>& a, const std::vector<double>& b) const {
    return std::ranges::lexicographical_compare(a, b, [](double x, double y) { return std::strong_order(x, y) < 0; });
  }
};
using Targets = std::map<std::vector<double>, Successes, InOrder>;

// How many of a solver's solves of each target, position and rotation, came to the tolerance.
Targets targets_of(const Solves& solves, const StudyResults& study) {
  Targets targets;
  for (const SolveRecord* solve : solves) {
    std::vector<double> target = solve->target_position_m;
    target.insert(target.end(), solve->target_rotation.begin(), solve->target_rotation.end());
    Successes& count = targets[std::move(target)];
    ++count.trials;
    if (reaches(*solve, tolerance_cm(study))) ++count.successes;
  }
  return targets;
}

// What is independent of its like, so that an interval may count it. Where a solver is given a target more than once,
// as in the runs of a fixed path, a deterministic one only repeats itself: its solves are no trials.
enum class Trials { runs, targets, solves };

Trials trials_of(const StudyResults& study) {
  if (is_chained(study)) return Trials::runs;
  const bool repeats = std::ranges::any_of(
      solves_by_solver(study), [&](const Solves& solves) { return targets_of(solves, study).size() < solves.size(); });
  return repeats ? Trials::targets : Trials::solves;
}

// One trial a target, however often it was solved.
Proportion share_reached(const Solves& solves, const StudyResults& study) {
  const Targets targets = targets_of(solves, study);
  double shares = 0;
  for (const auto& [target, count] : targets) shares += static_cast<double>(count.successes) / count.trials;
  return wilson_of_mean(shares / static_cast<double>(targets.size()), static_cast<int>(targets.size()));
}

// The complete runs, and those among them in which every point came to the tolerance.
Successes runs_reached(const Solves& solves, const StudyResults& study) {
  std::map<int, Successes> runs;
  for (const SolveRecord* solve : solves) {
    Successes& run = runs[solve->run];
    ++run.trials;
    if (reaches(*solve, tolerance_cm(study))) ++run.successes;
  }
  Successes result;
  for (const auto& [number, run] : runs) {
    if (run.trials != study.points) continue;
    ++result.trials;
    if (run.successes == run.trials) ++result.successes;
  }
  return result;
}

// The largest cost to which the curves of all solvers are known.
double common_horizon(const std::vector<SurvivalCurve>& curves) {
  double known_by_all = censored, largest = 0;
  for (const SurvivalCurve& curve : curves) {
    if (!curve.undefined.empty()) continue;
    const bool ends_at_zero = !curve.steps.empty() && curve.steps.back().survival == 0;
    if (!ends_at_zero) known_by_all = std::min(known_by_all, curve.last_cost);
    largest = std::max(largest, curve.last_cost);
  }
  return std::min(known_by_all, largest);
}

void append(std::vector<Cell>& cells, const Successes& count, const Proportion& share) {
  cells.emplace_back(std::int64_t{count.trials});
  cells.emplace_back(std::int64_t{count.successes});
  cells.emplace_back(share.low);
  cells.emplace_back(share.high);
}

std::string dependence_note(Trials trials) {
  if (trials == Trials::targets) {
    return "Each solve starts at the initial configuration, and targets repeat, so one trial is a target: the share of "
           "its solves that reach the tolerance. The interval is the 95 % Wilson interval of the mean share. There is "
           "no log-rank test, because it would count every repetition.";
  }
  if (trials == Trials::solves) {
    return "Solves are independent: each starts at the initial configuration. The interval is the 95 % Wilson "
           "interval.";
  }
  return "The solves of a run depend on each other, because each starts where the last answer left the arm. Therefore "
         "no interval or test uses single solves. Runs are independent: the interval is the 95 % Wilson interval of "
         "the share of complete runs in which every point reaches the tolerance.";
}

std::string log_rank_note(Trials trials, const Groups& groups) {
  if (trials != Trials::solves) return "";
  Groups present;
  std::ranges::copy_if(groups, std::back_inserter(present), [](const auto& group) { return !group.empty(); });
  const LogRank test = log_rank(present);
  if (!test.undefined.empty()) return fmt::format("Log-rank test of all solvers: not defined ({}).", test.undefined);
  return fmt::format(
      "Log-rank test of equal cost: chi-squared {}, df {}, p {}. It treats the solvers as independent samples and "
      "ignores that they share targets.",
      rounded_number(test.chi_squared, 5), test.df, readable(PValue{test.p}));
}

Table cost_table(const StudyResults& study, Cost cost) {
  const bool in_seconds = cost == Cost::seconds;
  const std::string_view unit = in_seconds ? "seconds" : "evaluations";
  const std::string tolerance = rounded_number(tolerance_cm(study), 3);
  Table table{.name = in_seconds ? "statistics-cost-seconds" : "statistics-cost",
              .caption = fmt::format("Cost [{}] until the position error is {} cm", unit, tolerance),
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
                          {"sp1"},
                          {"median"},
                          {"restricted_mean"}}};
  const Groups groups = censored_costs(study, cost);
  const std::vector<Solves> solves = solves_by_solver(study);
  const Trials trials = trials_of(study);
  std::vector<SurvivalCurve> curves;
  for (const auto& group : groups) curves.push_back(kaplan_meier(group));
  const double horizon = common_horizon(curves);
  std::vector<std::string> undefined;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const RunningTime time = running_time(groups[i]);
    const Successes reached{.successes = static_cast<int>(std::ranges::count_if(groups[i], &CensoredCost::reached)),
                            .trials = static_cast<int>(groups[i].size())};
    std::vector<Cell> cells{study.solvers[i]};
    if (trials == Trials::runs) {
      cells.insert(cells.end(), {std::int64_t{reached.trials}, std::int64_t{reached.successes}, Cell(), Cell()});
      const Successes runs = runs_reached(solves[i], study);
      append(cells, runs, wilson(runs));
    } else {
      append(cells, reached, share_reached(solves[i], study));
      cells.resize(cells.size() + 4);
    }
    cells.insert(cells.end(), {time.expected, time.sp1, curves[i].median, restricted_mean(curves[i], horizon).mean});
    table.rows.push_back(std::move(cells));
    const std::string& reason = time.undefined.empty() ? curves[i].undefined : time.undefined;
    if (!reason.empty()) undefined.push_back(fmt::format("{}: {}", study.solvers[i], reason));
  }
  table.notes.push_back(
      fmt::format("A solve reaches the tolerance if the verifier's error is at most {} cm, inside the joint limits or "
                  "not. ert: cost of all solves divided by the number of successful ones. sp1: mean cost of the "
                  "successful solves divided by their share.",
                  tolerance));
  table.notes.push_back(
      fmt::format("The Kaplan-Meier curve assumes that unsuccessful solves would have continued as the others did. "
                  "median: the first cost at which half have reached the tolerance, not defined if they never do. "
                  "restricted_mean: the mean up to {} {}, to which the curves of all solvers are known.",
                  rounded_number(horizon, 6), unit));
  const auto diverged = std::ranges::count(study.solves, StopReason::not_finite, &SolveRecord::stop_reason);
  if (diverged > 0) {
    table.notes.push_back(
        fmt::format("Solves that ended with an error that is not finite: {}. They would not have continued, so median "
                    "and restricted_mean flatter their solvers.",
                    diverged));
  }
  table.notes.push_back(dependence_note(trials));
  if (std::string note = log_rank_note(trials, groups); !note.empty()) table.notes.push_back(std::move(note));
  for (const std::string& reason : undefined) table.notes.push_back(fmt::format("Not defined for {}.", reason));
  for (std::string& note : status_notes(study)) table.notes.push_back(std::move(note));
  return table;
}

}  // namespace

std::vector<Table> cost_tables(const StudyResults& study) {
  if (is_empty_of_costs(study)) return {};
  std::vector<Table> tables{cost_table(study, Cost::evaluations)};
  if (times_are_comparable(study)) tables.push_back(cost_table(study, Cost::seconds));
  return tables;
}

}  // namespace ikbench::report
