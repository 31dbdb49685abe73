#include "analysis/inference/tests_of_means.hpp"

#include "analysis/statistics/studentized_bootstrap.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

const MeanDifference& TestsOfMeans::deciding(DecidingTest test, std::size_t pair) const {
  switch (test) {
    case DecidingTest::anova:
      return pooled[pair];
    case DecidingTest::tamhane:
      return by_tamhane[pair];
    case DecidingTest::bootstrap:
      return bootstrapped[pair];
    default:
      return unpooled[pair];
  }
}

TestsOfMeans tests_of_means(const Evidence& evidence, std::span<const GroupSummary> summaries,
                            std::span<const std::vector<double>> values) {
  const double level = 1 - evidence.plan.significance;
  TestsOfMeans tests{.pooled = tukey(summaries, level, evidence.reference),
                     .unpooled = games_howell(summaries, level, evidence.reference),
                     .by_tamhane = tamhane(summaries, level, evidence.reference),
                     .bootstrapped = {}};
  if (evidence.plan.test != DecidingTest::bootstrap) return tests;
  // Of logarithms, differences are what is a ratio of the values.
  const PairFamily family{.by = evidence.scale == ValueScale::log10 ? CompareBy::differences : CompareBy::ratios,
                          .control = evidence.plan.control.empty() ? std::nullopt : evidence.reference,
                          .only_with = evidence.reference};
  tests.bootstrapped = studentized_bootstrap(values, family, {.resamples = resamples_of(evidence), .level = level});
  return tests;
}

int resamples_of(const Evidence& evidence) {
  std::size_t values = 0;
  for (const GroupEvidence& group : evidence.groups) values += static_cast<std::size_t>(group.described.n);
  return affordable_resamples(values, evidence.groups.size(), 1 - evidence.plan.significance);
}

}  // namespace ikbench::inference
