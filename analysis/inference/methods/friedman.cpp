// The sign test of two groups is Friedman's of the two: it ranks within each block, so that blocks may have different
// scales.
#include "analysis/inference/method.hpp"
#include "analysis/statistics/ranks.hpp"
#include "analysis/statistics/welch.hpp"

namespace ikbench::inference {

using namespace statistics;

namespace {

std::vector<Finding> friedman_pairs(const Evidence& evidence, const Groups& groups) {
  std::vector<Finding> result;
  for (const Finding& contrast : evidence.contrasts) {
    const std::size_t first = contrast.first, second = contrast.second;
    Test test = sign_test(groups.ranked[first], groups.ranked[second]);
    result.push_back(
        {.p_alone = test.p,
         .ahead = -test.direction,
         .estimate = paired_t(groups.values[first], groups.values[second], 1 - evidence.alpha()).difference,
         .why = std::move(test.undefined)});
  }
  correct(evidence, result);
  return result;
}

std::optional<TestResult> friedman_of_all(const Evidence&, const Groups& groups) {
  const RankTest test = friedman(groups.ranked);
  return TestResult{test, std::string(friedman_name), "F", Role::robust, "W", test.effect};
}

}  // namespace

const Method friedman_method{.name = "friedman",
                             .title = "Friedman's test with sign tests",
                             .of_pair = "sign test within blocks",
                             .interval = "paired t-test within blocks",
                             .source =
                                 "Friedman, JASA 32 (1937) 675; Iman and Davenport, Communications in Statistics "
                                 "A9 (1980) 571; Dixon and Mood, JASA 41 (1946) 557",
                             .compares = Compares::ranks,
                             .within_blocks = true,
                             .pairs = friedman_pairs,
                             .all = friedman_of_all};

}  // namespace ikbench::inference
