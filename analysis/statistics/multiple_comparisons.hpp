// All pairs of means compared at one level for the whole family by Tamhane's T2 (JASA 74 (1979) 471), which does not
// pool the variances: Welch's test (Biometrika 34 (1947) 28) of each pair, corrected by Sidak's inequality.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

struct MeanDifference {
  std::size_t first = 0;  // groups in the given order, from 0
  std::size_t second = 0;
  Estimate difference = {};             // mean of the first less mean of the second, with its simultaneous interval
  double standard_error = not_defined;  // of that difference
  double df = not_defined;
  double q = not_defined;        // studentized: |difference| sqrt(2) / standard error
  double p = not_defined;        // corrected for all pairs of all groups
  double p_alone = not_defined;  // of this pair alone
  Reason undefined = {};         // why there is no p; empty if there is one
  bool lacks_spread = false;     // there is no p because the values are too alike
};

// One comparison per pair first < second, groups counted from 0: (0, 1), (0, 2), ..., (1, 2), ... `only_with` keeps the
// pairs with that group.
std::vector<MeanDifference> pairs_of(std::size_t groups, std::optional<std::size_t> only_with = std::nullopt);

// Pairs first < second in order; `only_with` keeps the pairs with that group, still corrected for all pairs. Each pair
// stands for itself, so only the pairs of groups whose mean or spread is not defined are not defined. Throws
// std::invalid_argument if `level` is not between 0 and 1 or there is no such group.
std::vector<MeanDifference> tamhane(std::span<const GroupSummary> groups, double level,
                                    std::optional<std::size_t> only_with = std::nullopt);

}  // namespace ikbench::statistics
