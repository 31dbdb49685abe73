// pagmo's differential evolution, particle swarm and bee colony against ours: seven joints, population 50, 200
// generations, the same coefficients, no early end. pagmo gets the problem as its users write it, one candidate per
// call: the arm's closed form with the C library's sin and cos, or (our_chain) our chain.
#include <pagmo/algorithms/bee_colony.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/pso.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>

#include "experiments/microbenchmarks/closed_form.hpp"
#include "experiments/microbenchmarks/harness.hpp"
#include "solvers/registry.hpp"
#include "solvers/solve.hpp"

namespace ikbench::microbenchmarks {

using namespace numerics;
using namespace solvers;

namespace {

constexpr unsigned generations = 200, population_size = 50;

struct ClosedForm {
  Reach reach = flange_reach();

  pagmo::vector_double fitness(const pagmo::vector_double& q) const {
    return {(iiwa_flange(q.data()) - reach.target).norm()};
  }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    const auto& [lower, upper] = std::tie(reach.problem.lower, reach.problem.upper);
    return {{lower.begin(), lower.end()}, {upper.begin(), upper.end()}};
  }
};

struct OurChain : ClosedForm {
  pagmo::vector_double fitness(const pagmo::vector_double& q) const {
    Objective objective(reach.chain, reach.target);
    return {objective.error(Eigen::Map<const Eigen::VectorXd>(q.data(), static_cast<Eigen::Index>(q.size())))};
  }
};

template <class UserProblem, class Algorithm>
void measure_pagmo(benchmark::State& state, const Algorithm& algorithm) {
  const pagmo::problem problem{UserProblem()};
  unsigned seed = 1;
  double sum = 0;
  for (auto _ : state) {
    Algorithm seeded = algorithm;
    seeded.set_seed(++seed);
    sum += seeded.evolve(pagmo::population(problem, population_size, seed)).champion_f()[0];
  }
  state.counters["error_cm"] = benchmark::Counter(100 * sum, benchmark::Counter::kAvgIterations);
}

void measure_ours(benchmark::State& state, const std::string& name) {
  const Reach reach = flange_reach(population_size);
  const auto ours = solver(name).make({});
  Random random{Key(1)};
  double sum = 0;
  for (auto _ : state) {
    Objective objective(reach.chain, reach.target);
    sum += solve(*ours, reach.problem, objective, random, {.iterations = generations}).best.error;
  }
  state.counters["error_cm"] = benchmark::Counter(100 * sum, benchmark::Counter::kAvgIterations);
}

template <class Algorithm>
void register_pair(const std::string& name, const std::string& ours, const Algorithm& algorithm) {
  const auto add = [](const std::string& full_name, const auto& function) {
    benchmark::RegisterBenchmark(full_name.c_str(), function)->Unit(benchmark::kMicrosecond);
  };
  add("pagmo/" + name + "/ours", [ours](benchmark::State& state) { measure_ours(state, ours); });
  add("pagmo/" + name + "/pagmo", [=](benchmark::State& state) { measure_pagmo<ClosedForm>(state, algorithm); });
  add("pagmo/" + name + "/our_chain", [=](benchmark::State& state) { measure_pagmo<OurChain>(state, algorithm); });
}

void register_solvers() {
  constexpr unsigned rand_1_bin = 7, inertia = 1, global_best = 1;
  constexpr double never = 0;  // [1] and [rad]: no difference ends pagmo early
  register_pair("differential_evolution", "differential_evolution",
                pagmo::de(generations, 0.6, 0.9, rand_1_bin, never, never));
  register_pair("particle_swarm", "particle_swarm",
                pagmo::pso(generations, 0.53514, 1.1312, 2.0149, 1, inertia, global_best));
  register_pair("bee_colony", "k_artificial_bee_colony", pagmo::bee_colony(generations, (population_size + 7) / 2));
}

}  // namespace

}  // namespace ikbench::microbenchmarks

int main(int argc, char** argv) {
  ikbench::microbenchmarks::register_solvers();
  return ikbench::microbenchmarks::run(argc, argv);
}
