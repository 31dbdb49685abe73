#include "analysis/inference/posteriors.hpp"

#include "analysis/inference/margin.hpp"
#include "analysis/statistics/bayesian_signed_rank.hpp"
#include "analysis/statistics/rounding.hpp"

namespace ikbench::inference {

using namespace statistics;

void add_posteriors(const Evidence& evidence, std::span<const std::vector<double>> ranked,
                    std::vector<Contrast>& shown) {
  std::vector<Differences> comparisons;
  for (const Contrast& contrast : shown) {
    comparisons.push_back({.values = differences_without_rounding(ranked[contrast.second], ranked[contrast.first]),
                           .rope = margin_of(evidence, contrast)});
  }
  const std::vector<SignedRankPosterior> found = bayesian_signed_rank(comparisons);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    shown[i].posterior = {.first_better = found[i].above, .same = found[i].within, .second_better = found[i].below};
  }
}

}  // namespace ikbench::inference
