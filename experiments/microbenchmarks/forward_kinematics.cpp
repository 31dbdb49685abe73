// Measures position errors of 50 candidates by our code, and by the limit (a kernel for this arm alone), and how ours
// grows with joints and population.
#include <fmt/format.h>

#include "experiments/microbenchmarks/harness.hpp"
#include "experiments/microbenchmarks/kernels.hpp"
#include "numerics/instruction_set.hpp"
#include "solvers/objective.hpp"

namespace ikbench::microbenchmarks {

using namespace numerics;
using namespace robots;
using namespace solvers;

IKBENCH_DEFINE_KERNELS

namespace {

constexpr int batch = 50;

void measure(benchmark::State& state, const Reach& reach, int candidates) {
  const Candidates q = drawn_candidates(reach.problem, candidates);
  Eigen::VectorXd errors(candidates);
  for (auto _ : state) {
    reach.chain.position_errors(q, reach.target, errors);
    benchmark::DoNotOptimize(errors.data());
    benchmark::ClobberMemory();
  }
  count_candidates(state, candidates, reach.chain.joints());
}

void ours(benchmark::State& state) { measure(state, flange_reach(), batch); }

void limit(benchmark::State& state, InstructionSet set) {
  const Reach reach = flange_reach();
  const Candidates q = drawn_candidates(reach.problem, batch);
  const Kernels iiwa = microbenchmarks::kernels(set);
  Eigen::VectorXd errors(batch), expected(batch);
  reach.chain.position_errors(q, reach.target, expected);
  const auto evaluate = [&] {
    iiwa.iiwa_errors(reach.target.data(), q.data(), q.outerStride(), q.cols(), errors.data());
  };
  evaluate();
  if (!((errors - expected).cwiseAbs().maxCoeff() <= 1e-12)) state.SkipWithError("the errors differ from ours");
  for (auto _ : state) {
    evaluate();
    benchmark::DoNotOptimize(errors.data());
    benchmark::ClobberMemory();
  }
  count_candidates(state, batch, reach.chain.joints());
}

void ours_pose(benchmark::State& state) {
  const Reach reach = flange_reach();
  const Candidates q = drawn_candidates(reach.problem, batch);
  const Pose target = reach.chain.forward(q.col(0));
  Eigen::VectorXd errors(batch);
  for (auto _ : state) {
    reach.chain.pose_errors(q, target, 0.5, errors);
    benchmark::DoNotOptimize(errors.data());
    benchmark::ClobberMemory();
  }
  count_candidates(state, batch, reach.chain.joints());
}

void one_at_a_time(benchmark::State& state) {
  const Reach reach = flange_reach();
  const Candidates q = drawn_candidates(reach.problem, batch);
  Objective objective(reach.chain, reach.target);
  for (auto _ : state) {
    for (int i = 0; i < batch; ++i) benchmark::DoNotOptimize(objective.error(q.col(i)));
  }
  count_candidates(state, batch, reach.chain.joints());
}

void growth_with_joints(benchmark::State& state) {
  measure(state, snake_reach(static_cast<int>(state.range(0))), batch);
}

void sliding(benchmark::State& state) { measure(state, snake_reach(7, true), batch); }

void growth_with_population(benchmark::State& state) {
  measure(state, flange_reach(), static_cast<int>(state.range(0)));
}

BENCHMARK(ours)->Name("forward_kinematics/ours");
BENCHMARK(sliding)->Name("forward_kinematics/sliding");
BENCHMARK(ours_pose)->Name("forward_kinematics/ours_pose");
BENCHMARK(one_at_a_time)->Name("forward_kinematics/one_at_a_time");
BENCHMARK(growth_with_joints)->Name("forward_kinematics/joints")->Arg(4)->Arg(7)->Arg(8)->Arg(16)->Arg(32);
BENCHMARK(growth_with_population)->Name("forward_kinematics/population")->Arg(50)->Arg(500)->Arg(5000)->Arg(50000);

void register_limits() {
  benchmark::RegisterBenchmark("forward_kinematics/limit", limit, instruction_set());
  for (const InstructionSet set : instruction_sets()) {
    benchmark::RegisterBenchmark(fmt::format("forward_kinematics/limit/{}", name_of(set)).c_str(), limit, set);
  }
}

}  // namespace

}  // namespace ikbench::microbenchmarks

int main(int argc, char** argv) {
  ikbench::microbenchmarks::register_limits();
  return ikbench::microbenchmarks::run(argc, argv);
}
