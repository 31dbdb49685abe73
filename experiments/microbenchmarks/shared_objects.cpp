// Measures the cost of the C interface: a whole solve with each of the paper's solvers, built in and from a shared
// object (tests/plugins), timed as `ikbench host` does.
#include <array>
#include <memory>
#include <string>

#include "experiments/foreign/shared_object.hpp"
#include "experiments/microbenchmarks/harness.hpp"
#include "solvers/registry.hpp"
#include "solvers/solve.hpp"

namespace ikbench::microbenchmarks {

using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace experiments;

namespace {

void whole_solve(benchmark::State& state, Solver& solver, const Reach& reach) {
  for (auto _ : state) {
    Objective objective(reach.chain, reach.target);
    Random random{Key(1)};
    const Solution solution = solve(solver, reach.problem, objective, random, {.iterations = 200});
    benchmark::DoNotOptimize(solution.best.error);
  }
}

void built_in(benchmark::State& state, const std::string& name, const Reach& reach) {
  whole_solve(state, *solver(name).make({}), reach);
}

void hosted(benchmark::State& state, const std::string& name, const Reach& reach) {
  const SharedObject object(IKBENCH_SIX, name);
  const HostedArm arm{.name = "wrist",
                      .urdf = {},
                      .base_link = {},
                      .tip_link = {},
                      .chain = reach.chain,
                      .limits = {reach.problem.lower, reach.problem.upper},
                      .options = {}};
  SharedSolver solver(object.solver(), arm);
  whole_solve(state, solver, reach);
}

void register_solvers() {
  for (const char* name : {"ik_bat", "bat", "particle_swarm", "differential_evolution", "k_artificial_bee_colony",
                           "multi_objective_swarm"}) {
    const std::string prefix = std::string("shared_objects/") + name;
    benchmark::RegisterBenchmark((prefix + "/built_in").c_str(), built_in, name, wrist_reach());
    benchmark::RegisterBenchmark((prefix + "/hosted").c_str(), hosted, name, wrist_reach());
  }
}

}  // namespace

}  // namespace ikbench::microbenchmarks

int main(int argc, char** argv) {
  ikbench::microbenchmarks::register_solvers();
  return ikbench::microbenchmarks::run(argc, argv);
}
