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
  result.value = averaged([&study, metric, least = info.rounding](const Solve& solve) {
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
  const double most = distance_of(study, metric) + info.rounding;
  const bool has_tolerance = std::isfinite(tolerance_cm(study));
  const bool is_error = metric == Metric::position_error_cm;
  result.value = averaged([&study, metric, most, has_tolerance, is_error](const Solve& solve) {
    const bool counts = has_tolerance ? solve.status == Status::ok : !stays(solve.status);
    return counts && ((is_error && has_tolerance) || value_of(study, solve, metric) <= most) ? 1.0 : 0.0;
  });
  if (has_tolerance) {
    result.notes.emplace_back("Only a solve with status ok counts: inside the joint limits and within the tolerance.");
    return result;
  }
  if (is_error) {
    result.notes.emplace_back(
        "The study has no tolerance, so an answer counts by its position alone, inside the joint limits or not.");
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
  const Tolerance at_most = tolerance(study);
  const bool is_half_a_pose = metric == Metric::position_error_cm && study.task.pose;
  if (!std::isfinite(at_most.cm)) return is_half_a_pose ? words + ", however turned" : words;
  if (metric != Metric::position_error_cm) return "solved " + words;
  return std::isfinite(at_most.deg)
             ? fmt::format("{} and {} deg, inside the joint limits", words, rounded_number(at_most.deg, 4))
             : words + " and inside the joint limits";
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
