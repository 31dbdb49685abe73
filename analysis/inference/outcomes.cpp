#include "analysis/inference/outcomes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/text.hpp"
#include "analysis/statistics/power.hpp"
#include "analysis/statistics/rounding.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

// `n` trials find a difference as large as the margin; with fewer than `fewest` no test finds any.
Estimate takes(double fewest, double n) {
  if (std::isinf(n)) return {.low = most_runs, .high = n};
  return n > fewest ? Estimate{.value = n, .low = n, .high = n} : Estimate{.value = fewest};
}

// The fewest trials of two groups that always succeed, or never, whose interval is within the margin.
double trials_to_agree(double margin, double alpha) {
  return smallest_number(2, [&](double trials) {
    const Successes all{.successes = static_cast<int>(trials), .trials = static_cast<int>(trials)};
    return newcombe(all, all, 1 - alpha).high <= margin;
  });
}

}  // namespace

Successes successes_of(const std::vector<double>& values) {
  return {.successes = static_cast<int>(std::ranges::count(values, 1.0)), .trials = static_cast<int>(values.size())};
}

PairedSuccesses paired_successes(const std::vector<double>& first, const std::vector<double>& second) {
  PairedSuccesses counts;
  for (std::size_t i = 0; i < first.size(); ++i) {
    int& either = first[i] == 1 ? counts.first_only : counts.second_only;
    int& alike = first[i] == 1 ? counts.both : counts.neither;
    ++(first[i] == second[i] ? alike : either);
  }
  return counts;
}

Estimate runs_to_decide_shares(const Evidence& evidence, const Finding& contrast,
                               std::span<const std::vector<double>> values) {
  const std::vector<double>&first = values[contrast.first], &second = values[contrast.second];
  const PowerGoal goal{.power = evidence.plan.power, .alpha = evidence.alpha()};
  double fewest = evidence.fewest;
  const Description &one = evidence.groups[contrast.first].described,
                    &other = evidence.groups[contrast.second].described;
  if (is_constant(one) && is_constant(other) && one.mean == other.mean) {
    if (evidence.plan.margin == 0) return {};  // no number suffices
    return takes(fewest, trials_to_agree(evidence.plan.margin, goal.alpha));
  }
  if (evidence.blocks > 0) {
    const PairedSuccesses counts = paired_successes(first, second);
    // Only blocks in which the two differ count.
    const int differ = counts.first_only + counts.second_only;
    if (differ > 0) fewest = std::ceil(fewest * counts.trials() / differ);
    const double std = standard_deviation(differences_without_rounding(first, second));
    return takes(fewest, pairs_to_see(std, evidence.plan.margin, goal));
  }
  return takes(fewest, runs_to_see(summarise(first), summarise(second), evidence.plan.margin, goal));
}

bool are_outcomes(const Observations& observations) {
  if (observations.scale == ValueScale::log10) return false;
  bool zeros = false, ones = false;
  for (const Group& group : observations.groups) {
    if (group.values.empty()) return false;
    for (const double value : group.values) {
      if (value != 0 && value != 1) return false;
      (value == 0 ? zeros : ones) = true;
    }
  }
  return observations.scale == ValueScale::share || (zeros && ones);
}

Estimate solve_rate(const StudyResults& study, std::string_view solver, double level) {
  Successes count;
  for (const Solve& solve : solves_of(study, solver)) {
    ++count.trials;
    if (is_ok(solve)) ++count.successes;
  }
  return wilson(count, level);
}

std::string rare_failures_words(int observations, std::string_view of_what, double significance) {
  return fmt::format("{} {} can miss what happens in up to {} % of them", observations, of_what,
                     rounded_number(100 * statistics::most_without_success(observations, significance), 2));
}

}  // namespace ikbench::inference
