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

// Solvers that share the first place of a ranking, which must not be empty.
std::vector<std::string> first_of(const std::vector<RankedSolver>& ranking);

// "A", or "A and B, which share the place".
std::string first_words(const std::vector<RankedSolver>& ranking);

// Counts the pairs that ranking `of` orders, those that `other` orders the same way, and those that it ties. `other`
// has all solvers of `of`.
struct PairOrder {
  int pairs = 0;
  int same = 0;
  int tied = 0;
};
PairOrder compare_pairs(const std::vector<RankedSolver>& of, const std::vector<RankedSolver>& other);

// "14 of 15 pairs stand in the printed order", and the number of ties.
std::string printed_order_words(const PairOrder& pairs);

}  // namespace ikbench::inference
