// Says which targets of a study which solvers solve. `judge` makes it once per study; tables, figures and sentences
// about hard targets are made of it. Takes 60 bytes per target, and a bit per target and solver.
// docs/reference/report.md says when a target counts as solved.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/judge/data/study_results.hpp"

namespace ikbench::judge {

// A target, with the cheapest of the solves that solved it.
struct SolvedTarget {
  int run = 0;  // 0: the runs have the same targets, or there is one run
  int point = 1;
  std::size_t solvers = 0;  // number of solvers that solve the target
  // The solver and the number of the solve with the fewest evaluations, and with the least time [s] of a single call on
  // this machine; nullopt: not solved, or not counted or timed.
  std::optional<std::pair<std::size_t, std::int64_t>> fewest_evaluations = {};
  std::optional<std::pair<std::size_t, double>> least_seconds = {};
};

// All targets of a study. Drawn targets of different runs are different targets. A fixed target counts as solved by a
// solver that solves it in at least one run.
struct SolvedTargets {
  std::vector<std::string> solvers = {};   // those with solves, in the order of the study
  std::vector<SolvedTarget> targets = {};  // in the order of runs and points; empty if the study has no tolerance
  std::vector<bool> is_solved = {};        // target by target, for each solver
  bool are_repeated = false;               // several runs have the same targets
  bool is_complete = false;                // all solvers have all solves of the study

  bool solves(std::size_t solver, std::size_t target) const { return is_solved[target * solvers.size() + solver]; }
};
SolvedTargets solved_targets(const StudyResults& study);
// Returns whether solvers solve different targets.
bool do_solvers_differ(const SolvedTargets& targets);

// The targets that no solver solves, and the solvers that solve most of the others.
struct HardTargets {
  std::size_t targets = 0, unsolved = 0;
  bool are_repeated = false;               // as in SolvedTargets
  std::vector<std::string> alone = {};     // solvers each of which solves all targets that any solver solves
  std::vector<std::string> together = {};  // if no solver does: two or three that do, otherwise the best two
  std::size_t solved_together = 0;         // number of targets that these solve
};
// Returns the hard targets. Of sets of solvers that solve as many targets, the first in this order of all solvers
// counts. Returns nullopt if the solvers solve the same targets, if one of them solves all, or if solves are missing.
// Takes at most a second with 50 solvers of 10 000 targets each. Looks for three solvers only if there are at most 50.
std::optional<HardTargets> hard_targets(const SolvedTargets& targets, const std::vector<std::string>& order);

}  // namespace ikbench::judge
