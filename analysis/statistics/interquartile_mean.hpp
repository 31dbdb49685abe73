// The mean of the middle half of all runs on all targets: less noisy than a median, and not decided by a few runs.
// Agarwal, Schwarzer, Castro, Courville and Bellemare, NeurIPS 34 (2021), "Deep reinforcement learning at the edge of
// the statistical precipice".
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

// More values than this have no interval: each is looked at 2000 times.
constexpr std::size_t most_bootstrapped_values = 20'000;

// Values that depend on each other, as those of a run; drawn together.
using Cluster = std::vector<double>;
// What is drawn from by itself, as the runs of one target.
using Stratum = std::vector<Cluster>;

struct InterquartileMean {
  double estimate = not_defined;
  double low = not_defined;  // percentiles of 2000 resamples, each of which draws anew from every stratum
  double high = not_defined;
  std::string undefined;  // why there is no interval, or no estimate either; empty where there is
};

// A quarter of the values is left out at either end, rounded down (SciPy's trim_mean with 0.25). NaN counts as worse
// than every number, at the upper end; a middle that is not finite is not defined.
InterquartileMean interquartile_mean(std::span<const Stratum> strata, double level);

}  // namespace ikbench::statistics
