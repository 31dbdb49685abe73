#include "analysis/inference/outcomes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/text.hpp"
#include "analysis/statistics/rounding.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

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
