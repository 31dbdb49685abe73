#include "analysis/statistics/rank_statistic.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {

double RankDistribution::two_sided(double statistic) const {
  if (probabilities.empty()) {
    return normal_two_sided(std::max(0.0, std::abs(statistic - mean) - 0.5) / standard_deviation);
  }
  const double nearer_zero = std::min(statistic, 2 * mean - statistic);
  double tail = 0;
  for (std::size_t i = 0; static_cast<double>(i) <= nearer_zero; ++i) tail += probabilities[i];
  return std::min(1.0, 2 * tail);
}

std::size_t RankDistribution::interval_rank(double level) const {
  if (probabilities.empty()) {
    const double rank = std::floor(mean - normal_critical(level) * standard_deviation + 0.5);
    return rank > 0 ? static_cast<std::size_t>(rank) : 0;
  }
  check_level(level);
  std::size_t rank = 0;
  for (double below = probabilities[0]; below <= (1 - level) / 2; below += probabilities[rank]) ++rank;
  return rank;
}

std::string RankDistribution::method() const { return probabilities.empty() ? "normal approximation" : "exact"; }

Shift shift_of(std::vector<double> differences, std::size_t rank) {
  Shift shift;
  if (differences.empty()) return shift;
  const auto smallest = [&](std::size_t number) {  // counted from 1
    const auto at = differences.begin() + static_cast<std::ptrdiff_t>(number - 1);
    std::nth_element(differences.begin(), at, differences.end());
    return *at;
  };
  const std::size_t n = differences.size();
  const double lower = smallest((n + 1) / 2);
  const double upper = smallest(n / 2 + 1);
  shift.estimate = lower == upper ? lower : lower / 2 + upper / 2;
  if (rank < 1 || rank > n) return shift;
  shift.low = smallest(rank);
  shift.high = smallest(n + 1 - rank);
  return shift;
}

}  // namespace ikbench::statistics
