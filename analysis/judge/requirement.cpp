#include "analysis/judge/requirement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/judge/judge.hpp"

namespace ikbench::judge {

namespace {

// Returns how many further values would show the share, if it stays as it is; 0 if no number would. Wilson's lower end
// reaches the required share r at n = z^2 r (1 - r) / (share - r)^2.
std::int64_t more_values(const RequirementCheck& check, double alpha) {
  if (!(check.share > check.required)) return 0;
  const double z = critical_z(alpha), distance = check.share - check.required;
  const double needed = z * z * check.required * (1 - check.required) / (distance * distance);
  return std::max<std::int64_t>(1, std::llround(std::ceil(std::min(needed, 1e12) - check.n)));
}

// Returns why the share of a described, but not compared solver is not checked.
std::string reason_against(const MetricSamples& samples, const std::string& solver) {
  for (const Warning& warning : samples.warnings) {
    const bool is_named = warning.solvers.empty() || std::ranges::count(warning.solvers, solver) > 0;
    if (std::string reason = reason_not_compared(warning); is_named && !reason.empty()) return reason;
  }
  return "its share is not comparable";
}

const JudgedMetric& share_named(const JudgedStudy& judged, const std::string& slug) {
  const auto found =
      std::ranges::find(judged.metrics, slug, [](const JudgedMetric& each) { return each.samples.metric; });
  if (found != judged.metrics.end()) return *found;
  throw std::invalid_argument(fmt::format(
      "--require {}: the study has no such share; expected {}", slug,
      slug == "solved" ? "a study with a tolerance (stop.tolerance_cm)" : "analysis.deadline_ms or loop.period_ms"));
}

}  // namespace

RequirementCheck check_requirement(const JudgedMetric& judged, const std::string& solver, double required) {
  const std::size_t group = index_of(judged.samples, solver);
  const Descriptives& descriptives = judged.descriptives[group];
  const Group& sample = judged.samples.groups[group];
  RequirementCheck check{.solver = solver,
                         .metric = judged.samples.metric,
                         .required = required,
                         .share = descriptives.mean,
                         .n = static_cast<double>(descriptives.n),
                         .are_counts = trials_per_value(judged.samples) == 1,
                         .is_exact = is_deterministic(sample)};
  if (missing_in(sample) > 0)
    check.reason = "solves are missing";
  else if (excluded(sample) || descriptives.n == 0)
    check.reason = reason_against(judged.samples, solver);
  if (!check.reason.empty()) return check;
  check.interval = check.is_exact ? Interval{check.share, check.share}
                                  : wilson_interval({.share = check.share, .n = check.n}, judged.plan.significance);
  if (check.interval.low >= required)
    check.verdict = RequirementVerdict::met;
  else if (check.interval.high < required)
    check.verdict = RequirementVerdict::failed;
  else
    check.more_values = more_values(check, judged.plan.significance);
  return check;
}

std::vector<RequirementCheck> check_requirements(const JudgedStudy& judged,
                                                 const std::vector<results::Requirement>& requirements,
                                                 const std::vector<std::string>& own_solvers, bool is_strict) {
  const std::vector<std::string>& labels = judged.study.labels;
  std::vector<RequirementCheck> checks;
  if (judged.study.definition.is_grid() && !requirements.empty())
    throw std::invalid_argument(
        fmt::format("--require: {}; a study of random targets can have it", results::grid_is_no_sample));
  for (const results::Requirement& requirement : requirements) {
    const JudgedMetric& metric = share_named(judged, requirement.metric);
    std::vector<std::string> solvers = own_solvers.empty() ? labels : own_solvers;
    if (!requirement.solver.empty()) solvers = {requirement.solver};
    for (const std::string& solver : solvers) {
      if (std::ranges::count(labels, solver) == 0) continue;
      checks.push_back(check_requirement(metric, solver, requirement.share));
      checks.back().is_strict = is_strict;
    }
  }
  return checks;
}

int exit_code(const std::vector<RequirementCheck>& checks) {
  const auto is_failed = [](const RequirementCheck& check) { return check.verdict == RequirementVerdict::failed; };
  const auto is_open = [](const RequirementCheck& check) {
    return check.is_strict && check.verdict == RequirementVerdict::inconclusive;
  };
  if (std::ranges::any_of(checks, is_failed)) return 3;
  return std::ranges::any_of(checks, is_open) ? 4 : 0;
}

}  // namespace ikbench::judge
