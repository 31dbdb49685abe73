// Solves all combinations of what a paper leaves open, for `ikbench multiverse` and for the report of `ikbench
// reproduce`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/papers/multiverse.hpp"
#include "experiments/multiverse.hpp"
#include "experiments/series_means.hpp"

namespace ikbench::cli {

struct SeriesArguments {
  std::string title;             // title of the progress
  std::filesystem::path folder;  // folder of series.csv, which keeps finished series
  int jobs = 1;
};

// Shows progress. Returns nothing if the request was cancelled: shares need all readings.
std::optional<papers::Multiverse> solved_multiverse(const std::string& study,
                                                    const std::vector<results::Dimension>& varied,
                                                    const experiments::MultiverseRequest& request,
                                                    const SeriesArguments& arguments);

}  // namespace ikbench::cli
