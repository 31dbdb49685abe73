#include "analysis/compare/metrics.hpp"

#include <array>
#include <stdexcept>
#include <string>

#include "analysis/compare/describe.hpp"
#include "analysis/compare/study.hpp"
#include "numerics/names.hpp"
#include "numerics/units.hpp"
#include "results/orientation.hpp"

namespace ikbench::compare {

namespace {

constexpr double rounding_deg = 1e-9 / numerics::degree;

double of_answer(const Solve& solve, double value) {
  return results::is_without_answer(solve.status) ? unknown : value;
}

constexpr std::array rows{
#define METRIC(column, slug, name, unit, kind, scale, floor, rounding, is_reported, value)              \
  Metric{column,      slug,                                                                             \
         name,        unit,                                                                             \
         Kind::kind,  Scale::scale,                                                                     \
         floor,       rounding,                                                                         \
         is_reported, [](const Solve& solve, [[maybe_unused]] const StudyResults& study) -> double { return value; }, \
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
         [](Run run) -> double { return value; }},
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
