// The open points of a paper, as data: each is a dimension, and its alternatives are settings for --set.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ikbench::results {

struct Alternative {
  std::string set;          // "bounds=initial"
  std::string where;        // a clause: "no solver is clamped"
  std::string except = {};  // an earlier alternative under which it has no effect, or which it contradicts
};

using Dimension = std::vector<Alternative>;  // the first is the default

// A reading is an alternative of each dimension. Solvers are independent, so each is solved by itself, and once for all
// readings that say the same of it.
struct Multiverse {
  struct Reading {
    std::vector<std::string> settings;
    std::vector<std::vector<std::size_t>> parts = {};  // by solver and seed: the series that has its numbers
  };
  std::vector<Dimension> dimensions;
  std::vector<std::string> solvers;
  std::vector<Reading> readings;
};

}  // namespace ikbench::results
