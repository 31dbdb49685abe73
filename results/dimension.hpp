// The open points of a paper as data. Each point is a dimension, and each alternative of it is a setting as `--set`
// takes it. A claim of the paper is tested in every combination of alternatives.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ikbench::results {

struct Alternative {
  std::string set;          // "bounds=initial"
  std::string where;        // a clause for reports: "no solver is clamped"
  std::string except = {};  // an earlier alternative under which it has no effect, or which it contradicts
};

using Dimension = std::vector<Alternative>;  // the first alternative is the default

// All interpretations of a paper. A reading (an interpretation) takes one alternative from each dimension. Solvers are
// independent, so each is solved by itself, and only once for all readings that ask the same of it.
struct Multiverse {
  struct Interpretation {
    std::vector<std::string> settings;
    std::vector<std::vector<std::size_t>> parts = {};  // by solver and seed: index of the series with its numbers
  };
  std::vector<Dimension> dimensions;
  std::vector<std::string> solvers;
  std::vector<Interpretation> readings;
};

}  // namespace ikbench::results
