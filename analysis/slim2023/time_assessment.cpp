#include "analysis/slim2023/time_assessment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/claims/times.hpp"
#include "analysis/inference/clusters.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/cost_comparison.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/inference/times.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/effect_size.hpp"
#include "numerics/number.hpp"

namespace ikbench::slim2023 {

using namespace numerics;
using namespace claims;
using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

constexpr double ms_in_s = 1000;

double bats_of(const PrintedTime& printed) {
  return number_from(printed.solver.substr(0, printed.solver.find(' '))).value();
}

template <class Row, class Text>
std::string listed(const std::vector<Row>& rows, Text&& text) {
  std::string list;
  for (const Row& row : rows) {
    const std::string item = text(row);
    if (!item.empty()) list += (list.empty() ? "" : ", ") + item;
  }
  return list;
}

bool is_time_study(const StudyResults& study) {
  return study.facts.path == "random" && !printed_table_7(study.facts.published).empty();
}

std::string verdict(const std::vector<TimeAssessment>& rows, double tolerance,
                    const std::vector<PrintedTime>& printed) {
  int solves = 0, in_time = 0;
  const TimeAssessment* worst = nullptr;
  for (const TimeAssessment& row : rows) {
    solves += row.solves;
    in_time += row.in_time;
    if (row.solves > 0 && (worst == nullptr || !(row.time_ms.max <= worst->time_ms.max))) worst = &row;
  }
  if (worst == nullptr) return "Real time: there are no solves yet.";
  std::string text = fmt::format(
      "Real time here, {} less than {} ms: ",
      std::isfinite(tolerance) ? fmt::format("{} cm reached in", tolerance) : "although the study has no tolerance, in",
      real_time_ms);
  text += in_time == solves ? fmt::format("all {} solves", solves)
                            : fmt::format("{} of {} solves ({})", in_time, solves, listed(rows, [](const auto& row) {
                                            return fmt::format("{} {} of {}", row.solver, row.in_time, row.solves);
                                          }));
  return text + fmt::format("; the longest solve took {} ms ({}). Printed times, in MATLAB on another machine: {}.",
                            rounded_number(worst->time_ms.max, 3), worst->solver,
                            printed_words(printed.front(), real_time_ms));
}

// The place of a solver; nothing if it has no solves.
std::optional<std::size_t> place_of(const StudyResults& study, const std::string& solver) {
  const auto found = std::ranges::find(study.solvers, solver);
  if (found == study.solvers.end()) return std::nullopt;
  return static_cast<std::size_t>(found - study.solvers.begin());
}

// The cost of the tolerance in seconds for each solver of a study.
struct TimeCosts {
  const Clusters& clusters;
  std::vector<SolverCost> solvers;
  std::vector<Finding> pairs;

  Finding ratio(const std::string& solver, const std::string& reference) const {
    return finding_of(pairs, expected_name(Metric::seconds), solver, reference);
  }
};

// The ratio of the last printed row's time to the first's, and the standard error of its logarithm.
struct Growth {
  double ratio;
  double standard_error_of_log;
};

Growth printed_growth(const std::vector<PrintedTime>& printed) {
  const auto relative_variance = [](const Description& ms) { return std::pow(ms.std / ms.mean, 2) / ms.n; };
  return {printed.back().ms.mean / printed.front().ms.mean,
          std::sqrt(relative_variance(printed.front().ms) + relative_variance(printed.back().ms))};
}

// Compares the last solver with the first.
std::string scaling_answer(const Finding& ours, double standard_error_of_log, const Growth& theirs,
                           const AnalysisPlan& plan) {
  const Judgement more = judge(std::log(ours.estimate.value / theirs.ratio),
                               std::hypot(standard_error_of_log, theirs.standard_error_of_log), plan);
  return !is_difference(more.relation) && more.relation != Relation::same ? "is compatible with the printed growth"
         : more.relation == Relation::better                              ? "grows more than printed"
         : ours.relation == Relation::worse                               ? "grows, but less than printed"
                                                                          : "does not grow as printed";
}

double standard_error_of_log_ratio(const SolverCost& first, const SolverCost& second) {
  std::vector<double> logarithms;
  for (std::size_t b = 0; b < first.replicates.size(); ++b) {
    logarithms.push_back(std::log(first.replicates[b].expected() / second.replicates[b].expected()));
  }
  return standard_deviation(logarithms);
}

// Says whether our time grows with the number of bats as the printed one does; empty if either end has no solves.
std::string scaling_verdict(const StudyResults& study, const std::vector<TimeAssessment>& rows,
                            const std::vector<PrintedTime>& printed, const TimeCosts& of) {
  const auto first = place_of(study, printed.front().solver), last = place_of(study, printed.back().solver);
  if (!first || !last || first == last || rows[*first].solves == 0 || rows[*last].solves == 0) return "";
  if (!of.clusters.undefined().empty()) return fmt::format("Scaling: open, with {}.", of.clusters.undefined());
  const Finding ours = of.ratio(rows[*last].solver, rows[*first].solver);
  if (std::isnan(ours.estimate.low)) return "Scaling: open, because too few solves reach the tolerance.";
  const Growth theirs = printed_growth(printed);
  return fmt::format(
      "Scaling: our expected running time {}: {} times (interval {} to {}) from {} to {}; printed means: {} times "
      "(standard error {}). Solves that reach the tolerance alone, as the paper counts: {} times; that leaves out what "
      "the others cost. Median iterations of these solves: {} -> {}. These are {} and {} solves; --set "
      "path.points=2000 gives more.",
      scaling_answer(ours, standard_error_of_log_ratio(of.solvers[*last], of.solvers[*first]), theirs, study.plan),
      rounded_number(ours.estimate.value, 3), rounded_number(ours.estimate.low, 3),
      rounded_number(ours.estimate.high, 3), rows[*first].solver, rows[*last].solver, rounded_number(theirs.ratio, 3),
      rounded_number(theirs.ratio * theirs.standard_error_of_log, 2),
      short_number(rows[*last].reached_ms.mean / rows[*first].reached_ms.mean), rows[*first].iterations_reached_median,
      rows[*last].iterations_reached_median, rows[*first].reached_ms.n, rows[*last].reached_ms.n);
}

std::vector<Cell> table_7_row(const TimeAssessment& row, const std::vector<PrintedTime>& printed, double tolerance) {
  const bool is_judged = row.solves > 0 && std::isfinite(tolerance);
  std::vector<Cell> cells{row.solver, std::int64_t{row.solves},
                          std::isfinite(tolerance) ? Cell(std::int64_t{row.never_reached}) : Cell(),
                          is_judged ? static_cast<double>(row.in_time) / row.solves : not_defined};
  const auto same = std::ranges::find(printed, row.solver, &PrintedTime::solver);
  for (const auto field :
       {&Description::mean, &Description::median, &Description::std, &Description::max, &Description::min}) {
    const double ours = row.time_ms.*field;
    cells.push_back(same == printed.end() ? Cell(ours)
                                          : Cell(Beside{.ours = ours, .printed = text_of(same->ms.*field)}));
  }
  cells.insert(cells.end(), {row.iterations_median, row.evaluations_median});
  return cells;
}

std::vector<std::string> table_7_notes(const StudyResults& study, const std::vector<TimeAssessment>& rows,
                                       const std::vector<PrintedTime>& printed) {
  std::vector<std::string> notes{real_time_verdict(study)};
  double farthest_printed = 0;
  for (const PrintedTime& row : printed) farthest_printed = std::max(farthest_printed, row.ms.max / row.ms.mean);
  notes.push_back(fmt::format(
      "One observation is one solve. {} They include solves that do not reach the tolerance, because an arm "
      "waits for them too; share_in_time counts solves that reach the tolerance in less than {} ms. The "
      "paper does not mention solves that never reach it; its longest solves take at most {} times the "
      "mean.",
      median_speed_words, real_time_ms, rounded_number(farthest_printed, 2)));
  if (std::isfinite(tolerance_cm(study))) {
    int never = 0;
    for (const TimeAssessment& row : rows) never += row.never_reached;
    notes.push_back(
        never == 0
            ? "Here every solve reaches the tolerance."
            : fmt::format("Here {} never reach the tolerance: {}.", never, listed(rows, [](const TimeAssessment& row) {
                            return fmt::format("{} {} of {}", row.solver, row.never_reached, row.solves);
                          })));
  }
  notes.push_back(fmt::format("Mean time per bat [ms], printed: {}.", listed(printed, [](const PrintedTime& row) {
                                return fmt::format("{} {}", row.solver, rounded_number(row.ms.mean / bats_of(row), 3));
                              })));
  std::ranges::move(list_of(times_doubts(study) + outlier_doubts(study)), std::back_inserter(notes));
  const std::string misprinted = listed(printed, [](const PrintedTime& row) {
    return row.ms.mean <= row.ms.max ? "" : fmt::format("{} ({} by {})", row.solver, row.ms.mean, row.ms.max);
  });
  if (!misprinted.empty()) {
    notes.push_back(fmt::format("Misprint: the printed mean exceeds the printed maximum: {}.", misprinted));
  }
  std::ranges::move(status_notes(study), std::back_inserter(notes));
  return notes;
}

Cell range_of(double low, double high) { return std::isnan(low) ? Cell() : Cell(Range{low, high}); }

std::vector<double> times_ms_of(const StudyResults& study, const std::string& solver) {
  std::vector<double> times;
  for (const Solve& solve : solves_of(study, solver)) times.push_back(ms_in_s * seconds_of(study, solve));
  return times;
}

// The measured chance that a solve of the second takes longer than one of the first.
double chance_to_take_longer(const StudyResults& study, const std::string& first, const std::string& second) {
  return vargha_delaney(times_ms_of(study, second), times_ms_of(study, first), 1 - study.plan.significance).value;
}

std::vector<std::string> cost_notes(const StudyResults& study, const std::vector<TimeAssessment>& rows,
                                    const std::vector<PrintedTime>& printed, const TimeCosts& of) {
  std::vector<std::string> notes;
  if (std::string scaling = scaling_verdict(study, rows, printed, of); !scaling.empty()) {
    notes.push_back(std::move(scaling));
  }
  notes.push_back(fmt::format(
      "ert_ms: time of all solves divided by the number that reach the tolerance, inside the joint limits or not. The printed times come from MATLAB on "
      "another machine, so only ratios are comparable; all are to {}. ratio_reached, of the mean times of solves that "
      "reach the tolerance, and paper_ratio are the paper's way; they leave out what unsuccessful solves cost, so they "
      "decide nothing.",
      printed.front().solver));
  notes.push_back(
      of.clusters.undefined().empty()
          ? fmt::format("Intervals: {}, from {} bootstrap samples of the {}, the same for all solvers; those "
                        "of ratios hold for all pairs together.",
                        percent(of.clusters.level()), of.clusters.replicates().size(), of.clusters.noun())
          : fmt::format("There are no intervals: {}.", of.clusters.undefined()));
  const std::string per_bat = listed(printed, [&](const PrintedTime& row) {
    const auto place = place_of(study, row.solver);
    const double ms = place ? ms_in_s * of.solvers[*place].time.expected() : not_defined;
    return std::isfinite(ms) ? fmt::format("{} {}", row.solver, rounded_number(ms / bats_of(row), 3)) : std::string();
  });
  notes.push_back(
      fmt::format("ert_ms per bat: {}. If it were constant, the number of iterations would not depend on "
                  "the number of bats.",
                  per_bat));
  return notes;
}

}  // namespace

std::optional<Table> table_7(const StudyResults& study) {
  if (!is_time_study(study)) return std::nullopt;
  const std::vector<PrintedTime> printed = printed_table_7(study.facts.published);
  const std::vector<TimeAssessment> rows = assess_times(study, real_time_ms);
  const double tolerance = tolerance_cm(study);
  Table table{.name = "table-7",
              .caption = std::isfinite(tolerance)
                             ? fmt::format("computing time [ms] until the position error is {} cm", tolerance)
                             : "computing time [ms]",
              .columns = {"configuration", "solves", "never_reached", "share_in_time", "mean_ms", "median_ms", "std_ms",
                          "max_ms", "min_ms", "iterations_median", "evaluations_median"},
              .number = 7};
  for (const TimeAssessment& row : rows) table.rows.push_back(table_7_row(row, printed, tolerance));
  table.notes = table_7_notes(study, rows, printed);
  return table;
}

std::optional<Table> table_7_cost(const StudyResults& measured) {
  const bool has_costs =
      std::isfinite(tolerance_cm(measured)) && times_are_comparable(measured) && !measured.solves.empty();
  if (!is_time_study(measured) || !has_costs) return std::nullopt;
  const StudyResults study = at_median_speed(measured);
  const std::vector<PrintedTime> printed = printed_table_7(study.facts.published);
  const std::vector<TimeAssessment> rows = assess_times(measured, real_time_ms);
  const Clusters clusters(study);
  const auto reaches = [most = most_error_cm(study)](const Solve& solve) { return solve.position_error_cm <= most; };
  const TimeCosts of{clusters, costs_of(study, Metric::seconds, clusters, reaches),
                     compare_costs(study, Metric::seconds, clusters, reaches)};
  Table table{
      .name = "table-7-cost",
      .caption = fmt::format("what {} cm costs in time [ms], unsuccessful solves included", tolerance_cm(study)),
      .columns = {"configuration", "ert_ms", "ert_ms interval", "ert_ratio", "ert_ratio interval", "median_ratio",
                  "A12", "mean_reached_ms", "ratio_reached", "paper_ratio"},
      .number = 7};
  const auto reference = place_of(study, printed.front().solver);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const SolverCost& cost = of.solvers[i];
    const Interval interval = cost.interval(clusters);
    Estimate ratio;
    if (reference == i) ratio.value = 1;
    if (reference && reference != i) ratio = of.ratio(rows[i].solver, rows[*reference].solver).estimate;
    std::vector<Cell> cells{rows[i].solver, ms_in_s * cost.time.expected(),
                            range_of(ms_in_s * interval.low, ms_in_s * interval.high), ratio.value,
                            range_of(ratio.low, ratio.high)};
    cells.emplace_back(reference ? rows[i].time_ms.median / rows[*reference].time_ms.median : not_defined);
    cells.emplace_back(reference ? chance_to_take_longer(measured, rows[*reference].solver, rows[i].solver)
                                 : not_defined);
    cells.emplace_back(rows[i].reached_ms.mean);
    cells.emplace_back(reference ? rows[i].reached_ms.mean / rows[*reference].reached_ms.mean : not_defined);
    const auto same = std::ranges::find(printed, rows[i].solver, &PrintedTime::solver);
    cells.push_back(same != printed.end() ? Cell(same->ms.mean / printed.front().ms.mean) : Cell());
    table.rows.push_back(std::move(cells));
  }
  table.notes = cost_notes(study, rows, printed, of);
  table.notes.push_back(fmt::format(
      "{} A12: the chance that a solve takes longer than one of the first configuration, by the measured times.",
      median_speed_words));
  return table;
}

std::string real_time_verdict(const StudyResults& study) {
  if (!is_time_study(study)) return "";
  if (!times_are_comparable(study)) return fmt::format("Real time: not judged, because {}.", times_not_judged);
  return verdict(assess_times(study, real_time_ms), tolerance_cm(study), printed_table_7(study.facts.published));
}

}  // namespace ikbench::slim2023
