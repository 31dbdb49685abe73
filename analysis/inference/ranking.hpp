// Ranks solvers by their means.
#pragma once

#include <string>
#include <vector>

namespace ikbench::inference {

struct RankedSolver {
  std::string solver;
  double mean;  // one that is not finite ranks as the worst
};

// Sorts by mean, smallest first; ties keep their order.
std::vector<RankedSolver> ranked(std::vector<RankedSolver> standings);

}  // namespace ikbench::inference
