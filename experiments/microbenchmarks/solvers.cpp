// A solve of the paper (population 50, 200 iterations) by our six solvers, and what each needs at least.
#include <benchmark/benchmark.h>

#include <numbers>
#include <vector>

#include "experiments/microbenchmarks/reach.hpp"
#include "solvers/registry.hpp"
#include "solvers/solve.hpp"

namespace ikbench::microbenchmarks {

using namespace solvers;

namespace {

constexpr int iterations = 200;

// The means of all solves.
void count(benchmark::State& state, double error, double evaluations) {
  state.counters["error_cm"] = benchmark::Counter(100 * error, benchmark::Counter::kAvgIterations);
  state.counters["evaluations"] = benchmark::Counter(evaluations, benchmark::Counter::kAvgIterations);
}

void registered(benchmark::State& state, const char* name) {
  const Reach reach;
  const std::unique_ptr<Solver> solver = solvers::solver(name).make({});
  numerics::Random random{numerics::Key(1)};
  double error = 0, evaluations = 0;
  for (auto _ : state) {
    Objective objective(reach.arm.chain, reach.target);
    const Solution solution = solve(*solver, reach.problem, objective, random, {.iterations = iterations});
    error += solution.best.error;
    evaluations += static_cast<double>(solution.evaluations);
  }
  count(state, error, evaluations);
}

// How often an iteration evaluates all candidates, and draws a number for each of them, or for each of their joints.
struct Needs {
  int evaluations = 1, uniforms = 0, uniforms_of_joints = 0, normals_of_joints = 0;
};

// What no implementation can leave out: the solver's random numbers, and its evaluations in full batches.
void floor(benchmark::State& state, Needs needs) {
  const Reach reach;
  const robots::Candidates q = reach.candidates();
  robots::Candidates of_joints = q;
  Eigen::VectorXd errors(q.cols()), of_candidates = errors;
  numerics::Random random{numerics::Key(1)};
  double evaluations = 0;
  for (auto _ : state) {
    Objective objective(reach.arm.chain, reach.target);
    for (int t = 0; t < iterations; ++t) {
      for (int k = 0; k < needs.uniforms; ++k) random.uniforms(of_candidates);
      for (int k = 0; k < needs.uniforms_of_joints; ++k) random.uniforms(of_joints);
      for (int k = 0; k < needs.normals_of_joints; ++k) random.normals(of_joints);
      for (int k = 0; k < needs.evaluations; ++k) objective.errors(q, errors);
    }
    benchmark::DoNotOptimize(errors.data());
    evaluations += static_cast<double>(objective.evaluations());
  }
  count(state, errors.minCoeff(), evaluations);
}

// All six on an arm of many joints, with many candidates. Counts an evaluation as often as there are joints.
void growth(benchmark::State& state) {
  const Eigen::Index joints = state.range(0);
  std::vector<robots::DhLink> links;
  for (Eigen::Index j = 0; j < joints; ++j)
    links.push_back({.alpha = (j % 2 == 0 ? -0.5 : 0.5) * std::numbers::pi, .d = 0.3});
  const robots::Chain snake(links, Eigen::Vector3d(0.1, 0, 0.1));
  const Problem problem{.start = Eigen::VectorXd::Zero(joints),
                        .lower = Eigen::VectorXd::Constant(joints, -2),
                        .upper = Eigen::VectorXd::Constant(joints, 2),
                        .population = static_cast<int>(state.range(1))};
  numerics::Random random{numerics::Key(1)};
  double evaluations = 0;
  for (auto _ : state) {
    for (const char* name : {"ik_bat", "bat", "differential_evolution", "particle_swarm", "k_artificial_bee_colony",
                             "multi_objective_swarm"}) {
      Objective objective(snake, Eigen::Vector3d(0.3, 0.2, 0.5));
      solve(*solvers::solver(name).make({}), problem, objective, random, {.iterations = iterations});
      evaluations += static_cast<double>(objective.evaluations() * joints);
    }
  }
  count(state, 0, evaluations);
}

#define MEASURE(function, name, argument, by) \
  BENCHMARK_CAPTURE(function, name, argument)->Name("solvers/" #name "/" by)->Unit(benchmark::kMicrosecond)
#define SOLVER(name, ...)                   \
  MEASURE(registered, name, #name, "ours"); \
  MEASURE(floor, name, (Needs{__VA_ARGS__}), "floor")
SOLVER(ik_bat, .uniforms = 2, .normals_of_joints = 1);
SOLVER(bat, .uniforms = 3, .normals_of_joints = 1);
SOLVER(differential_evolution, .uniforms = 4, .uniforms_of_joints = 1);
SOLVER(particle_swarm, .uniforms_of_joints = 2);
SOLVER(k_artificial_bee_colony, .evaluations = 2, .uniforms = 5);
SOLVER(multi_objective_swarm, .uniforms = 2, .uniforms_of_joints = 2);
BENCHMARK(growth)->Args({4, 50})->Args({32, 50})->Args({7, 50})->Args({7, 5000})->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace ikbench::microbenchmarks
