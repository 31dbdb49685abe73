// The registered solvers that can solve for an arm.
#pragma once

#include <vector>

#include "solvers/registry.hpp"

namespace ikbench {

inline std::vector<solvers::SolverInfo> solvers_for(const robots::Chain& arm, solvers::GoalKind goal) {
  std::vector<solvers::SolverInfo> some = solvers::all_solvers();
  std::erase_if(some, [&](const solvers::SolverInfo& info) { return !info.why_not(arm, goal).empty(); });
  return some;
}

}  // namespace ikbench
