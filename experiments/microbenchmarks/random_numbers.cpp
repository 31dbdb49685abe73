// Measures a draw of a uniform and of a normal number: ours in fills of 7 x 50, and the standard library's.
#include <random>

#include "experiments/microbenchmarks/harness.hpp"

namespace ikbench::microbenchmarks {

using namespace numerics;
using namespace robots;

namespace {

constexpr int joints = 7, batch = 50;

template <class Fill>
void measure(benchmark::State& state, Fill&& fill) {
  Candidates out(joints, batch);
  for (auto _ : state) {
    fill(out);
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  using benchmark::Counter;
  state.counters["per_draw"] =
      Counter(joints * batch, Counter::Flags(Counter::kIsIterationInvariantRate | Counter::kInvert));
}

void ours_uniform(benchmark::State& state) {
  measure(state, [random = Random(Key(1))](Candidates& out) mutable { random.uniforms(out); });
}

void ours_normal(benchmark::State& state) {
  measure(state, [random = Random(Key(1))](Candidates& out) mutable { random.normals(out); });
}

template <class Distribution>
void standard(benchmark::State& state) {
  measure(state, [generator = std::mt19937_64(1), distribution = Distribution()](Candidates& out) mutable {
    for (double& number : out.reshaped()) number = distribution(generator);
  });
}

BENCHMARK(ours_uniform)->Name("random_numbers/uniform/ours");
BENCHMARK(standard<std::uniform_real_distribution<double>>)->Name("random_numbers/uniform/standard");
BENCHMARK(ours_normal)->Name("random_numbers/normal/ours");
BENCHMARK(standard<std::normal_distribution<double>>)->Name("random_numbers/normal/standard");

}  // namespace

}  // namespace ikbench::microbenchmarks

int main(int argc, char** argv) { return ikbench::microbenchmarks::run(argc, argv); }
