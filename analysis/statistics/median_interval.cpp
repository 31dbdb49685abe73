#include "analysis/statistics/median_interval.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>

#include "analysis/statistics/quantile.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {

Estimate median_interval(std::span<const double> sorted, double level) {
  check_level(level);
  const std::size_t n = sorted.size();
  const Estimate alone{.value = quantile(sorted, 0.5, QuantileType::type_5)};
  if (std::ldexp(2.0, -static_cast<int>(std::min<std::size_t>(n, 1000))) > 1 - level) return alone;
  // P(fewer than `rank` values lie below the median)
  const auto missed = [&](std::size_t rank) {
    return boost::math::cdf(boost::math::binomial(static_cast<double>(n), 0.5), static_cast<double>(rank - 1));
  };
  std::size_t rank = 1, too_far = n / 2 + 1;
  while (too_far - rank > 1) {
    const std::size_t middle = rank + (too_far - rank) / 2;
    (2 * missed(middle) <= 1 - level ? rank : too_far) = middle;
  }
  return {.value = alone.value, .low = sorted[rank - 1], .high = sorted[n - rank]};
}

}  // namespace ikbench::statistics
