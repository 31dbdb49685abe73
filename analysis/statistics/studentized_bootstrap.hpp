// Compares means by the studentized bootstrap, which divides each resample's deviation by that resample's own standard
// error (Hall, Annals of Statistics 16 (1988) 927): so the deciding distribution contains skewness, unequal spreads and
// unequal sizes. Means of positive values are compared by their logarithms, that is, by their ratio, because a large
// mean then varies as much up as down.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/statistics/draw.hpp"
#include "analysis/statistics/multiple_comparisons.hpp"

namespace ikbench::statistics {

// The family for which p and intervals hold all at once, the wanted pairs of it, and the scale of the comparison.
struct PairFamily {
  bool by_ratios = true;                                // if all values are positive; else by differences
  std::optional<std::size_t> control = std::nullopt;    // the family: pairs with this group, or all
  std::optional<std::size_t> only_with = std::nullopt;  // the wanted: pairs with this group, or all of the family
};

// The number of resamples that so many values in so many groups can have in less than a second; 0 if these are too few.
int affordable_resamples(std::size_t values, std::size_t groups, double level);

// Pairs first < second in order. p is the share of resamples in which some pair of the family deviates as unusually as
// this one differs, that is, as rarely among its own resamples (Westfall and Young, Resampling-Based Multiple Testing
// (1993), section 2.3; single step, smallest p). So a pair whose resamples deviate wildly, such as one with one value
// in a hundred far off, does not hide the others. The interval contains the differences that this test does not refute;
// it excludes 0 if p < 1 - level.
//
// A pair is not defined if one of its groups has fewer than three values or values that are not finite, if both groups
// are constant, or if so many resamples have no spread that no difference could be beyond chance. Such pairs take no
// part in the family.
std::vector<MeanDifference> studentized_bootstrap(std::span<const std::vector<double>> groups, const PairFamily& family,
                                                  const Resampling& settings);

// The same for differences within blocks; groups[g][i] belongs to block i. Each resample draws whole blocks, the same
// for all pairs. Always compares differences, whatever the family says. All groups need equally many values.
std::vector<MeanDifference> bootstrap_within_blocks(std::span<const std::vector<double>> groups,
                                                    const PairFamily& family, const Resampling& settings);
// The least number of blocks with which it can judge a pair among so many.
int fewest_blocks(std::size_t pairs, double level);

}  // namespace ikbench::statistics
