#include <array>

#include "analysis/judge/describe.hpp"
#include "analysis/judge/observe.hpp"
#include "base/names.hpp"
#include "base/units.hpp"

namespace ikbench::judge {

namespace {

constexpr double rounding_deg = 1e-9 / base::degree;

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
#include "analysis/judge/metrics.inc"
#undef METRIC
};

}  // namespace

std::span<const Metric> metrics() { return rows; }

const Metric& metric_named(std::string_view column) {
  return base::find_named("metric", column, rows, [](const Metric& metric) { return metric.column; });
}

}  // namespace ikbench::judge
