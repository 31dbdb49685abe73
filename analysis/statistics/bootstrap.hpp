// Intervals of any statistic by resampling: percentile, and BCa (bias-corrected, accelerated). Efron, JASA 82 (1987)
// 171; Davison and Hinkley, Bootstrap Methods and their Application (1997), chapter 5.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

// The same settings and sample give the same numbers on every machine: std::mt19937_64, whose sequence the standard
// fixes, with a bounded draw of our own.
struct Resampling {
  int resamples = 10000;
  std::uint64_t seed = 1;
  double level = 0.95;
};

struct BootstrapInterval {
  double estimate = not_defined;        // of the sample itself
  double standard_error = not_defined;  // standard deviation over the resamples
  double low = not_defined;             // percentiles (type 7) of the resamples
  double high = not_defined;
  double bca_low = not_defined;
  double bca_high = not_defined;
  double z0 = not_defined;  // bias correction: the normal quantile of the share of resamples below the estimate
  double acceleration = not_defined;
  std::string undefined;      // why there are no percentiles; empty where there are
  std::string bca_undefined;  // why there is no BCa interval; empty where there is
};

using Statistic = std::function<double(std::span<const double>)>;

// A statistic that is not finite on the sample or on a resample (the inverse of a mean of zero) has no interval.
// Fewer than two resamples or a level outside (0, 1) is std::invalid_argument.
BootstrapInterval bootstrap(std::span<const double> sample, const Statistic& statistic, const Resampling& = {});

}  // namespace ikbench::statistics
