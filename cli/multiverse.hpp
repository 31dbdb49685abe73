// Solves all combinations of what a paper leaves open, for `ikbench multiverse` and for the report of `ikbench
// reproduce`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/inference/multiverse.hpp"
#include "cli/series.hpp"
#include "experiments/multiverse.hpp"

namespace ikbench::cli {

struct SolvedMultiverse {
  inference::Multiverse multiverse;
  results::AnalysisPlan plan;  // of the study
};

// With progress; none where it was cancelled: a share of some of the universes is no share.
std::optional<SolvedMultiverse> solved_multiverse(const std::string& study,
                                                  const std::vector<results::Dimension>& varied,
                                                  experiments::MultiverseRequest request,
                                                  const SeriesArguments& arguments);

}  // namespace ikbench::cli
