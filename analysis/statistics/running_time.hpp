// The cost of reaching a tolerance if some trials never do: expected running time (Hansen, Auger, Ros, Finck, Posik,
// GECCO companion (2010) 1689).
#pragma once

#include <span>
#include <string>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

// The cost of a trial, in evaluations or seconds, until it reached the tolerance or was given up (censored).
struct CensoredCost {
  double spent = 0;
  bool reached = false;
};

// Sums over trials, or over a bootstrap sample of them.
struct RunningTime {
  double trials = 0;
  double successes = 0;
  double spent = 0;

  double expected() const;  // spent / successes: infinite without a success, not defined without trials
};

RunningTime running_time(std::span<const CensoredCost> costs);

// Says why costs have no running time: there are none, or one is negative or not finite. Empty if they have one.
std::string wrong_with(std::span<const CensoredCost> costs);

}  // namespace ikbench::statistics
