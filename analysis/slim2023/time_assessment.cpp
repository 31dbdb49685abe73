#include "analysis/slim2023/time_assessment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/inference/definition.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "results/published.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

constexpr double verifier_rounding_cm = 1e-7;

std::string label_of(const PrintedTime& printed) { return fmt::format("{} bats", printed.bats); }

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
  return Definition(study.definition).text("/path/kind") == "random" && !printed_table_7(study.published).empty();
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
                            rounded_number(worst->time_ms.max, 3), worst->solver, printed_real_time(printed.front()));
}

// How many times as long the last row takes as the first, and the squared standard error of its logarithm.
struct Growth {
  double ratio;
  double relative_variance;
};

Growth growth_of(const GroupSummary& first, const GroupSummary& last) {
  const auto relative = [](const GroupSummary& of) { return of.std * of.std / (of.n * of.mean * of.mean); };
  return {last.mean / first.mean, relative(first) + relative(last)};
}

std::string with_error(const Growth& growth) {
  return fmt::format("{} times (standard error {})", rounded_number(growth.ratio, 3),
                     rounded_number(growth.ratio * std::sqrt(growth.relative_variance), 2));
}

// Whether our time grows with the number of bats as the printed does; empty where either end has no two solves.
std::string scaling_verdict(const StudyResults& study, const std::vector<TimeAssessment>& rows,
                            const std::vector<PrintedTime>& printed) {
  const auto first = std::ranges::find(rows, label_of(printed.front()), &TimeAssessment::solver);
  const auto last = std::ranges::find(rows, label_of(printed.back()), &TimeAssessment::solver);
  if (first == rows.end() || last == rows.end() || first == last || !times_are_comparable(study)) return "";
  const auto ours_of = [](const TimeAssessment& row) {
    return GroupSummary{.mean = row.reached_ms.mean, .std = row.reached_ms.std, .n = row.reached_ms.n};
  };
  const CsvTable table = published::table(study.published, "table-7");
  const auto printed_of = [&](const PrintedTime& row, std::size_t index) {
    return GroupSummary{.mean = row.mean_ms, .std = row.std_ms, .n = static_cast<int>(table.number(index, "n"))};
  };
  const Growth ours = growth_of(ours_of(*first), ours_of(*last));
  const Growth theirs = growth_of(printed_of(printed.front(), 0), printed_of(printed.back(), printed.size() - 1));
  const Judgement more = judge(std::log(ours.ratio / theirs.ratio),
                               std::sqrt(ours.relative_variance + theirs.relative_variance), study.plan);
  if (!more.undefined.empty()) return "";
  const Judgement grows = judge(std::log(ours.ratio), std::sqrt(ours.relative_variance), study.plan);
  const std::string answer = more.answer == Answer::undecided ? "is compatible with the printed growth"
                             : more.answer == Answer::better  ? "grows more than printed"
                             : grows.answer == Answer::better ? "grows, but less than printed"
                                                              : "does not grow as printed";
  return fmt::format(
      "Scaling: our mean time of solves that reach the tolerance {}: {} from {} to {}; printed: {}. Median iterations "
      "of these solves: {} -> {}. These are only {} and {} solves; --set path.points=2000 gives more.",
      answer, with_error(ours), first->solver, last->solver, with_error(theirs), first->iterations_reached_median,
      last->iterations_reached_median, first->reached_ms.n, last->reached_ms.n);
}

}  // namespace

std::vector<TimeAssessment> assess_times(const StudyResults& study) {
  const double tolerance = tolerance_cm(study);
  std::vector<TimeAssessment> rows;
  for (const std::string& solver : study.solvers) {
    TimeAssessment row{.solver = solver};
    std::vector<double> times, times_reached, iterations, iterations_reached, evaluations;
    for (const SolveRecord& solve : study.solves) {
      if (solve.solver != solver) continue;
      const double time_ms = 1000 * solve.seconds;
      times.push_back(time_ms);
      iterations.push_back(static_cast<double>(solve.iterations));
      evaluations.push_back(static_cast<double>(solve.evaluations));
      if (solve.position_error_cm <= tolerance + verifier_rounding_cm) {
        times_reached.push_back(time_ms);
        iterations_reached.push_back(static_cast<double>(solve.iterations));
        if (time_ms < real_time_ms) ++row.in_time;
      } else {
        ++row.never_reached;  // an answer that is not finite too
      }
    }
    row.solves = static_cast<int>(times.size());
    row.time_ms = describe(times);
    row.reached_ms = describe(times_reached);
    row.iterations_median = describe(iterations).median;
    row.iterations_reached_median = describe(iterations_reached).median;
    row.evaluations_median = describe(evaluations).median;
    rows.push_back(row);
  }
  return rows;
}

std::string printed_real_time(const PrintedTime& printed) {
  const bool in_the_mean = printed.mean_ms < real_time_ms, in_the_worst_case = printed.max_ms < real_time_ms;
  return fmt::format("{}: mean {} ms, maximum {} ms; on average {}, in the worst case {}", label_of(printed),
                     printed.mean_ms, printed.max_ms, in_the_mean ? "yes" : "no", in_the_worst_case ? "yes" : "no");
}

std::optional<Table> table_7(const StudyResults& study) {
  if (!is_time_study(study)) return std::nullopt;
  const std::vector<PrintedTime> printed = printed_table_7(study.published);
  const std::vector<TimeAssessment> rows = assess_times(study);
  const double tolerance = tolerance_cm(study);
  Table table{.name = "table-7",
              .caption = std::isfinite(tolerance)
                             ? fmt::format("Table 7: computing time [ms] until the position error is {} cm", tolerance)
                             : "Table 7: computing time [ms]",
              .columns = {{"entrant", Align::left},
                          {"solves"},
                          {"never_reached"},
                          {"mean_ms"},
                          {"median_ms"},
                          {"std_ms"},
                          {"max_ms"},
                          {"min_ms"},
                          {"mean_reached_ms"},
                          {"ratio_reached"},
                          {"iterations_median"},
                          {"evaluations_median"},
                          {"share_in_time"},
                          {"paper_mean_ms"},
                          {"paper_median_ms"},
                          {"paper_std_ms"},
                          {"paper_max_ms"},
                          {"paper_min_ms"},
                          {"paper_ratio"}}};
  const std::string reference = label_of(printed.front());
  const auto our_reference = std::ranges::find(rows, reference, &TimeAssessment::solver);
  for (const TimeAssessment& row : rows) {
    const double share =
        row.solves == 0 || !std::isfinite(tolerance) ? not_defined : static_cast<double>(row.in_time) / row.solves;
    const double ratio =
        our_reference == rows.end() ? not_defined : row.reached_ms.mean / our_reference->reached_ms.mean;
    std::vector<Cell> cells{row.solver,
                            std::int64_t{row.solves},
                            std::isfinite(tolerance) ? Cell(std::int64_t{row.never_reached}) : Cell(),
                            row.time_ms.mean,
                            row.time_ms.median,
                            row.time_ms.std,
                            row.time_ms.max,
                            row.time_ms.min,
                            row.reached_ms.mean,
                            ratio,
                            row.iterations_median,
                            row.evaluations_median,
                            share};
    const auto same = std::ranges::find(printed, row.solver, label_of);
    if (same != printed.end()) {
      for (const double value : {same->mean_ms, same->median_ms, same->std_ms, same->max_ms, same->min_ms,
                                 same->mean_ms / printed.front().mean_ms}) {
        cells.emplace_back(value);
      }
    }
    cells.resize(table.columns.size());
    table.rows.push_back(std::move(cells));
  }

  table.notes.push_back(real_time_verdict(study));
  if (std::string scaling = scaling_verdict(study, rows, printed); !scaling.empty()) {
    table.notes.push_back(std::move(scaling));
  }
  double farthest_printed = 0;
  for (const PrintedTime& row : printed) farthest_printed = std::max(farthest_printed, row.max_ms / row.mean_ms);
  table.notes.push_back(
      fmt::format("One observation is one solve. Times include solves that do not reach the tolerance, because an arm "
                  "waits for them too. mean_reached_ms covers only those that reach it; share_in_time counts solves "
                  "that reach the tolerance in less than {} ms. The paper does not mention solves that never reach it; "
                  "its longest solves take at most {} times the mean.",
                  real_time_ms, rounded_number(farthest_printed, 2)));
  if (std::isfinite(tolerance)) {
    int never = 0;
    for (const TimeAssessment& row : rows) never += row.never_reached;
    table.notes.push_back(
        never == 0
            ? "Here every solve reaches the tolerance."
            : fmt::format("Here {} never reach the tolerance: {}.", never, listed(rows, [](const TimeAssessment& row) {
                            return fmt::format("{} {} of {}", row.solver, row.never_reached, row.solves);
                          })));
  }
  const std::string printed_per_bat = listed(printed, [](const PrintedTime& row) {
    return fmt::format("{} {}", label_of(row), rounded_number(row.mean_ms / row.bats, 3));
  });
  if (times_are_comparable(study)) {
    table.notes.push_back(fmt::format(
        "The printed times come from MATLAB on another machine, so only ratios are comparable. ratio_reached and "
        "paper_ratio are mean times divided by that of {}; ours only of solves that reach the tolerance.",
        reference));
    table.notes.push_back(
        fmt::format("Mean time per bat [ms], printed: {}; ours, of solves that reach the tolerance: {}. If it were "
                    "constant, the number of iterations would not depend on the number of bats.",
                    printed_per_bat, listed(rows, [&](const TimeAssessment& row) {
                      const auto same = std::ranges::find(printed, row.solver, label_of);
                      if (same == printed.end() || !std::isfinite(row.reached_ms.mean)) return std::string();
                      return fmt::format("{} {}", row.solver, rounded_number(row.reached_ms.mean / same->bats, 3));
                    })));
  } else {
    table.notes.push_back(timing_note(study));
    table.notes.push_back(fmt::format("Mean time per bat [ms], printed: {}.", printed_per_bat));
  }
  const std::string misprinted = listed(printed, [](const PrintedTime& row) {
    return row.mean_ms <= row.max_ms ? "" : fmt::format("{} ({} by {})", label_of(row), row.mean_ms, row.max_ms);
  });
  if (!misprinted.empty()) {
    table.notes.push_back(fmt::format("Misprint: the printed mean exceeds the printed maximum: {}.", misprinted));
  }
  for (std::string& note : status_notes(study)) table.notes.push_back(std::move(note));
  return table;
}

std::string real_time_verdict(const StudyResults& study) {
  if (!is_time_study(study)) return "";
  if (!times_are_comparable(study)) return fmt::format("Real time: not judged, because {}.", times_not_judged);
  return verdict(assess_times(study), tolerance_cm(study), printed_table_7(study.published));
}

}  // namespace ikbench::slim2023
