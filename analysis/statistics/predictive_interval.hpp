// The place of one more value, predicted from similar values.
#pragma once

#include <span>

#include "analysis/statistics/bootstrap.hpp"

namespace ikbench::statistics {

// Contains the next value with probability `level`: among n exchangeable values a further one is below the k-th with
// probability k / (n + 1), which means quantiles of Hyndman and Fan's type 6. No wider than the values themselves, in
// any order.
Interval predictive_interval(std::span<const double> values, double level);

}  // namespace ikbench::statistics
