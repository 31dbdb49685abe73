// Ranks of a pooled sample, equal values sharing the mean of theirs (midranks).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

struct Ranking {
  std::vector<double> ranks;      // of the values in their order; 1 is the smallest
  std::vector<std::size_t> ties;  // how many are equal, for each value that occurs more than once, ascending by value
  std::string undefined;          // why there are no ranks; empty where there are

  double tie_sum() const;  // of t^3 - t over the ties: what the variance of a rank statistic loses by them
};

// Infinite values are ranked as any other; NaN has no rank, and then no value has.
Ranking midranks(std::span<const double> values);

// The values of all groups, one group after the other.
std::vector<double> pooled(std::span<const std::vector<double>> groups);

}  // namespace ikbench::statistics
