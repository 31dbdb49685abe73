// What it costs to reach a tolerance when some trials never do: expected running time (Hansen, Auger, Ros, Finck,
// Posik, GECCO companion (2010) 1689) and success performance SP1 (Auger and Hansen, CEC (2005) 1777).
#pragma once

#include <span>
#include <string>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

// What a trial spent, in evaluations or seconds, until it reached the tolerance or was given up (censored).
struct CensoredCost {
  double spent = 0;
  bool reached = false;
};

struct RunningTime {
  int trials = 0;
  int successes = 0;
  double success_rate = not_defined;
  double expected = not_defined;  // ERT: all that was spent by the number of successes
  double sp1 = not_defined;       // mean of what successful trials spent by the success rate
  std::string undefined;          // why there is no expected; empty where there is
};

RunningTime running_time(std::span<const CensoredCost> costs);

// Why costs cannot be judged: there are none, or one is negative or not finite. Empty where they can.
std::string wrong_with(std::span<const CensoredCost> costs);

}  // namespace ikbench::statistics
