// Successive halving of candidates (Karnin, Koren and Somekh, ICML 2013; Jamieson and Talwalkar, AISTATS 2016): all
// have few runs, the better half goes on with twice as many, until one is left.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ikbench::experiments {

struct HalvingRound {
  std::size_t candidates;
  int runs;  // of each, with those of earlier rounds
};

// The solves of one run each in the first round.
std::int64_t least_solves(std::size_t candidates, std::int64_t points);

// The rounds of at least two candidates, with as many runs as the budget of solves allows. A run has `points` solves.
// None if not even one run of each is within the budget.
std::vector<HalvingRound> halving_rounds(std::size_t candidates, std::int64_t points, std::int64_t budget);

// The solves of all rounds together.
std::int64_t solves_of(const std::vector<HalvingRound>& rounds, std::int64_t points);

// A candidate's result in a round.
struct Standing {
  double value;        // smaller is better; one that is not a number is the worst
  double evaluations;  // decide between equal values
};

// The places of the better half, of an odd number with the one in the middle, the best first. Ties keep their order.
std::vector<std::size_t> better_half(const std::vector<Standing>& standings);

}  // namespace ikbench::experiments
