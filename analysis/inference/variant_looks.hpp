// Variants compared again and again while their runs grow, by a boundary that keeps the error rate over all looks.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/inference/variants.hpp"

namespace ikbench::inference {

// Planned before the runs are seen: after `step` runs, 2 `step`, ..., `most`.
struct Looks {
  int step = 5;
  int most = 50;
};
constexpr int most_looks = 20;
// std::invalid_argument where there are not 1 to most_looks of at least 2 runs each, the last after all runs.
void check_looks(const Looks& looks);

// settled: something is worse, or nothing is open. at_limit: neither, after `most` runs. open: more runs are needed.
enum class LookState { settled, open, at_limit };

struct SequentialComparison {
  std::vector<VariantComparison> comparisons;  // of the first look at which they are settled, or of the last
  int runs = 0;                                // what that look is of
  LookState state = LookState::open;
};

// As compare_variants on the first runs of both, look by look, at the level of each look
// (analysis/statistics/group_sequential.hpp), so that all looks together find what is not there as rarely as one. What
// a look has decided stays. Runs after the look that settles are not looked at: the same runs give the same answer,
// however many came later. std::invalid_argument where check_looks has it, more runs give no more observations (targets
// of a path, each solved alone), or the first look has not enough complete runs.
SequentialComparison compare_sequentially(std::span<const VariantStudy> studies, std::span<const std::string> metrics,
                                          const Looks& looks);

}  // namespace ikbench::inference
