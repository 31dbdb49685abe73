// The verdict on two groups must not depend on other groups (Benavoli, Corani and Mangili, JMLR 17 (2016) no. 5). So
// pairs are compared by their own values, by two tests that both have to find the difference: Mann and Whitney's is
// exact where both groups come from one distribution, Brunner and Munzel's allows for spreads that differ.
#include <cmath>

#include "analysis/inference/method.hpp"
#include "analysis/statistics/mann_whitney.hpp"
#include "analysis/statistics/ranks.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

std::vector<Finding> kruskal_wallis_pairs(const Evidence& evidence, const Groups& groups) {
  std::vector<Finding> result;
  std::vector<double> exact, unequal;
  const std::vector<MeanDifference> means =
      tamhane(groups.summaries, 1 - evidence.plan.significance, evidence.reference);
  for (std::size_t i = 0; i < evidence.contrasts.size(); ++i) {
    const std::size_t first = evidence.contrasts[i].first, second = evidence.contrasts[i].second;
    Test test = mann_whitney(groups.ranked[first], groups.ranked[second]);
    exact.push_back(test.p);
    unequal.push_back(brunner_munzel(groups.ranked[first], groups.ranked[second]).p);
    result.push_back({.p_alone = std::fmax(exact.back(), unequal.back()),
                      .ahead = -test.direction,
                      .estimate = means[i].difference,
                      .why = std::move(test.undefined)});
  }
  correct(evidence, exact);
  correct(evidence, unequal);
  for (std::size_t i = 0; i < result.size(); ++i) result[i].p = std::fmax(exact[i], unequal[i]);
  return result;
}

std::optional<TestResult> kruskal_wallis_of_all(const Evidence&, const Groups& groups) {
  const RankTest test = kruskal_wallis(groups.ranked);
  return TestResult{test, std::string(kruskal_wallis_name), "H", Role::robust, "epsilon^2", test.effect};
}

}  // namespace

const Method kruskal_wallis_method{.name = "kruskal_wallis",
                                   .title = "Kruskal-Wallis test with Brunner-Munzel and Mann-Whitney tests",
                                   .of_pair = "Brunner-Munzel and Mann-Whitney tests",
                                   .of_two = "Brunner-Munzel test with Mann-Whitney's test",
                                   .interval = "Tamhane, separate variances",
                                   .compares = Compares::ranks,
                                   .pairs = kruskal_wallis_pairs,
                                   .all = kruskal_wallis_of_all};

}  // namespace ikbench::inference
