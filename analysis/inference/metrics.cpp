#include "analysis/inference/metrics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace ikbench::inference {

using namespace results;

namespace {

constexpr std::array infos{
#define METRIC(column, slug, name, unit, better, kind, rounding, shown, value) \
  MetricInfo{column,   slug,           name,                                   \
             unit,     Better::better, Kind::kind,                             \
             rounding, Shown::shown,   [](const SolveRecord& solve) -> double { return value; }},
#include "analysis/inference/metrics.inc"
#undef METRIC
};

constexpr const MetricInfo& row(Metric metric) { return infos.at(static_cast<std::size_t>(metric)); }
static_assert(row(Metric::position_error_cm).column == "position_error_cm");
static_assert(row(Metric::variation_deg).column == "variation_deg");
static_assert(row(Metric::seconds).column == "seconds");
static_assert(row(Metric::evaluations).column == "evaluations");

std::vector<Metric> all_metrics() {
  std::vector<Metric> metrics;
  for (std::size_t i = 0; i < infos.size(); ++i) metrics.push_back(Metric{i});
  return metrics;
}

}  // namespace

const MetricInfo& info_of(Metric metric) { return row(metric); }

std::string_view name_of(Metric metric) { return row(metric).column; }

std::string quantity(Metric metric) {
  const MetricInfo& info = row(metric);
  return info.unit.empty() ? std::string(info.name) : fmt::format("{} [{}]", info.name, info.unit);
}

double value_of(const SolveRecord& solve, Metric metric) { return row(metric).value(solve); }

std::vector<Metric> reported_metrics() {
  std::vector<Metric> metrics = all_metrics();
  std::erase_if(metrics, [](Metric metric) { return row(metric).shown == Shown::in_comparisons; });
  return metrics;
}

std::vector<Metric> compared_metrics() {
  std::vector<Metric> metrics = all_metrics();
  std::ranges::stable_sort(metrics, {}, [](Metric metric) { return row(metric).kind; });
  return metrics;
}

}  // namespace ikbench::inference
