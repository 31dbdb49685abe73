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
  results::AnalysisPlan plan;  // the study's plan
};

// Shows progress. Returns nothing if it was cancelled: shares need all universes.
std::optional<SolvedMultiverse> solved_multiverse(const std::string& study,
                                                  const std::vector<results::Dimension>& varied,
                                                  experiments::MultiverseRequest request,
                                                  const SeriesArguments& arguments);

}  // namespace ikbench::cli
