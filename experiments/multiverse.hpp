// All combinations of what a paper leaves open, and the series to solve to judge claims in each of them.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "experiments/dimensions.hpp"

namespace ikbench::experiments {

struct MultiversePlan : results::Multiverse {
  // One solver and one seed each, each series once, in the order of first need. The series key of a solver decides its
  // numbers, so choices that do not change the key share a part.
  std::vector<Study> parts;
};

// Counts before anything is loaded or solved. Throws std::invalid_argument for more than 100000 choices or series per
// seed, or more than 10^15 readings.
struct MultiverseSize {
  std::int64_t studies = 0, series = 0, readings = 0;
};
MultiverseSize size_of(const std::vector<results::Dimension>& dimensions, const std::vector<std::string>& solvers);

struct MultiverseRequest {
  int seeds = 1;                                 // seeds 1, 2, ...
  Overrides overrides = {};                      // apply in every reading
  const std::atomic<bool>* cancelled = nullptr;  // set: the plan is incomplete and of no use
};

// Throws std::invalid_argument for an override of the seed or of a dimension.
void refuse_varied(const Overrides& overrides, const std::vector<results::Dimension>& dimensions);

// Checks the overrides, too.
MultiversePlan plan_multiverse(const std::string& study, const std::vector<results::Dimension>& dimensions,
                               const MultiverseRequest& request = {});

}  // namespace ikbench::experiments
