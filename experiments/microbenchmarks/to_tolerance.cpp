// Measures the median time of a solve in the setting of the paper's Table 7: IK-BA with 12 bats, random targets, until
// the error is 0.1 cm.
#include <algorithm>
#include <chrono>
#include <vector>

#include "experiments/microbenchmarks/harness.hpp"
#include "solvers/registry.hpp"
#include "solvers/solve.hpp"

namespace ikbench::microbenchmarks {

using namespace numerics;
using namespace robots;
using namespace solvers;

namespace {

void to_tolerance(benchmark::State& state) {
  using Clock = std::chrono::steady_clock;
  constexpr int targets = 500;
  const Reach reach = wrist_reach(12);
  const StopRule stop{.iterations = 1000, .tolerance = 0.001};
  Problem problem = reach.problem;
  problem.iterations = stop.iterations;
  const Candidates reaching = drawn_candidates(problem, targets);  // so that every target is within reach
  const auto bats = solver("ik_bat").make({});
  Random random{Key(2)};
  std::vector<double> seconds(targets);
  int missed = 0;
  for (auto _ : state) {
    missed = 0;
    for (std::size_t i = 0; i < targets; ++i) {
      Objective objective(reach.chain, reach.chain.position(reaching.col(static_cast<Eigen::Index>(i))));
      const Clock::time_point started = Clock::now();
      const Solution solution = solve(*bats, problem, objective, random, stop);
      seconds[i] = std::chrono::duration<double>(Clock::now() - started).count();
      if (solution.stopped != Stopped::tolerance) ++missed;
    }
    std::nth_element(seconds.begin(), seconds.begin() + targets / 2, seconds.end());
    state.SetIterationTime(seconds[targets / 2]);
  }
  state.counters["missed_share"] = static_cast<double>(missed) / targets;
}

BENCHMARK(to_tolerance)->Name("ik_bat/to_tolerance")->Iterations(1)->UseManualTime()->Unit(benchmark::kMicrosecond);

}  // namespace

}  // namespace ikbench::microbenchmarks

int main(int argc, char** argv) { return ikbench::microbenchmarks::run(argc, argv); }
