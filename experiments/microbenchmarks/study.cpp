// The whole helix study, slim2023: six solvers, 2400 solves, with timing and verifier, without store and report; by one
// thread and by two.
#include <benchmark/benchmark.h>

#include "experiments/environment.hpp"
#include "experiments/runner.hpp"
#include "experiments/study_reader.hpp"

namespace ikbench::microbenchmarks {
namespace {

void whole_study(benchmark::State& state) {
  const experiments::Study study = experiments::load_study("slim2023");
  for (auto _ : state) experiments::solve_study(study, static_cast<int>(state.range(0)), [](results::SolveRecord) {});
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

int main(int argc, char** argv) {
  for (const auto& [key, value] : ikbench::experiments::environment())
    if (key != "date") benchmark::AddCustomContext(key, value);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
