// Measures the whole helix study, slim2023: six solvers, 2400 solves, with timing and verifier, without store and
// report; by one thread and by two.
#include "experiments/microbenchmarks/harness.hpp"
#include "experiments/runner.hpp"
#include "experiments/study_reader.hpp"

namespace ikbench::microbenchmarks {

using namespace results;
using namespace experiments;

namespace {

constexpr double solves_of_study = 2400;  // as the goals G9 and G10 say

void whole_study(benchmark::State& state) {
  const Study study = load_study("slim2023");
  double solves = 0;
  for (auto _ : state) {
    solve_study(study, static_cast<int>(state.range(0)), [&](const SolveRecord& record) {
      benchmark::DoNotOptimize(record.position_error_cm);
      ++solves;
    });
  }
  if (solves != static_cast<double>(state.iterations()) * solves_of_study) {
    state.SkipWithError("slim2023 has another number of solves");
    return;
  }
  state.counters["solves"] = benchmark::Counter(solves, benchmark::Counter::kAvgIterations);
}

BENCHMARK(whole_study)
    ->Name("study/threads")
    ->Arg(1)
    ->Arg(2)
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace

}  // namespace ikbench::microbenchmarks

int main(int argc, char** argv) { return ikbench::microbenchmarks::run(argc, argv); }
