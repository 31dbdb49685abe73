// PSO and DE by hand from their equations, as one writes them without a library, and by pagmo. Nothing here is from
// solvers/. The wrist centre of an iiwa 14 by joints 1 to 4, 20 candidates, 200 iterations: 4020 evaluations.
//
//   peers PEER ALGORITHM SEED TIMES: its version; then for each line with a target and joints, where it takes the wrist
//   centre by these joints, and of TIMES solves the time [s], the error [m] and the evaluations
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>
#ifdef WITH_PAGMO
#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/pso.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#endif

constexpr int population = 20, iterations = 200, joints = 4;
constexpr double inertia = 0.53514, cognitive = 2.0149, social = 1.1312, weight = 0.6, crossover = 0.9;
constexpr double degree = 3.14159265358979323846 / 180;
constexpr std::array limit{170 * degree, 120 * degree, 170 * degree, 120 * degree};
using Joints = std::array<double, joints>;
using Place = std::array<double, 3>;

Place reached(const double* q) {
  const double x4 = -0.4 * std::sin(q[3]), z4 = 0.4 * std::cos(q[3]) + 0.42;  // seen from joint 3
  const double x3 = std::cos(q[2]) * x4, y3 = std::sin(q[2]) * x4;
  const double x2 = std::cos(q[1]) * x3 + std::sin(q[1]) * z4, z2 = std::cos(q[1]) * z4 - std::sin(q[1]) * x3;
  return {std::cos(q[0]) * x2 - std::sin(q[0]) * y3, std::sin(q[0]) * x2 + std::cos(q[0]) * y3, z2 + 0.36};
}

long evaluations = 0;
double error(const Place& target, const double* q) {
  ++evaluations;
  const auto [x, y, z] = reached(q);
  const double dx = x - target[0], dy = y - target[1], dz = z - target[2];
  return std::sqrt(dx * dx + dy * dy + dz * dz);
}

struct Candidate {
  Joints at, own, speed{};  // own: its best
  double least;
};
struct Swarm {  // of a solve by hand
  Swarm(const Place& target, unsigned seed) : engine(seed), all(population) {
    for (Candidate& each : all) {
      for (int j = 0; j < joints; ++j) each.at[j] = each.own[j] = limit[j] * (2 * uniform() - 1);
      each.least = error(target, each.at.data());
    }
  }
  double uniform() { return std::uniform_real_distribution<double>(0, 1)(engine); }
  int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(engine); }
  const Candidate* best() const {
    return &*std::min_element(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.least < b.least; });
  }
  std::mt19937_64 engine;
  std::vector<Candidate> all;
};

Joints pso_by_hand(const Place& target, unsigned seed) {
  Swarm swarm(target, seed);
  const Candidate* best = swarm.best();
  for (int t = 0; t < iterations; ++t) {
    for (Candidate& each : swarm.all) {
      for (int j = 0; j < joints; ++j) {
        each.speed[j] = inertia * each.speed[j] + cognitive * swarm.uniform() * (each.own[j] - each.at[j]) +
                        social * swarm.uniform() * (best->own[j] - each.at[j]);
        each.at[j] = std::clamp(each.at[j] + each.speed[j], -limit[j], limit[j]);
      }
      const double found = error(target, each.at.data());
      if (found >= each.least) continue;
      each.least = found;
      each.own = each.at;
      if (found < best->least) best = &each;
    }
  }
  return best->own;
}

Joints de_by_hand(const Place& target, unsigned seed) {
  Swarm swarm(target, seed);
  for (int t = 0; t < iterations; ++t) {
    const std::vector<Candidate> parents = swarm.all;
    for (int i = 0, a, b, c; i < population; ++i) {
      for (a = i; a == i;) a = swarm.below(population);
      for (b = i; b == i || b == a;) b = swarm.below(population);
      for (c = i; c == i || c == a || c == b;) c = swarm.below(population);
      Joints trial = parents[i].own;
      const int forced = swarm.below(joints);
      for (int j = 0; j < joints; ++j) {
        const double mutant = parents[a].own[j] + weight * (parents[b].own[j] - parents[c].own[j]);
        if (swarm.uniform() < crossover || j == forced) trial[j] = std::clamp(mutant, -limit[j], limit[j]);
      }
      const double found = error(target, trial.data());
      if (found < parents[i].least) swarm.all[i] = {.own = trial, .least = found};
    }
  }
  return swarm.best()->own;
}

#ifdef WITH_PAGMO
struct Problem {
  pagmo::vector_double fitness(const pagmo::vector_double& q) const { return {error(target, q.data())}; }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    return {{-limit[0], -limit[1], -limit[2], -limit[3]}, {limit.begin(), limit.end()}};
  }
  Place target;
};
#else
#define PAGMO_VERSION ""
#endif

Joints solve(bool is_by_hand, bool is_pso, const Place& target, unsigned seed) {
#ifdef WITH_PAGMO
  if (!is_by_hand) {
    const pagmo::population first(pagmo::problem(Problem{target}), population, seed);
    const auto found =  // pso 1, 1: with inertia, the best of all leads; de 7: rand/1/bin
        is_pso ? pagmo::pso(iterations, inertia, cognitive, social, 1, 1, 1, 4, false, seed).evolve(first).champion_x()
               : pagmo::de(iterations, weight, crossover, 7, 0, 0, seed).evolve(first).champion_x();
    return {found[0], found[1], found[2], found[3]};
  }
#endif
  return is_pso ? pso_by_hand(target, seed) : de_by_hand(target, seed);
}

int main(int, char** arguments) {
  const bool is_by_hand = arguments[1] == std::string("hand"), is_pso = arguments[2] == std::string("PSO");
  std::printf("%s\n", is_by_hand ? "g++ " __VERSION__ : PAGMO_VERSION);
  unsigned seed = std::atoi(arguments[3]);
  Joints q;
  for (Place to; std::scanf("%lf %lf %lf %lf %lf %lf %lf", &to[0], &to[1], &to[2], &q[0], &q[1], &q[2], &q[3]) == 7;) {
    const Place at = reached(q.data());
    std::printf("%.17g %.17g %.17g\n", at[0], at[1], at[2]);
    for (int i = std::atoi(arguments[4]); i > 0; --i) {
      evaluations = 0;
      const auto began = std::chrono::steady_clock::now();
      q = solve(is_by_hand, is_pso, to, seed++);
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
      const long counted = evaluations;
      if (!std::ranges::equal(q, limit, [](double a, double most) { return std::abs(a) <= most; })) return 4;
      std::printf("%.9g %.17g %ld\n", took.count(), error(to, q.data()), counted);
    }
  }
}
