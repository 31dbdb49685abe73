// The open points of a paper, as data: each is a dimension, and its alternatives are settings for --set.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ikbench::results {

struct Alternative {
  std::string set;                       // "bounds=initial"
  std::string where;                     // a clause: "no solver is clamped"
  std::vector<std::string> except = {};  // earlier alternatives under which it has no effect, or which it contradicts
};

struct Dimension {
  std::string name;                       // what its alternatives set: "bounds", "IK-BA.acceptance"
  std::string label;                      // of its solver; empty: the study's
  std::vector<Alternative> alternatives;  // the first is the default
};

// An alternative by its index, in a dimension by its index.
struct Choice {
  std::size_t dimension = 0, alternative = 0;
  bool operator==(const Choice&) const = default;
};
using Chosen = std::vector<Choice>;

// A reading is one choice for the study and one for each solver. Given the study's choice, solvers are independent, so
// each is solved by itself, never a reading as a whole. A dimension is a choice only if an alternative besides its
// default is possible (Alternative::except). The default comes first.
struct Multiverse {
  struct ChosenSolver {
    Chosen chosen;
    std::vector<std::size_t> parts;  // by seed: the series that has its numbers
  };
  struct OfStudy {
    Chosen chosen;
    std::vector<std::vector<ChosenSolver>> solvers;  // in the order of `solvers`

    double readings() const {
      double product = 1;
      for (const auto& of_solver : solvers) product *= static_cast<double>(of_solver.size());
      return product;
    }
  };
  std::vector<Dimension> dimensions;
  std::vector<std::string> solvers;
  std::vector<OfStudy> studies;

  double readings() const {
    double sum = 0;
    for (const OfStudy& study : studies) sum += study.readings();
    return sum;
  }
};

}  // namespace ikbench::results
