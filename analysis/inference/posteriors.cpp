#include "analysis/inference/posteriors.hpp"

#include "analysis/inference/margin.hpp"
#include "analysis/statistics/bayesian_signed_rank.hpp"
#include "analysis/statistics/rounding.hpp"

namespace ikbench::inference {

using namespace statistics;

void add_posteriors(Evidence& evidence, std::span<const std::vector<double>> values) {
  std::vector<Contrast>& shown = evidence.contrasts;
  std::vector<Differences> comparisons;
  for (const Contrast& contrast : shown) {
    const bool is_smaller = evidence.better == Better::smaller;
    const std::vector<double>& worse = values[is_smaller ? contrast.second : contrast.first];
    const std::vector<double>& better = values[is_smaller ? contrast.first : contrast.second];
    comparisons.push_back(
        {.values = differences_without_rounding(worse, better), .rope = margin_of(evidence, contrast)});
  }
  const std::vector<SignedRankPosterior> found = bayesian_signed_rank(comparisons);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    shown[i].posterior = {.first_better = found[i].above, .same = found[i].within, .second_better = found[i].below};
  }
}

}  // namespace ikbench::inference
