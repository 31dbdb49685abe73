#include <array>
#include <cmath>

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

// Of the record's orientation_error, ||R - Rd|| / ||Rd||: for two rotations ||R - Rd|| is sqrt(8) sin(angle / 2), and
// ||Rd|| is sqrt(3). NaN stays NaN.
double orientation_angle_deg(double orientation_error) {
  const double sine = orientation_error * std::sqrt(3.0 / 8);
  return 2 * std::asin(sine > 1 ? 1.0 : sine) / numerics::degree;
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
