// Solves the series that interpretations need, for `ikbench multiverse` and `reproduce`.
#pragma once

#include <CLI/CLI.hpp>
#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/series_means.hpp"

namespace ikbench::cli {

struct SeriesArguments {
  std::string title;             // of the progress
  std::filesystem::path folder;  // where series.csv keeps what is solved; empty: nowhere
  int jobs = 1;
  const std::atomic<bool>* cancelled = nullptr;
};

// --seeds and --jobs; what the variables hold is the default.
void add_series_options(CLI::App& command, int& seeds, int& jobs);

// With progress. After Ctrl-C those before the first that is missing.
std::vector<experiments::RunMeans> solved(const std::vector<experiments::Study>& series,
                                          const SeriesArguments& arguments);

}  // namespace ikbench::cli
