#include "analysis/inference/metrics.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "analysis/inference/run_metrics.hpp"
#include "analysis/inference/study.hpp"
#include "numerics/units.hpp"

namespace ikbench::inference {

namespace {

constexpr double rounding_deg = 1e-9 / numerics::degree;

constexpr std::array infos{
#define METRIC(column, slug, name, unit, better, kind, rounding, shown, value)                               \
  MetricInfo{column,                                                                                         \
             slug,                                                                                           \
             name,                                                                                           \
             unit,                                                                                           \
             Better::better,                                                                                 \
             Kind::kind,                                                                                     \
             rounding,                                                                                       \
             ShownIn::shown,                                                                                 \
             [](const Solve& solve, [[maybe_unused]] const StudyResults& study) -> double { return value; }, \
             nullptr},
#define RUN_METRIC(column, slug, name, unit, better, kind, rounding, shown, value) \
  MetricInfo{column,         slug,                                                 \
             name,           unit,                                                 \
             Better::better, Kind::kind,                                           \
             rounding,       ShownIn::shown,                                       \
             nullptr,        [](Run run, [[maybe_unused]] const StudyResults& study) -> double { return value; }},
#include "analysis/inference/metrics.inc"
#undef METRIC
#undef RUN_METRIC
};

constexpr const MetricInfo& row(Metric metric) { return infos.at(static_cast<std::size_t>(metric)); }
static_assert(row(Metric::position_error_cm).column == "position_error_cm");
static_assert(row(Metric::variation_deg).column == "variation_deg");
static_assert(row(Metric::seconds).column == "seconds");
static_assert(row(Metric::evaluations).column == "evaluations");
static_assert(row(Metric::solved).column == "solved");
static_assert(row(Metric::instructions).column == "instructions");
static_assert(row(Metric::orientation_error_deg).column == "orientation_error_deg");
static_assert(row(Metric::variation_m).column == "variation_m");
static_assert(row(Metric::excess_error_cm).column == "excess_error_cm");

// Metrics of the table with one of these values of `shown`.
std::vector<Metric> metrics_shown(std::initializer_list<ShownIn> ways) {
  std::vector<Metric> metrics = all_metrics();
  std::erase_if(metrics, [&](Metric metric) { return std::ranges::find(ways, row(metric).shown) == ways.end(); });
  return metrics;
}

}  // namespace

const MetricInfo& info_of(Metric metric) { return row(metric); }

std::string_view name_of(Metric metric) { return row(metric).column; }

NameWithUnit with_unit(Metric metric) { return {std::string(row(metric).name), std::string(row(metric).unit)}; }

std::string quantity(Metric metric) { return text_of(with_unit(metric)); }

bool is_of_run(Metric metric) { return row(metric).of_run != nullptr; }

bool is_error(Metric metric) {
  return metric == Metric::position_error_cm || metric == Metric::orientation_error_deg ||
         metric == Metric::excess_error_cm;
}

bool is_cost(Metric metric) {
  return !is_error(metric) && row(metric).better == Better::smaller && row(metric).kind != Kind::share &&
         row(metric).shown != ShownIn::if_named;
}

double value_of(const StudyResults& study, const Solve& solve, Metric metric) {
  if (!is_of_run(metric)) return row(metric).value(solve, study);
  const Solve* const alone = &solve;
  return row(metric).of_run(Run(&alone, 1), study);
}

double value_of(const StudyResults& study, Run run, Metric metric) {
  if (is_of_run(metric)) return row(metric).of_run(run, study);
  std::vector<double> values;
  for (const Solve* solve : run) values.push_back(row(metric).value(*solve, study));
  return average_of(metric)(values);
}

std::vector<Metric> all_metrics() {
  std::vector<Metric> metrics;
  for (std::size_t i = 0; i < infos.size(); ++i) metrics.push_back(Metric{i});
  return metrics;
}

std::vector<Metric> reported_metrics() { return metrics_shown({ShownIn::everywhere}); }

std::vector<Metric> compared_metrics() {
  std::vector<Metric> metrics = metrics_shown({ShownIn::everywhere, ShownIn::in_comparisons});
  std::ranges::stable_sort(metrics, {}, [](Metric metric) { return row(metric).kind; });
  return metrics;
}

}  // namespace ikbench::inference
