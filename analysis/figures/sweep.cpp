#include "analysis/figures/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "analysis/figures/of_study.hpp"
#include "analysis/judge/statistics/descriptives.hpp"
#include "analysis/judge/statistics/two_sample_tests.hpp"

namespace ikbench::figures {

using namespace judge;

namespace {

constexpr double confidence = 0.95;

// Returns the share of targets that a solver solved [%], with its interval; NaN if the study has no such share.
CurveRow solved_row(const SweptValue& swept, const std::string& solver) {
  CurveRow row{.x = swept.value, .y = nowhere};
  for (const JudgedMetric& metric : swept.judged->metrics) {
    if (metric.samples.quantity_kind != QuantityKind::solved) continue;
    const std::size_t group = index_of(metric.samples, solver);
    if (group == metric.samples.groups.size() || metric.descriptives[group].n == 0) continue;
    row.y = 100 * metric.descriptives[group].mean;
    if (is_deterministic(metric.samples.groups[group]) || !metric.samples.is_random) continue;
    const Interval interval = wilson_interval(
        {.share = metric.descriptives[group].mean, .n = static_cast<double>(metric.descriptives[group].n)},
        1 - confidence);
    row.low = 100 * interval.low;
    row.high = 100 * interval.high;
  }
  return row;
}

// Returns the median time of the solves that solved their target [ms], with its interval; NaN if there are none, or if
// the solver's times are not compared in the study. Solves that missed are left out: a solver that ends early without
// an answer is not fast.
CurveRow time_row(const SweptValue& swept, const std::string& solver) {
  CurveRow row{.x = swept.value, .y = nowhere};
  const std::vector<std::string> not_compared = not_compared_in_time(*swept.judged);
  if (std::ranges::count(not_compared, solver) > 0) return row;
  std::vector<double> times;
  for (const SolveSummary& solve : swept.judged->study.of(solver))
    if (solve.status == results::Status::ok && std::isfinite(solve.seconds)) times.push_back(1000 * solve.seconds);
  if (times.empty()) return row;
  std::ranges::sort(times);
  row.y = quantile(times, 0.5);
  if (const std::optional<Interval> interval = quantile_interval(times, 0.5)) {
    row.low = interval->low;
    row.high = interval->high;
  }
  return row;
}

// Returns a line per solver of the rows that `row_of` makes.
std::vector<Line> lines_of(const std::vector<SweptValue>& values, const Look& look, auto row_of) {
  std::vector<Line> lines;
  for (const std::string& solver : look.style.solvers) {
    Line& line = lines.emplace_back(Line{.label = look.names.at(solver), .style = look.lines.at(solver)});
    for (const SweptValue& value : values) line.rows.push_back(row_of(value, solver));
  }
  return lines;
}

}  // namespace

std::vector<Figure> of_sweep(const std::vector<SweptValue>& values, const std::string& key, const Look& look) {
  const About solved{.name = "sweep-solved",
                     .caption = fmt::format("Targets solved at each value of {}.", key),
                     .quantity = "targets solved",
                     .unit = "%",
                     .is_share = true};
  const About times{
      .name = "sweep-time",
      .caption = fmt::format(
          "Median time of the solves that solved their target, at each value of {}. No point: none did, or times are not compared.",
          key),
      .quantity = "time",
      .unit = "ms"};
  std::vector<Figure> figures;
  const CurveAxis axis{.title = key, .has_bars = true, .may_be_logarithmic = true};
  for (std::optional<Figure> figure : {curves(solved, axis, lines_of(values, look, solved_row)),
                                       curves(times, axis, lines_of(values, look, time_row))})
    if (figure) figures.push_back(std::move(*figure));
  return figures;
}

}  // namespace ikbench::figures
