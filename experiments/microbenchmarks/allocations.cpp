// Counts heap allocations of a solve: start and 200 iterations of every registered solver, after a first solve.
#include "tests/solvers/allocations.hpp"

#include "experiments/microbenchmarks/harness.hpp"
#include "solvers/registry.hpp"

namespace ikbench::microbenchmarks {

using namespace numerics;
using namespace solvers;

namespace {

void count(benchmark::State& state, const SolverInfo& info) {
  const Reach reach = flange_reach();
  const auto solver = info.make({});
  Random random{Key(1)};
  Objective objective(reach.chain, reach.target);
  const auto solve = [&] {
    solver->start(reach.problem, objective, random);
    for (int iteration = 0; iteration < 200; ++iteration) solver->step(objective, random);
  };
  solve();
  long counted = 0;
  for (auto _ : state) {
    const long before = allocations();
    solve();
    counted = allocations() - before;
  }
  state.counters["allocations"] = static_cast<double>(counted);
}

void register_solvers() {
  for (const SolverInfo& info : solvers_for(wrist_reach().chain, GoalKind::position)) {
    if (!info.library.empty()) continue;  // a peer: one step of it is a whole solve
    benchmark::RegisterBenchmark(("allocations/" + info.name).c_str(), count, info)
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace

}  // namespace ikbench::microbenchmarks

int main(int argc, char** argv) {
  ikbench::microbenchmarks::register_solvers();
  return ikbench::microbenchmarks::run(argc, argv);
}
