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

std::uint64_t RankDistribution::interval_rank(double level) const {
  if (probabilities.empty()) {
    const double rank = std::floor(mean - normal_critical(level) * standard_deviation + 0.5);
    return rank > 0 ? static_cast<std::uint64_t>(rank) : 0;
  }
  check_level(level);
  std::uint64_t rank = 0;
  for (double below = probabilities[0]; below <= (1 - level) / 2; below += probabilities[rank]) ++rank;
  return rank;
}

std::string RankDistribution::method() const { return probabilities.empty() ? "normal approximation" : "exact"; }

}  // namespace ikbench::statistics
