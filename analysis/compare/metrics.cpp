#include <array>

#include "analysis/compare/describe.hpp"
#include "analysis/compare/observe.hpp"
#include "numerics/names.hpp"
#include "numerics/units.hpp"

namespace ikbench::compare {

namespace {

constexpr double rounding_deg = 1e-9 / numerics::degree;

double of_answer(const Solve& solve, double value) {
  return results::is_without_answer(solve.status) ? unknown : value;
}

constexpr std::array rows{
#define METRIC(column, slug, name, unit, kind, scale, floor, rounding, told, ...) \
  Metric{                                                                         \
      column,     slug,                                                           \
      name,       unit,                                                           \
      Kind::kind, Scale::scale,                                                   \
      floor,      rounding,                                                       \
      Told::told, [](const Solve& solve, [[maybe_unused]] const StudyResults& study) -> double { return __VA_ARGS__; }},
#include "analysis/compare/metrics.inc"
#undef METRIC
};

}  // namespace

std::span<const Metric> metrics() { return rows; }

const Metric& metric_named(std::string_view column) {
  return numerics::find_named("metric", column, rows, [](const Metric& metric) { return metric.column; });
}

}  // namespace ikbench::compare
