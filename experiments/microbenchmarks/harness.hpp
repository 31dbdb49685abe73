// What every benchmark program needs: a main function, the two problems they all solve, and a check of the peers.
#pragma once

#include <benchmark/benchmark.h>

#include "robots/robot.hpp"
#include "solvers/solver.hpp"

namespace ikbench::microbenchmarks {

// Runs what is registered, with Google Benchmark's flags. The console has one line a benchmark, its median; the file
// has every repetition, the machine, and the instruction set in use.
int run(int argc, char** argv);

// Joints that bring the end of a chain to a target.
struct Reach {
  robots::Chain chain;
  Eigen::Vector3d target;
  solvers::Problem problem;
};

// The first point of the paper's helix with the iiwa: the wrist's centre by four joints, the flange by all seven.
Reach wrist_reach(int population = 50);
Reach flange_reach(int population = 50);

// Within the limits, the same ones every time.
robots::Candidates drawn_candidates(const solvers::Problem& problem, int count);

// Ends the benchmark with an error unless a peer's position [m] of a candidate is that of our chain.
bool is_same_position(benchmark::State& state, const robots::Chain& chain, const robots::ConfigurationRef& q,
                      const Eigen::Vector3d& position);

// Shown and stored: how much work an iteration was.
void count_candidates(benchmark::State& state, int candidates, int joints);

}  // namespace ikbench::microbenchmarks
