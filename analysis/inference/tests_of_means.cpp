#include "analysis/inference/tests_of_means.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/statistics/pairs.hpp"
#include "analysis/statistics/studentized_bootstrap.hpp"
#include "analysis/statistics/welch.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

// Of more blocks than a bootstrap can draw again in a second, the mean difference is as good as normal.
std::vector<MeanDifference> paired_tests(const Evidence& evidence, std::span<const std::vector<double>> values) {
  const auto family = static_cast<double>(evidence.family());
  std::vector<MeanDifference> result;
  for (MeanDifference& pair : all_pairs<MeanDifference>(values.size())) {
    if (evidence.reference && pair.first != *evidence.reference && pair.second != *evidence.reference) continue;
    const PairedTest test = paired_t(values[pair.first], values[pair.second], 1 - evidence.plan.significance / family);
    pair.difference = test.difference;
    pair.p = std::isnan(test.p) ? test.p : std::min(1.0, family * test.p);
    pair.low = test.low;
    pair.high = test.high;
    pair.undefined = test.undefined;
    result.push_back(std::move(pair));
  }
  return result;
}

}  // namespace

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
  const int resamples = resamples_of(evidence);
  if (evidence.blocks == 0) {
    tests.bootstrapped = studentized_bootstrap(values, family, {.resamples = resamples, .level = level});
  } else if (resamples > 0) {
    tests.bootstrapped = bootstrap_within_blocks(values, family, {.resamples = resamples, .level = level});
  } else {
    tests.bootstrapped = paired_tests(evidence, values);
  }
  return tests;
}

int resamples_of(const Evidence& evidence) {
  if (evidence.blocks > 0) {
    const std::size_t pairs = evidence.groups.size() * (evidence.groups.size() - 1) / 2;
    return affordable_resamples(evidence.blocks * pairs, evidence.groups.size(), 1 - evidence.plan.significance);
  }
  std::size_t values = 0;
  for (const GroupEvidence& group : evidence.groups) values += static_cast<std::size_t>(group.described.n);
  return affordable_resamples(values, evidence.groups.size(), 1 - evidence.plan.significance);
}

}  // namespace ikbench::inference
