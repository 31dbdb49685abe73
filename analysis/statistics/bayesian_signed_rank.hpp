// How probable it is that of two that were given the same blocks the first is better, the second, or that they are
// practically the same: the Bayesian signed-rank test with a region of practical equivalence. Benavoli, Corani, Demsar
// and Zaffalon, J. Machine Learning Research 18 (2017) no. 77, section 4.2; Benavoli, Mangili, Corani, Zaffalon and
// Ruggeri, ICML (2014) 1026.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

// More differences than this are not looked at: the posterior then adds nothing to the signed-rank test.
constexpr std::size_t most_bayesian_differences = 500;

struct Differences {
  std::vector<double> values;  // finite
  double rope = 0;             // up to here, to either side, a difference does not matter
};

// Add up to 1.
struct SignedRankPosterior {
  double below = not_defined;  // P(differences are mostly below -rope)
  double within = not_defined;
  double above = not_defined;
  std::string undefined;  // why there is none; empty where there is
};

// Of several comparisons with equally many differences each, by the same draws, so that comparisons of many groups take
// little longer than one. Prior: a Dirichlet process of strength 1/2 at a difference of 0. The posterior is drawn 10000
// times (std::mt19937_64, fixed seed), so a probability is off by 0.005 (one standard error) at most: weights w of the
// differences z and of that 0, from Dirichlet(1/2, 1, ..., 1); what counts is which of three sums of w_i w_j is the
// largest, of pairs (i, j), i = j among them, with (z_i + z_j) / 2 below -rope, within, above rope.
std::vector<SignedRankPosterior> bayesian_signed_rank(std::span<const Differences> comparisons);

}  // namespace ikbench::statistics
