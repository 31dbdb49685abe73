#include "analysis/slim2023/time_assessment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/claims/times.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/inference/times.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "numerics/number.hpp"

namespace ikbench::slim2023 {

using namespace numerics;
using namespace claims;
using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

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
                                          : Cell(OursAndPrinted{.ours = ours, .printed = text_of(same->ms.*field)}));
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

std::string real_time_verdict(const StudyResults& study) {
  if (!is_time_study(study)) return "";
  if (!times_are_comparable(study)) return fmt::format("Real time: not judged, because {}.", times_not_judged);
  return verdict(assess_times(study, real_time_ms), tolerance_cm(study), printed_table_7(study.facts.published));
}

}  // namespace ikbench::slim2023
