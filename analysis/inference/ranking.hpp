// Ranks solvers by their means. Means that are equal bit for bit share a place, and a tie counts for nobody.
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

// 1 is the place of the smallest mean.
struct Placing {
  int place = 0;
  bool shared = false;
};
Placing placing_of(const RankedSolver& standing, const std::vector<RankedSolver>& all);

// Writes a ranking as "A, B = C". No sign claims a tested difference.
std::string order_words(const std::vector<RankedSolver>& ranking);

}  // namespace ikbench::inference
