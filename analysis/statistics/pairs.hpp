// Lists every pair of several groups, in the order that all comparisons keep.
#pragma once

#include <cstddef>
#include <vector>

namespace ikbench::statistics {

// One comparison per pair first < second, groups counted from 0: (0, 1), (0, 2), ..., (1, 2), ...
template <class Comparison>
std::vector<Comparison> all_pairs(std::size_t groups) {
  std::vector<Comparison> pairs;
  for (std::size_t first = 0; first < groups; ++first) {
    for (std::size_t second = first + 1; second < groups; ++second) pairs.push_back({.first = first, .second = second});
  }
  return pairs;
}

}  // namespace ikbench::statistics
