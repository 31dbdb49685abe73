// Measures a round trip to a program that solves: it gets the errors of ten candidates of two joints, and asks for ten
// others. The programs are the examples in docs/examples/, in C and in Python, with their own computations.
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/foreign/foreign_solver.hpp"
#include "experiments/microbenchmarks/harness.hpp"

namespace ikbench::microbenchmarks {

using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace experiments;

namespace {

void round_trip(benchmark::State& state, const std::vector<std::string>& words) {
  const Chain arm({{.a = 0.5}, {.a = 0.5}});
  const JointLimits limits{Configuration::Constant(2, -3), Configuration::Constant(2, 3)};
  const StopRule stop{.iterations = 100};  // of the warm-up
  const Problem problem{
      .start = Configuration::Constant(2, 0.1), .lower = limits.lower, .upper = limits.upper, .population = 10};
  std::shared_ptr<const Program> program;
  try {
    program = meet({.process = words, .patience = 3600}, {});
  } catch (const std::exception& missing) {
    state.SkipWithError(missing.what());
    return;
  }
  Sessions sessions(program, robot_message({.name = "two",
                                            .arm = arm,
                                            .limits = limits,
                                            .joint_names = {"a", "b"},
                                            .urdf = {},
                                            .base_link = {},
                                            .tip_link = {}},
                                           program->hello, options_of(program->hello, {})));
  ForeignSolver solver(sessions, stop);
  Objective objective(arm, Eigen::Vector3d(0.3, 0.4, 0));
  Random random{Key(1)};
  solver.prepare(problem, objective);
  solver.start(problem, objective, random);
  for (auto _ : state) solver.step(objective, random);
  if (solver.account().failure) state.SkipWithError(solver.trouble().c_str());
  solver.conclude();
}

void register_programs() {
  benchmark::RegisterBenchmark("round_trips/c", round_trip, std::vector<std::string>{IKBENCH_SEARCH})->UseRealTime();
  benchmark::RegisterBenchmark("round_trips/python", round_trip, std::vector<std::string>{"python3", IKBENCH_PSO})
      ->UseRealTime();
}

}  // namespace

}  // namespace ikbench::microbenchmarks

int main(int argc, char** argv) {
  ikbench::microbenchmarks::register_programs();
  return ikbench::microbenchmarks::run(argc, argv);
}
