// Measures one iteration and one whole solve (population 50, 200 iterations) of every registered solver, for four
// joints and for seven. A new solver in the registry needs no change here.
#include <string>

#include "experiments/microbenchmarks/harness.hpp"
#include "solvers/registry.hpp"
#include "solvers/solve.hpp"

namespace ikbench::microbenchmarks {

using namespace numerics;
using namespace solvers;

namespace {

constexpr int iterations = 200;

void whole_solve(benchmark::State& state, const SolverInfo& info, const Reach& reach) {
  const auto solver = info.make({});
  Random random{Key(1)};
  for (auto _ : state) {
    Objective objective(reach.chain, reach.target);
    const Solution solution = solve(*solver, reach.problem, objective, random, {.iterations = iterations});
    benchmark::DoNotOptimize(solution.best.error);
  }
}

// Measures an iteration within a solve: beyond its end, schedules would have run out.
void one_step(benchmark::State& state, const SolverInfo& info, const Reach& reach) {
  const auto solver = info.make({});
  Random random{Key(1)};
  Objective objective(reach.chain, reach.target);
  int done = iterations;
  for (auto _ : state) {
    if (done == iterations || solver->finished()) {
      state.PauseTiming();
      solver->start(reach.problem, objective, random);
      done = 0;
      state.ResumeTiming();
    }
    solver->step(objective, random);
    ++done;
  }
}

void register_solvers() {
  for (const SolverInfo& info : solvers_for(wrist_reach().chain, GoalKind::position)) {
    if (!info.library.empty()) continue;  // a peer: one step of it is a whole solve
    for (const auto& [joints, reach] : {std::pair("joints:4", wrist_reach()), std::pair("joints:7", flange_reach())}) {
      const std::string name = "solvers/" + info.name + "/" + joints;
      benchmark::RegisterBenchmark((name + "/step").c_str(), one_step, info, reach);
      benchmark::RegisterBenchmark((name + "/solve").c_str(), whole_solve, info, reach);
    }
  }
}

}  // namespace

}  // namespace ikbench::microbenchmarks

int main(int argc, char** argv) {
  ikbench::microbenchmarks::register_solvers();
  return ikbench::microbenchmarks::run(argc, argv);
}
