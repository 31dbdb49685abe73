#include "analysis/statistics/paired_proportion.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <cstddef>

#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {

double mcnemar_exact(const PairedSuccesses& counts) {
  const int apart = counts.first_only + counts.second_only;
  if (apart == 0) return 1;
  const boost::math::binomial even(apart, 0.5);
  return std::min(1.0, 2 * boost::math::cdf(even, std::min(counts.first_only, counts.second_only)));
}

Estimate newcombe_paired(const PairedSuccesses& counts, double level) {
  const int n = counts.trials();
  const Estimate first = wilson({.successes = counts.both + counts.first_only, .trials = n}, level);
  const Estimate second = wilson({.successes = counts.both + counts.second_only, .trials = n}, level);
  const double a = counts.both, b = counts.first_only, c = counts.second_only, d = counts.neither;
  const double margins = (a + b) * (c + d) * (a + c) * (b + d);
  const double excess = a * d - b * c;
  const double phi = margins == 0 ? 0 : (excess > 0 ? std::max(0.0, excess - n / 2.0) : excess) / std::sqrt(margins);
  const auto reach = [&](double one, double other) {
    return std::sqrt(std::max(0.0, one * one - 2 * phi * one * other + other * other));
  };
  const double difference = (b - c) / n;
  return {.value = difference,
          .low = difference - reach(first.value - first.low, second.high - second.value),
          .high = difference + reach(first.high - first.value, second.value - second.low)};
}

Test cochran_q(std::span<const std::vector<double>> groups) {
  Test test;
  const auto k = static_cast<double>(groups.size());
  std::vector<double> of_groups;
  double all = 0, squares = 0;  // of the successes of a trial
  for (const auto& group : groups) of_groups.push_back(mean(group) * static_cast<double>(group.size()));
  for (std::size_t i = 0; i < groups.front().size(); ++i) {
    double successes = 0;
    for (const auto& group : groups) successes += group[i];
    all += successes;
    squares += successes * successes;
  }
  const double varying = k * all - squares;
  if (varying == 0) {
    test.undefined = "in each block all groups have the same outcome";
    return test;
  }
  test.df = k - 1;
  test.statistic = k * (k - 1) * sum_of_squares(of_groups) / varying;
  test.p = chi_squared_upper_tail(test.statistic, test.df);
  return test;
}

}  // namespace ikbench::statistics
