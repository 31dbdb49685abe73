// Two groups as a test takes them: numbers alone. A pure function of their values, so that a test sees neither floors
// nor infinities nor copies.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "analysis/judge/data/samples.hpp"

namespace ikbench::judge {

// A solver that repeats itself has one value. A group that is printed has a summary and no values.
struct PairData {
  std::vector<double> first, second;
  std::vector<double> differences = {};  // by block; or of each run from the one value of a solver that repeats itself
  SummaryStatistics of_first = {}, of_second = {};
  double effective_n =
      std::numeric_limits<double>::infinity();  // of logarithms: that of the group whose values tell less
  double solved_targets = effective_n;          // of the same: targets that the weaker one solved
  double infinity_substitute =
      0;  // stands for infinite values, and is larger than all that comes of others; 0: there are none
  bool are_all_equal = false;

  // Infinite where it is made of a value that stands for an infinite one.
  double restore_infinity(double value) const {
    return infinity_substitute > 0 && std::abs(value) > infinity_substitute / 8
               ? std::copysign(std::numeric_limits<double>::infinity(), value)
               : value;
  }
};

// Leaves the values of blocks that all measured ones of these have.
void keep_common_blocks(const std::vector<Group*>& groups);

// Values below the floor count as it where logarithms are taken; those that differ by no more than the rounding are
// equal. Paired values without blocks belong together by their places.
PairData make_pair_data(const Group& first, const Group& second, const MetricSamples& samples, bool is_by_difference,
                        bool takes_logs);

}  // namespace ikbench::judge
