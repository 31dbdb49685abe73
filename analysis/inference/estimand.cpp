#include "analysis/inference/estimand.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/convergence.hpp"
#include "analysis/inference/text.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

Quantity mean_quantity(const StudyResults& study, Metric metric) {
  const MetricInfo& info = info_of(metric);
  return {.name = std::string(info.slug),
          .text = quantity(metric),
          .better = info.better,
          .average = is_of_run(metric) ? "value" : std::string(average_name(metric)),
          .value = [&study, metric](Run run) { return value_of(study, run, metric); }};
}

Quantity typical_quantity(const StudyResults& study, Metric metric) {
  const MetricInfo& info = info_of(metric);
  Quantity result{.name = fmt::format("{}-typical", info.slug),
                  .text = fmt::format("typical {}", quantity(metric)),
                  .better = info.better,
                  .scale = ValueScale::log10,
                  .average = "geometric mean"};
  result.value = averaged([&study, metric, least = info.rounding](const SolveRecord& solve) {
    const double value = value_of(study, solve, metric);
    return std::log10(value < least ? least : value);
  });
  if (info.rounding > 0) {
    result.notes.push_back(fmt::format("A value below {0} {1} counts as {0} {1}, because below that it is rounding.",
                                       rounded_number(info.rounding, 3), info.unit));
  }
  return result;
}

Quantity reliability_quantity(const StudyResults& study, Metric metric) {
  const MetricInfo& info = info_of(metric);
  Quantity result{.name = fmt::format("{}-reliability", info.slug),
                  .text = fmt::format("share of solves {}", within_words(study, metric)),
                  .better = Better::larger,
                  .average = "share"};
  const double most = distance_of(study, metric);
  if (metric == Metric::position_error_cm) {  // and of a pose the angle
    result.value = averaged([within = Tolerance{most, tolerance(study).deg}](const SolveRecord& solve) {
      return !stays(solve.status) && reaches(solve, within) ? 1.0 : 0.0;
    });
  } else {
    result.value = averaged([&study, metric, most = most + info.rounding](const SolveRecord& solve) {
      return !stays(solve.status) && value_of(study, solve, metric) <= most ? 1.0 : 0.0;
    });
  }
  result.notes.emplace_back("An answer that was refused, is not finite or is missing is not within.");
  return result;
}

}  // namespace

double distance_of(const StudyResults& study, Metric metric) {
  if (metric == Metric::position_error_cm) {
    const double tolerance = tolerance_cm(study);
    return std::isfinite(tolerance) ? tolerance : study.plan.within_cm;
  }
  return metric == Metric::seconds ? deadline_seconds(study) : not_defined;
}

std::string within_words(const StudyResults& study, Metric metric) {
  const std::string words =
      fmt::format("within {} {}", rounded_number(distance_of(study, metric), 4), info_of(metric).unit);
  const double angle = tolerance(study).deg;
  const bool has_angle = metric == Metric::position_error_cm && std::isfinite(angle);
  return has_angle ? fmt::format("{} and {} deg", words, rounded_number(angle, 4)) : words;
}

std::vector<Estimand> estimands_of(const StudyResults& study, Metric metric) {
  std::vector<Estimand> result = study.plan.estimands;
  if (metric == Metric::position_error_cm) return result;
  const bool has_reliability = std::ranges::find(result, Estimand::reliability) != result.end();
  if (!has_reliability || !std::isfinite(distance_of(study, metric))) return {Estimand::mean};
  return {Estimand::mean, Estimand::reliability};
}

Quantity quantity_of(const StudyResults& study, Metric metric, Estimand estimand) {
  switch (estimand) {
    case Estimand::typical:
      return typical_quantity(study, metric);
    case Estimand::reliability:
      return reliability_quantity(study, metric);
    default:
      return mean_quantity(study, metric);
  }
}

}  // namespace ikbench::inference
