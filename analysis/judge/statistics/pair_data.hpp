// The two samples of a pair as plain numbers. Floors, roundings and infinities are resolved here, so that tests need
// not know of them. Depends on the values only. `compare_pairs.cpp` makes one per pair and scale, and drops it after
// the test.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "analysis/judge/data/samples.hpp"

namespace ikbench::judge {

// The numbers of a pair. A deterministic solver has one value. A printed group has a summary and no values.
struct PairData {
  std::vector<double> first, second;
  std::vector<double> differences = {};  // by block, or of each run from the one value of a deterministic solver
  SummaryStatistics of_first = {}, of_second = {};
  // The smaller effective sample size, and the smaller number of solved targets, of two groups of logarithms of costs;
  // otherwise infinite.
  double effective_n = std::numeric_limits<double>::infinity();
  double solved_targets = effective_n;
  double infinity_substitute = 0;  // stands for infinite values; 0: there are none
  bool are_all_equal = false;

  // Returns infinity if an estimate was made of a value that stands for an infinite one; otherwise the estimate.
  double restore_infinity(double value) const {
    return infinity_substitute > 0 && std::abs(value) > infinity_substitute / 8
               ? std::copysign(std::numeric_limits<double>::infinity(), value)
               : value;
  }
};

// Removes the values of blocks that not all groups have. Groups without a Sample are left alone.
void keep_common_blocks(const std::vector<Group*>& groups);

// Returns the values of each group in the blocks that all groups have. Values of a block that differ by no more than
// their rounding become equal, and so do values below the floor if there is one.
std::vector<std::vector<double>> settled_blocks(std::vector<Group> groups, const MetricSamples& samples,
                                                bool has_floor);

// Makes the numbers of a pair. If logarithms are taken, values below the floor of the metric count as the floor. Values
// that differ by no more than their rounding become equal. Paired values without blocks belong together by their
// places.
PairData make_pair_data(const Group& first, const Group& second, const MetricSamples& samples, bool is_by_difference,
                        bool takes_logs);

}  // namespace ikbench::judge
