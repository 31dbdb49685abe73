// Where one more value lies, from values like it.
#pragma once

#include <span>

#include "analysis/statistics/bootstrap.hpp"

namespace ikbench::statistics {

// With that probability: among n exchangeable values a further one is below the k-th with probability k / (n + 1),
// which is quantiles of Hyndman and Fan's type 6. No wider than the values themselves, in any order.
Interval predictive_interval(std::span<const double> values, double level);

}  // namespace ikbench::statistics
