// Intervals of any statistic of values that depend on each other, by drawing whole clusters: Davison and Hinkley,
// Bootstrap Methods and their Application (1997), section 3.8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

// The same settings and sample give the same numbers on every machine (analysis/statistics/draw.hpp).
struct Resampling {
  int resamples = 10000;
  std::uint64_t seed = 1;
  double level = 0.95;
};

// Draws clusters (runs, targets) with replacement, each with all its members. One row per replicate counts how often it
// drew each cluster, so a statistic of sums within clusters is a weighted sum. The level is not used. Throws
// std::invalid_argument for no cluster or fewer than two resamples.
std::vector<std::vector<double>> resampled_clusters(std::size_t clusters, const Resampling& settings);

// The estimate with the percentile interval of its replicates from so many clusters, with tails as far out as Student's
// t: Hesterberg, The American Statistician 69 (2015) 371, "expanded percentile". The ends are replicates, which may be
// infinite. They are NaN if one of them is NaN or there are fewer than two clusters.
Estimate expanded_percentiles(double estimate, std::vector<double> replicates, std::size_t clusters, double level);

// Estimates that are compared with 0 together, with intervals that hold all at once; replicates[i] belong to
// estimates[i], in the same order of draws. The critical value is that of the largest studentized deviation in a
// replicate (Romano and Wolf, Econometrica 73 (2005) 1237), widened for few clusters as above. An estimate with a
// replicate that is not finite has no interval and does not count in the family; one that is the same in every
// replicate has an interval without width.
std::vector<Estimate> simultaneous_intervals(std::span<const double> estimates,
                                             std::span<const std::vector<double>> replicates, std::size_t clusters,
                                             double level);

}  // namespace ikbench::statistics
