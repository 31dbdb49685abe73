// If every observation is 0 or 1, shares are compared, whatever test the plan names.
#include <algorithm>

#include "analysis/inference/method.hpp"
#include "analysis/inference/outcomes.hpp"
#include "analysis/statistics/proportion.hpp"

namespace ikbench::inference {

using namespace statistics;

namespace {

// Compares shares pair by pair, with p and interval of each pair at the family's level.
template <class Compare>
std::vector<Finding> share_pairs(const Evidence& evidence, const Groups& groups, Compare compare) {
  const int sign = evidence.better == Better::smaller ? -1 : 1;
  std::vector<Finding> result;
  for (const Finding& contrast : evidence.contrasts) {
    const auto [alone, difference] =
        compare(groups.values[contrast.first], groups.values[contrast.second], evidence.alpha());
    result.push_back({.p_alone = alone, .ahead = sign * sign_of(difference.value), .estimate = difference});
  }
  correct(evidence, result);
  return result;
}

std::vector<Finding> fisher_pairs(const Evidence& evidence, const Groups& groups) {
  return share_pairs(evidence, groups, [](const auto& first, const auto& second, double alpha) {
    const Successes one = successes_of(first), other = successes_of(second);
    return std::pair(fisher_exact(one, other), newcombe(one, other, 1 - alpha));
  });
}

std::vector<Finding> mcnemar_pairs(const Evidence& evidence, const Groups& groups) {
  return share_pairs(evidence, groups, [](const auto& first, const auto& second, double alpha) {
    const PairedSuccesses counts = paired_successes(first, second);
    Estimate difference = newcombe_paired(counts, 1 - alpha);
    if (counts.first_only + counts.second_only == 0) {  // these two agree in every block; others may not
      const double unseen = most_without_success(counts.trials(), alpha);
      difference.low = std::min(difference.low, -unseen);
      difference.high = std::max(difference.high, unseen);
    }
    return std::pair(mcnemar_exact(counts), difference);
  });
}

}  // namespace

const Method fisher_method{.name = "shares",
                           .title = "Fisher's exact test",
                           .interval = "Newcombe's score interval",
                           .compares = Compares::shares,
                           .pairs = fisher_pairs};
const Method mcnemar_method{.name = "shares",
                            .title = "McNemar's exact test",
                            .interval = "Newcombe's score interval",
                            .compares = Compares::shares,
                            .within_blocks = true,
                            .pairs = mcnemar_pairs};

}  // namespace ikbench::inference
