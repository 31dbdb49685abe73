// The tests of means of every pair, of which the plan lets one decide.
#pragma once

#include <span>
#include <vector>

#include "analysis/inference/evidence.hpp"
#include "analysis/statistics/multiple_comparisons.hpp"

namespace ikbench::inference {

// Of the pairs that are shown, in their order.
struct TestsOfMeans {
  std::vector<statistics::MeanDifference> pooled, unpooled, by_tamhane;
  std::vector<statistics::MeanDifference> bootstrapped;  // only where it decides, because it takes its time

  // What the plan's test has of a pair; Games-Howell's where ranks decide.
  const statistics::MeanDifference& deciding(results::DecidingTest test, std::size_t pair) const;
};

// Groups, plan and reference of the evidence are there. No values: only summaries are known.
TestsOfMeans tests_of_means(const Evidence& evidence, std::span<const statistics::GroupSummary> summaries,
                            std::span<const std::vector<double>> values);

// Of the bootstrap, for so many values and groups; 0 where they are too many.
int resamples_of(const Evidence& evidence);

}  // namespace ikbench::inference
