#include "analysis/compare/metrics.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "analysis/compare/study.hpp"
#include "numerics/names.hpp"
#include "numerics/units.hpp"
#include "results/orientation.hpp"

namespace ikbench::compare {

using results::SolveRecord;

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double rounding_deg = 1e-9 / numerics::degree;

double of_answer(const SolveRecord& solve, double value) {
  return results::is_without_answer(solve.status) ? none : value;
}

// Mean absolute second difference of all joint angles.
double bend_deg(Run run) {
  double sum = 0, count = 0;
  for (std::size_t k = 1; k + 1 < run.size(); ++k) {
    const std::vector<double>&before = run[k - 1].answer_rad, &here = run[k].answer_rad, &after = run[k + 1].answer_rad;
    if (before.size() != here.size() || after.size() != here.size()) return none;
    for (std::size_t joint = 0; joint < here.size(); ++joint, ++count)
      sum += std::abs(before[joint] - 2 * here[joint] + after[joint]) / numerics::degree;
  }
  return count > 0 ? sum / count : none;
}

constexpr std::array rows{
#define METRIC(column, slug, name, unit, kind, scale, floor, rounding, is_reported, value)                 \
  Metric{                                                                                                  \
      column,      slug,                                                                                   \
      name,        unit,                                                                                   \
      Kind::kind,  Scale::scale,                                                                           \
      floor,       rounding,                                                                               \
      is_reported, [](const SolveRecord& solve, [[maybe_unused]] const StudyResults& study) -> double { return value; }, \
      nullptr},
#define RUN_METRIC(column, slug, name, unit, kind, scale, floor, rounding, is_reported, value) \
  Metric{column,                                                                               \
         slug,                                                                                 \
         name,                                                                                 \
         unit,                                                                                 \
         Kind::kind,                                                                           \
         Scale::scale,                                                                         \
         floor,                                                                                \
         rounding,                                                                             \
         is_reported,                                                                          \
         nullptr,                                                                              \
         [](Run run, const StudyResults&) -> double { return value; }},
#include "analysis/compare/metrics.inc"
#undef METRIC
#undef RUN_METRIC
};

}  // namespace

std::span<const Metric> metrics() { return rows; }

const Metric& metric_named(std::string_view column) {
  std::vector<std::string> known;
  for (const Metric& metric : rows) {
    if (metric.column == column) return metric;
    known.emplace_back(metric.column);
  }
  throw std::invalid_argument(numerics::unknown_name("metric", column, known));
}

}  // namespace ikbench::compare
