#include "analysis/inference/metrics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "analysis/inference/study.hpp"
#include "numerics/names.hpp"
#include "numerics/units.hpp"
#include "results/orientation.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

constexpr double rounding_deg = 1e-9 / numerics::degree;

// Metrics that are no column of the record. One without meaning in the study is not defined.

double of_answer(const Solve& solve, double value) {
  return results::is_without_answer(solve.status) ? not_defined : value;
}

double orientation_error_deg(const Solve& solve, const StudyResults& study) {
  return study.facts.orientation ? orientation_angle_deg(solve.orientation_error) : not_defined;
}

double variation_m(const Solve& solve) { return solve.rare == nullptr ? 0 : solve.rare->variation_m; }

// Mean absolute second difference of all joints; not defined for a single solve.
double bend_deg(Run run, const StudyResults& study) {
  const std::vector<RunShape>& all = study.solve_data->shapes;
  const auto place = [](const auto& of) { return std::pair(of.solver, of.run); };
  const auto found = std::ranges::lower_bound(all, place(*run.front()), {}, place);
  return found != all.end() && place(*found) == place(*run.front()) ? found->mean_bend_deg : not_defined;
}

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
static_assert(row(Metric::orientation_error_deg).column == "orientation_error_deg");
static_assert(row(Metric::variation_m).column == "variation_m");

// Metrics of the table with one of these values of `shown`.
std::vector<Metric> metrics_shown(std::initializer_list<ShownIn> ways) {
  std::vector<Metric> metrics = all_metrics();
  std::erase_if(metrics, [&](Metric metric) { return std::ranges::find(ways, row(metric).shown) == ways.end(); });
  return metrics;
}

// Returns whether a metric differs between the observations of a study, by more than its rounding.
bool differs(const StudyResults& study, Metric metric) {
  std::vector<double> values;
  for (const Sample& sample : samples(study, metric)) {
    std::ranges::copy_if(sample.values, std::back_inserter(values), [](double value) { return !std::isnan(value); });
  }
  if (values.empty()) return false;
  const auto [least, most] = std::ranges::minmax(values);
  const bool is_none = std::max(std::fabs(least), std::fabs(most)) <= info_of(metric).rounding;
  return !is_none && (values.size() == 1 || least != most);
}

}  // namespace

const MetricInfo& info_of(Metric metric) { return row(metric); }

std::string_view name_of(Metric metric) { return row(metric).column; }

NameWithUnit with_unit(Metric metric) { return {std::string(row(metric).name), std::string(row(metric).unit)}; }

std::string quantity(Metric metric) { return text_of(with_unit(metric)); }

bool is_of_run(Metric metric) { return row(metric).of_run != nullptr; }

bool is_error(Metric metric) { return metric == Metric::position_error_cm || metric == Metric::orientation_error_deg; }

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

Metric metric_named(std::string_view column) {
  std::vector<std::string> known;
  for (const Metric metric : all_metrics()) {
    if (name_of(metric) == column) return metric;
    known.emplace_back(name_of(metric));
  }
  throw std::invalid_argument(numerics::unknown_name("metric", column, known));
}

std::vector<Metric> reported_metrics() { return metrics_shown({ShownIn::everywhere}); }

std::vector<Metric> compared_metrics() {
  std::vector<Metric> metrics = metrics_shown({ShownIn::everywhere, ShownIn::in_comparisons});
  std::ranges::stable_sort(metrics, {}, [](Metric metric) { return row(metric).kind; });
  return metrics;
}

std::vector<Metric> shown_metrics(const StudyResults& study) {
  std::vector<Metric> shown = reported_metrics();
  if (!study.facts.published.empty()) return shown;
  std::ranges::copy_if(metrics_shown({ShownIn::where_it_tells}), std::back_inserter(shown),
                       [&](Metric metric) { return differs(study, metric); });
  return shown;
}

}  // namespace ikbench::inference
