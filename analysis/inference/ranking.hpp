// Solvers in the order of their means. Means that are equal to the bit share a place, and a tie counts for nobody.
#pragma once

#include <string>
#include <vector>

namespace ikbench::inference {

struct Standing {
  std::string solver;
  double mean;  // one that is not finite ranks as the worst
};

// The smallest first; ties in the order given.
std::vector<Standing> ranked(std::vector<Standing> standings);

// 1 is the place of the smallest mean.
struct Placing {
  int place = 0;
  bool shared = false;
};
Placing placing_of(const Standing& standing, const std::vector<Standing>& all);

// "A, B = C", of a ranking. No sign says that a difference was tested.
std::string order_words(const std::vector<Standing>& ranking);

// Those that share the first place of a ranking that is not empty: one, where there is a first.
std::vector<std::string> first_of(const std::vector<Standing>& ranking);

// "A", or "A and B, which share the place".
std::string first_words(const std::vector<Standing>& ranking);

// Of the pairs of solvers that one ranking puts into an order: how many the other puts into the same, and how many it
// ties. The solvers of `of` are all in `other`.
struct PairOrder {
  int pairs = 0;
  int same = 0;
  int tied = 0;
};
PairOrder compare_pairs(const std::vector<Standing>& of, const std::vector<Standing>& other);

// "14 of 15 pairs stand in the printed order", and how many are tied.
std::string printed_order_words(const PairOrder& pairs);

}  // namespace ikbench::inference
