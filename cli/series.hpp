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
  std::string title;             // title of the progress
  std::filesystem::path folder;  // folder of series.csv, which keeps finished series; empty: none
  int jobs = 1;
  const std::atomic<bool>* cancelled = nullptr;
};

// Adds --seeds and --jobs; the variables hold the defaults.
void add_series_options(CLI::App& command, int& seeds, int& jobs);

// Shows progress. After Ctrl-C returns the series before the first missing one.
std::vector<experiments::RunMeans> solved(const std::vector<experiments::Study>& series,
                                          const SeriesArguments& arguments);

}  // namespace ikbench::cli
