#include "solvers/registry.hpp"

#include <stdexcept>

#include "numerics/names.hpp"

namespace ikbench::solvers {

using namespace numerics;

#define SOLVER(name) SolverInfo name();
#include "solvers/registry.inc"
#undef SOLVER

std::vector<SolverInfo> all_solvers() {
  return {
#define SOLVER(name) name(),
#include "solvers/registry.inc"
#undef SOLVER
  };
}

std::vector<SolverInfo> solvers_for(const robots::Chain& arm, Asked asked) {
  std::vector<SolverInfo> some = all_solvers();
  std::erase_if(some, [&](const SolverInfo& info) { return !info.why_not(arm, asked).empty(); });
  return some;
}

SolverInfo solver(std::string_view name) {
  std::vector<std::string> names;
  for (SolverInfo& info : all_solvers()) {
    if (info.name == name) return std::move(info);
    names.push_back(info.name);
  }
  throw std::invalid_argument(unknown_name("solver", name, names));
}

}  // namespace ikbench::solvers
