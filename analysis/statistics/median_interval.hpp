// An interval of the median that holds for any distribution: two order statistics, by the binomial of one half
// (Thompson, Annals of Mathematical Statistics 7 (1936) 122).
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

struct MedianInterval {
  double low = not_defined;
  double high = not_defined;
  double coverage =
      not_defined;           // exact for a continuous distribution, at least the level; more where values are equal
  std::size_t low_rank = 0;  // counted from 1, of the sorted values
  std::size_t high_rank = 0;
  std::string undefined;  // why there is none, e.g. fewer than 6 values at 0.95; else empty
};

// The values are sorted ascending (ranked_values); infinite values are ranked like any other.
MedianInterval median_interval(std::span<const double> sorted, double level = 0.95);

}  // namespace ikbench::statistics
