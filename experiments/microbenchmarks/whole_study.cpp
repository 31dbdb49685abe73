// Measures the whole helix study, slim2023: six solvers, 2400 solves, with timing and verifier, without store and
// report; by one thread and by two.
#include <chrono>
#include <ctime>

#include "experiments/environment.hpp"
#include "experiments/microbenchmarks/harness.hpp"
#include "experiments/runner.hpp"
#include "experiments/study_reader.hpp"

namespace ikbench::microbenchmarks {

using namespace results;
using namespace experiments;

namespace {

constexpr double solves_of_study = 2400;  // as the goal says

double own_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void whole_study(benchmark::State& state) {
  const Study study = load_study("slim2023");
  double solves = 0;
  const double not_of_others = processor_seconds().idle + own_seconds();
  const auto started = std::chrono::steady_clock::now();
  for (auto _ : state) {
    solve_study(study, static_cast<int>(state.range(0)), [&](const SolveRecord& record) {
      benchmark::DoNotOptimize(record.position_error_cm);
      ++solves;
    });
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - started;
  state.counters["needed_cores"] = static_cast<double>(state.range(0));
  state.counters["free_cores"] = (processor_seconds().idle + own_seconds() - not_of_others) / seconds.count();
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
