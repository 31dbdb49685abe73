// The cost of reaching a tolerance if some trials never do: expected running time (Hansen, Auger, Ros, Finck, Posik,
// GECCO companion (2010) 1689).
#pragma once

#include <limits>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

// Sums over trials, or over a bootstrap sample of them.
struct RunningTime {
  double trials = 0;
  double successes = 0;
  double spent = 0;  // in evaluations or seconds, until a trial reached the tolerance or was given up (censored)

  void add(double cost, bool is_success) {
    ++trials;
    successes += is_success ? 1 : 0;
    spent += cost;
  }
  // Infinite without a success, not defined without trials.
  double expected() const {
    if (trials == 0) return not_defined;
    return successes > 0 ? spent / successes : std::numeric_limits<double>::infinity();
  }
};

}  // namespace ikbench::statistics
