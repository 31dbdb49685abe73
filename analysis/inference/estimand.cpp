#include "analysis/inference/estimand.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/inference/convergence.hpp"
#include "analysis/inference/study_facts.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/inference/times.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

bool has_tolerance(const StudyResults& study) { return std::isfinite(tolerance_cm(study)); }

}  // namespace

double tolerance_of(const StudyResults& study, Metric metric) {
  if (!is_error(metric)) return not_defined;
  const double cm = tolerance_cm(study), deg = tolerance_deg(study);
  if (metric != Metric::orientation_error_deg) return cm;
  return std::isfinite(cm) && std::isfinite(deg) ? deg : not_defined;
}

namespace {

// Errors below this are equal: the tolerance, or else rounding; not defined without either.
double least_of(const StudyResults& study, Metric metric) {
  const double tolerance = tolerance_of(study, metric), rounding = info_of(metric).rounding;
  return std::isfinite(tolerance) || !is_error(metric) || rounding == 0 ? tolerance : rounding;
}

// The most that the study lets a solve cost; not defined if it does not say.
double limit_of(const StudyResults& study, Metric metric) {
  double limit = not_defined;
  if (metric == Metric::evaluations) limit = study.facts.stop.evaluations;
  if (metric == Metric::seconds) limit = deadline_seconds(study);
  return limit > 0 ? limit : not_defined;
}

// The most that a solve may cost: the study's limit, or else what the dearest solve of all solvers cost. That of its
// own solver would reward who gives up early. 0 if no solve cost anything.
double most_of(const StudyResults& study, Metric metric, const ValueOf& counted) {
  const double limit = limit_of(study, metric);
  if (std::isfinite(limit)) return limit;
  double most = 0;
  for (const Solve& solve : study.solves) {
    const double value = counted(solve);
    if (std::isfinite(value)) most = std::max(most, value);
  }
  return most;
}

// Penalises solves that are not ok, so that no solver gains by answers that solve nothing.
ValueOf penalise(Observations& result, const StudyResults& study, Metric metric, ValueOf counted) {
  const MetricInfo& info = info_of(metric);
  result.quantity = text_of({fmt::format("{} ({})", info.name, penalty_words(study, metric)), result.unit});
  const double most = most_of(study, metric, counted);
  const std::string_view space = info.unit.empty() ? "" : " ";
  const std::string value = fmt::format("{}{}{}", rounded_number(most, 6), space, info.unit);
  if (std::ranges::any_of(study.solves, [](const Solve& solve) { return !is_ok(solve); }))
    result.counting.push_back(fmt::format(
        "For {} a solve without status ok counts as {:g} times {} (PAR10), so that no solver gains by answers that solve "
        "nothing.",
        info.name, penalty,
        std::isfinite(limit_of(study, metric)) ? fmt::format("the study's limit of {}", value)
        : most > 0
            ? fmt::format(
                  "what the dearest solve of {} cost, {}, because the study has no limit",
                  study.solvers.size() > 2 ? "all solvers" : fmt::format("{}", fmt::join(study.solvers, " and ")),
                  value)
            : fmt::format("1{}{}, because the study has no limit and no solve cost anything", space, info.unit)));
  return [counted = std::move(counted), metric, failure = penalty * (most > 0 ? most : 1)](const Solve& solve) {
    const bool is_known = metric != Metric::evaluations || solve.counted_by != CountedBy::nobody;
    return is_ok(solve) || !is_known ? counted(solve) : failure;
  };
}

// Says which small values count as the tolerance, or as rounding.
void add_note_on_small_values(Observations& result, const StudyResults& study, Metric metric) {
  const MetricInfo& info = info_of(metric);
  const auto is_small = [&](const Solve& solve) { return value_of(study, solve, metric) < info.rounding; };
  if (const double tolerance = tolerance_of(study, metric); std::isfinite(tolerance)) {
    result.counting.push_back(
        fmt::format("An error below the tolerance of {0} {1} counts as {0} {1}: below it solvers are the same.",
                    rounded_number(tolerance, 4), info.unit));
  } else if (info.rounding > 0 &&
             (result.scale == ValueScale::log10 || (is_error(metric) && std::ranges::any_of(study.solves, is_small)))) {
    result.counting.push_back(fmt::format("A value below {0} {1} counts as {0} {1}, because below that it is rounding.",
                                          rounded_number(info.rounding, 3), info.unit));
  }
}

Quantity average_quantity(const StudyResults& study, Metric metric, Estimand estimand) {
  const MetricInfo& info = info_of(metric);
  const bool is_typical = estimand == Estimand::typical, is_time = info.kind == Kind::time;
  Quantity result{.described = {.name = fmt::format("{}{}", info.slug, is_typical && !is_time ? "-typical" : ""),
                                .quantity = quantity(metric),
                                .unit = std::string(info.unit),
                                .better = info.better,
                                .scale = is_typical                 ? ValueScale::log10
                                         : info.kind == Kind::share ? ValueScale::share
                                                                    : ValueScale::plain},
                  .average = is_of_run(metric)        ? "value"
                             : is_typical && !is_time ? "geometric mean"
                                                      : std::string(average_name(metric))};
  Observations& described = result.described;
  if (is_of_run(metric)) {
    result.value = [&study, metric](Run run) { return value_of(study, run, metric); };
  } else {
    ValueOf counted = counted_value(study, metric);
    if (is_penalised(study, metric)) {
      counted = penalise(described, study, metric, std::move(counted));
    } else if (is_time && !is_typical) {
      counted = [&study, metric](const Solve& solve) { return value_of(study, solve, metric); };
    }
    if (is_typical) {
      counted = [counted = std::move(counted), least = info.rounding](const Solve& solve) {
        const double value = counted(solve);
        return std::log10(value < least ? least : value);
      };
    }
    result.value = averaged(std::move(counted), is_typical && !is_time ? mean : average_of(metric));
  }
  if (is_typical) described.quantity = "typical " + described.quantity;
  add_note_on_small_values(described, study, metric);
  return result;
}

// The distance of reliability, in the metric's unit: the study's tolerance, or the plan's within_cm where it has none;
// of times the study's deadline, not defined if it has none.
double distance_of(const StudyResults& study, Metric metric) {
  if (metric == Metric::position_error_cm) {
    const double tolerance = tolerance_cm(study);
    return std::isfinite(tolerance) ? tolerance : study.plan.within_cm;
  }
  return metric == Metric::seconds ? deadline_seconds(study) : not_defined;
}

Quantity reliability_quantity(const StudyResults& study, Metric metric) {
  const MetricInfo& info = info_of(metric);
  Quantity result{.described = {.name = fmt::format("{}-reliability", info.slug),
                                .quantity = fmt::format("share of solves {}", within_words(study, metric)),
                                .better = Better::larger,
                                .scale = ValueScale::share},
                  .average = "share"};
  std::vector<std::string>& notes = result.described.counting;
  const double most = distance_of(study, metric) + info.rounding;
  const bool is_solved = has_tolerance(study), is_position = metric == Metric::position_error_cm;
  result.value = averaged([&study, metric, most, is_solved, is_position](const Solve& solve) {
    const bool counts = is_solved ? is_ok(solve) : !stays(solve.status);
    return counts && ((is_position && is_solved) || value_of(study, solve, metric) <= most) ? 1.0 : 0.0;
  });
  if (is_solved) {
    notes.emplace_back("Only a solve with status ok counts: inside the joint limits and within the tolerance.");
    return result;
  }
  if (is_position) {
    notes.emplace_back(
        "The study has no tolerance, so an answer counts by its position alone, inside the joint limits or not.");
  }
  notes.emplace_back("An answer that was refused, is not finite or is missing is not within.");
  return result;
}

}  // namespace

Estimand primary_estimand(const StudyResults& study) {
  const std::vector<Estimand>& planned = study.plan.estimands;
  const bool has_share = std::ranges::find(planned, Estimand::reliability) != planned.end();
  return has_share && has_tolerance(study) ? Estimand::reliability : planned.front();
}

ValueOf counted_value(const StudyResults& study, Metric metric) {
  if (info_of(metric).kind == Kind::time) return undisturbed_seconds(study);
  return [&study, metric, least = least_of(study, metric)](const Solve& solve) {
    const double value = value_of(study, solve, metric);
    return value < least ? least : value;
  };
}

bool is_penalised(const StudyResults& study, Metric metric) { return is_cost(metric) && has_tolerance(study); }

std::string penalty_words(const StudyResults& study, Metric metric) {
  return fmt::format("failures: {:g} times {}", penalty,
                     std::isnan(limit_of(study, metric)) ? "the dearest solve" : "the limit");
}

std::string within_words(const StudyResults& study, Metric metric) {
  constexpr double ms_per_second = 1000, longest_in_ms = 0.1;
  const double distance = distance_of(study, metric);
  const bool is_in_ms = info_of(metric).kind == Kind::time && distance < longest_in_ms;
  const std::string words =
      fmt::format("within {} {}", rounded_number(is_in_ms ? ms_per_second * distance : distance, 4),
                  is_in_ms ? "ms" : info_of(metric).unit);
  const double most_deg = tolerance_deg(study);
  const bool is_half_a_pose = metric == Metric::position_error_cm && study.facts.pose;
  if (!has_tolerance(study)) return is_half_a_pose ? words + ", however turned" : words;
  if (metric != Metric::position_error_cm) return "solved " + words;
  return std::isfinite(most_deg)
             ? fmt::format("{} and {} deg, inside the joint limits", words, rounded_number(most_deg, 4))
             : words + " and inside the joint limits";
}

Estimand average_estimand(Metric metric) {
  return info_of(metric).kind == Kind::time ? Estimand::typical : Estimand::mean;
}

std::vector<Estimand> estimands_of(const StudyResults& study, Metric metric) {
  std::vector<Estimand> result = study.plan.estimands;
  if (metric == Metric::position_error_cm) return result;
  const bool has_reliability = std::ranges::find(result, Estimand::reliability) != result.end();
  if (!has_reliability || !std::isfinite(distance_of(study, metric))) return {average_estimand(metric)};
  return {average_estimand(metric), Estimand::reliability};
}

Quantity quantity_of(const StudyResults& study, Metric metric, Estimand estimand) {
  return estimand == Estimand::reliability ? reliability_quantity(study, metric)
                                           : average_quantity(study, metric, estimand);
}

}  // namespace ikbench::inference
