#include "analysis/time_assessment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/definition.hpp"
#include "analysis/descriptive.hpp"
#include "analysis/published_numbers.hpp"
#include "analysis/text.hpp"

namespace ikbench {
namespace {

constexpr double verifier_rounding_cm = 1e-7;

struct Assessment {
  std::string solver;
  Description time_ms;     // of all solves
  Description reached_ms;  // of those alone that came to the tolerance
  double iterations_median = not_defined;
  double evaluations_median = not_defined;
  int solves = 0;
  int never_reached = 0;
  int in_real_time = 0;
};

double tolerance_cm(const StudyResults& study) {
  const double tolerance = Definition(study.definition).number("/stop/tolerance_cm");
  return tolerance > 0 ? tolerance : not_defined;
}

std::vector<Assessment> assess(const StudyResults& study) {
  const double tolerance = tolerance_cm(study);
  std::vector<Assessment> rows;
  for (const std::string& solver : study.solvers) {
    Assessment row{.solver = solver};
    std::vector<double> times, times_reached, iterations, evaluations;
    for (const SolveRecord& solve : study.solves) {
      if (solve.solver != solver) continue;
      const double time_ms = 1000 * solve.seconds;
      times.push_back(time_ms);
      iterations.push_back(static_cast<double>(solve.iterations));
      evaluations.push_back(static_cast<double>(solve.evaluations));
      if (time_ms < real_time_ms) ++row.in_real_time;
      if (solve.position_error_cm <= tolerance + verifier_rounding_cm) {
        times_reached.push_back(time_ms);
      } else {
        ++row.never_reached;  // an answer that is not finite too
      }
    }
    row.solves = static_cast<int>(times.size());
    row.time_ms = describe(times);
    row.reached_ms = describe(times_reached);
    row.iterations_median = describe(iterations).median;
    row.evaluations_median = describe(evaluations).median;
    rows.push_back(row);
  }
  return rows;
}

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

std::string verdict(const std::vector<Assessment>& rows, const std::vector<PrintedTime>& printed) {
  int solves = 0, in_real_time = 0;
  const Assessment* worst = nullptr;
  for (const Assessment& row : rows) {
    solves += row.solves;
    in_real_time += row.in_real_time;
    if (row.solves > 0 && (worst == nullptr || !(row.time_ms.max <= worst->time_ms.max))) worst = &row;
  }
  if (worst == nullptr) return "Real time: nothing is solved yet.";
  std::string text = fmt::format("Real time, less than {} ms a solve: ", real_time_ms);
  text += in_real_time == solves
              ? fmt::format("all {} solves", solves)
              : fmt::format("{} of {} solves ({})", in_real_time, solves, listed(rows, [](const Assessment& row) {
                              return fmt::format("{} {} of {}", row.solver, row.in_real_time, row.solves);
                            }));
  text += fmt::format(", the worst {} ms ({}).", rounded_number(worst->time_ms.max, 3), worst->solver);
  const std::string in_the_mean = listed(
      printed, [](const PrintedTime& row) { return row.mean_ms < real_time_ms ? label_of(row) : std::string(); });
  const std::string in_the_worst =
      listed(printed, [](const PrintedTime& row) { return row.max_ms < real_time_ms ? label_of(row) : std::string(); });
  return text + fmt::format(" By the printed times {} would do in the mean, {} in the worst case.",
                            in_the_mean.empty() ? "none" : in_the_mean, in_the_worst.empty() ? "none" : in_the_worst);
}

}  // namespace

std::optional<Table> table_7(const StudyResults& study) {
  if (!is_time_study(study)) return std::nullopt;
  const std::vector<PrintedTime> printed = printed_table_7(study.published);
  const std::vector<Assessment> rows = assess(study);
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
                          {fmt::format("share_under_{}_ms", real_time_ms)},
                          {"paper_mean_ms"},
                          {"paper_median_ms"},
                          {"paper_std_ms"},
                          {"paper_max_ms"},
                          {"paper_min_ms"},
                          {"paper_ratio"}}};
  const std::string reference = label_of(printed.front());
  const auto our_reference = std::ranges::find(rows, reference, &Assessment::solver);
  for (const Assessment& row : rows) {
    const double share = row.solves == 0 ? not_defined : static_cast<double>(row.in_real_time) / row.solves;
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

  table.notes.push_back(verdict(rows, printed));
  double farthest_printed = 0;
  for (const PrintedTime& row : printed) farthest_printed = std::max(farthest_printed, row.max_ms / row.mean_ms);
  table.notes.push_back(fmt::format(
      "One observation is one solve. The times are of all solves, also of those that end without the tolerance "
      "reached: "
      "an arm waits for them too. mean_reached_ms is of the others alone. The paper does not say that there are solves "
      "that never reach it; its longest take at most {} times its mean.",
      rounded_number(farthest_printed, 2)));
  if (std::isfinite(tolerance)) {
    int never = 0;
    for (const Assessment& row : rows) never += row.never_reached;
    table.notes.push_back(
        never == 0 ? "Here every solve reaches it."
                   : fmt::format("Here {} never reach it: {}.", never, listed(rows, [](const Assessment& row) {
                                   return fmt::format("{} {} of {}", row.solver, row.never_reached, row.solves);
                                 })));
  }
  table.notes.push_back(
      fmt::format("The printed times are of MATLAB on another machine: only ratios can be compared. ratio_reached and "
                  "paper_ratio are "
                  "mean times by that of {}, ours of the solves that reach the tolerance.",
                  reference));
  table.notes.push_back(
      fmt::format("Mean time per bat [ms], printed: {}; ours, of the solves that reach the tolerance: {}. Were it the "
                  "same for all, "
                  "the number of iterations would not depend on the number of bats.",
                  listed(printed,
                         [](const PrintedTime& row) {
                           return fmt::format("{} {}", label_of(row), rounded_number(row.mean_ms / row.bats, 3));
                         }),
                  listed(rows, [&](const Assessment& row) {
                    const auto same = std::ranges::find(printed, row.solver, label_of);
                    if (same == printed.end() || !std::isfinite(row.reached_ms.mean)) return std::string();
                    return fmt::format("{} {}", row.solver, rounded_number(row.reached_ms.mean / same->bats, 3));
                  })));
  const std::string misprinted = listed(printed, [](const PrintedTime& row) {
    return row.mean_ms <= row.max_ms ? "" : fmt::format("{} ({} by {})", label_of(row), row.mean_ms, row.max_ms);
  });
  if (!misprinted.empty()) {
    table.notes.push_back(fmt::format("Misprint: the printed mean exceeds the printed maximum: {}.", misprinted));
  }
  for (std::string& note : status_notes(study)) table.notes.push_back(std::move(note));
  if (std::string note = timing_note(study); !note.empty()) table.notes.push_back(std::move(note));
  return table;
}

std::string real_time_verdict(const StudyResults& study) {
  return is_time_study(study) ? verdict(assess(study), printed_table_7(study.published)) : std::string();
}

}  // namespace ikbench
