// Means by the studentized bootstrap, which holds each resample's deviation against that resample's own standard error
// (Hall, Annals of Statistics 16 (1988) 927): skewness, unequal spreads and unequal sizes are then in the distribution
// that decides. Means of positive values are compared by their logarithms, that is, by their ratio, because a large
// mean then varies as much up as down.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/statistics/bootstrap.hpp"
#include "analysis/statistics/multiple_comparisons.hpp"
#include "analysis/statistics/welch.hpp"

namespace ikbench::statistics {

// ratios: of means of positive values; where some value is not positive, these are differences too.
enum class CompareBy { ratios, differences };

// Which pairs p and intervals hold for all at once, which are wanted of these, and what of their means is compared.
struct PairFamily {
  CompareBy by = CompareBy::ratios;
  std::optional<std::size_t> control = std::nullopt;    // the pairs with this group; else all
  std::optional<std::size_t> only_with = std::nullopt;  // those that this group takes part in; else all of the family
};

// How many resamples so many values in so many groups can have in less than a second; 0 where these are too few.
int affordable_resamples(std::size_t values, std::size_t groups, double level);

// Pairs first < second in order. p is the share of resamples in which some pair of the family deviates as unusually as
// this one differs: as rarely, among its own resamples (Westfall and Young, Resampling-Based Multiple Testing (1993),
// section 2.3; single step, smallest p). So a pair whose resamples deviate wildly, as where one value in a hundred is
// far off, does not hide the others. The interval has the differences that this test does not refute; it excludes 0
// where p < 1 - level.
//
// A pair with a group that has fewer than three values, whose values are not finite, or with two constant groups is not
// defined. Neither is one of which so many resamples have no spread that no difference could be beyond chance. Such
// pairs take no part in the family.
std::vector<MeanDifference> studentized_bootstrap(std::span<const std::vector<double>> groups, const PairFamily& family,
                                                  const Resampling& settings);

// The same of the differences within blocks, groups[g][i] being of block i: each resample draws whole blocks, the same
// for all pairs. Differences are compared, whatever the family says. All groups have equally many values.
std::vector<MeanDifference> bootstrap_within_blocks(std::span<const std::vector<double>> groups,
                                                    const PairFamily& family, const Resampling& settings);
// From how many blocks on it can judge a pair of so many.
int fewest_blocks(std::size_t pairs, double level);

// Interval of one mean, equally likely to miss it on either side.
MeanInterval studentized_interval(std::span<const double> sample, const Resampling& settings);

}  // namespace ikbench::statistics
