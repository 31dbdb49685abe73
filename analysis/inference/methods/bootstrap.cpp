#include <algorithm>
#include <cmath>

#include "analysis/inference/method.hpp"
#include "analysis/statistics/studentized_bootstrap.hpp"
#include "analysis/statistics/welch.hpp"

namespace ikbench::inference {

using namespace statistics;

namespace {

PairFamily family_of(const Evidence& evidence) {
  // A difference of logarithms is a ratio of the values.
  return {.by_ratios = evidence.scale != ValueScale::log10,
          .control = evidence.plan.control.empty() ? std::nullopt : evidence.reference,
          .only_with = evidence.reference};
}

Resampling resampling_of(const Evidence& evidence) {
  return {.resamples = resamples_of(evidence), .level = 1 - evidence.plan.significance};
}

std::vector<Finding> independent(const Evidence& evidence, const Groups& groups) {
  return of_means(evidence, studentized_bootstrap(groups.values, family_of(evidence), resampling_of(evidence)));
}

std::vector<Finding> within_blocks(const Evidence& evidence, const Groups& groups) {
  return of_means(evidence, bootstrap_within_blocks(groups.values, family_of(evidence), resampling_of(evidence)));
}

// With more blocks than a bootstrap can resample in a second, the mean difference is nearly normal.
std::vector<Finding> paired(const Evidence& evidence, const Groups& groups) {
  const auto family = static_cast<double>(evidence.family());
  std::vector<MeanDifference> result;
  for (const Finding& contrast : evidence.contrasts) {
    MeanDifference& test = result.emplace_back(
        paired_t(groups.values[contrast.first], groups.values[contrast.second], 1 - evidence.alpha()));
    if (!std::isnan(test.p)) test.p = std::min(1.0, family * test.p);
  }
  return of_means(evidence, result);
}

}  // namespace

const Method bootstrap_method{.name = "bootstrap",
                              .title = "Studentized bootstrap of the means",
                              .of_pair = "studentized bootstrap",
                              .resamples = true,
                              .pairs = independent};
const Method bootstrap_within_blocks_method{.name = "bootstrap",
                                            .title = "Studentized bootstrap of the differences within blocks",
                                            .of_pair = "studentized bootstrap of the differences within blocks",
                                            .within_blocks = true,
                                            .resamples = true,
                                            .pairs = within_blocks};
const Method paired_t_method{.name = "bootstrap",
                             .title = "Paired t-test within blocks",
                             .of_pair = "paired t-test within blocks",
                             .within_blocks = true,
                             .resamples = true,
                             .pairs = paired};

}  // namespace ikbench::inference
