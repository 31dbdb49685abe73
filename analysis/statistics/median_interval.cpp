#include "analysis/statistics/median_interval.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>

#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {

MedianInterval median_interval(std::span<const double> sorted, double level) {
  check_level(level);
  MedianInterval interval;
  const std::size_t n = sorted.size();
  if (std::ranges::any_of(sorted, [](double value) { return std::isnan(value); })) {
    interval.undefined = "a value is not a number and has no rank";
  } else if (!std::ranges::is_sorted(sorted)) {
    interval.undefined = "the values are not sorted";
  } else if (std::ldexp(2.0, -static_cast<int>(std::min<std::size_t>(n, 1000))) > 1 - level) {
    interval.undefined = fmt::format("{} values are too few for a level of {}", n, level);
  }
  if (!interval.undefined.empty()) return interval;

  // P(fewer than `rank` values lie below the median)
  const auto missed = [&](std::size_t rank) {
    return boost::math::cdf(boost::math::binomial(static_cast<double>(n), 0.5), static_cast<double>(rank - 1));
  };
  std::size_t rank = 1, too_far = n / 2 + 1;
  while (too_far - rank > 1) {
    const std::size_t middle = rank + (too_far - rank) / 2;
    (2 * missed(middle) <= 1 - level ? rank : too_far) = middle;
  }
  interval.low_rank = rank;
  interval.high_rank = n + 1 - rank;
  interval.low = sorted[rank - 1];
  interval.high = sorted[n - rank];
  interval.coverage = 1 - 2 * missed(rank);
  return interval;
}

}  // namespace ikbench::statistics
