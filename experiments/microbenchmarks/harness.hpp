// Common to all benchmark programs: a main function, the problems that they solve, and a check of the peers.
#pragma once

#include <benchmark/benchmark.h>

#include "robots/robot.hpp"
#include "solvers/solver.hpp"

namespace ikbench::microbenchmarks {

// Runs the registered benchmarks with Google Benchmark's flags. The console shows one line per benchmark, its median;
// the file has every repetition, the machine, and the instruction set in use.
int run(int argc, char** argv);

// The problem of bringing the end of a chain to a target.
struct Reach {
  robots::Chain chain;
  Eigen::Vector3d target;
  solvers::Problem problem;
};

// The flange of the iiwa, by all seven joints, at the first point of the paper's helix.
Reach flange_reach();

// A chain without shortcuts: no joint can be left out, and no length is 0. Its target is half of the stretched arm
// away. If `slides`, every third joint slides.
Reach snake_reach(int joints, bool slides = false);

// Draws candidates within the limits, always the same ones.
robots::Candidates drawn_candidates(const solvers::Problem& problem, int count);

// Ends the benchmark with an error unless a peer's position [m] of a candidate is that of our chain.
bool is_same_position(benchmark::State& state, const robots::Chain& chain, const robots::ConfigurationRef& q,
                      const Eigen::Vector3d& position);

// Reports the work of an iteration, on the console and in the file.
void count_candidates(benchmark::State& state, int candidates, int joints);

}  // namespace ikbench::microbenchmarks
