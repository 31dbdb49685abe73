// Compares variants repeatedly while their runs grow, by a boundary that keeps the error rate over all looks.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/inference/variants.hpp"

namespace ikbench::inference {

// The looks, planned before the runs are seen: after `step` runs, 2 `step`, ..., `most`.
struct Looks {
  int step = 5;
  int most = 50;
};
constexpr int most_looks = 20;
// Throws std::invalid_argument unless there are 1 to most_looks looks, each at 2 runs or more, the last after all runs.
void check_looks(const Looks& looks);

// settled: something is worse, or nothing is open. at_limit: neither, after `most` runs. open: more runs are needed.
enum class LookState { settled, open, at_limit };

struct SequentialComparison {
  std::vector<VariantComparison> comparisons;  // those of the look that settles, or of the last look
  int runs = 0;                                // number of runs at that look
  LookState state = LookState::open;
};

// Calls compare_variants on the first runs of both at each look, at the look's level
// (analysis/statistics/group_sequential.hpp), so that all looks together make false findings as rarely as a single one.
// A decision of a look stays. Later runs than the settling look's are ignored, so the answer does not depend on them.
// Throws std::invalid_argument as check_looks does, if more runs give no more observations (targets of a path, each
// solved alone), or if the first look lacks complete runs.
SequentialComparison compare_sequentially(std::span<const VariantStudy> studies, std::span<const std::string> metrics,
                                          const Looks& looks);

}  // namespace ikbench::inference
