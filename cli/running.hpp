// Solves studies for the commands `run` and `reproduce`, with a progress bar and warnings.
#pragma once

#include <filesystem>
#include <string>

#include "cli/options.hpp"
#include "experiments/runner.hpp"
#include "results/store.hpp"

namespace ikbench::cli {

// The options of a run, as given on the command line.
struct RunArguments {
  std::string out;  // folder; empty: out/NAME of the study
  int jobs = 1;     // solves at once
};

// Adds --out and --jobs.
void add_run_options(const Command& command, RunArguments& arguments);

// Runs what is missing of a study into the folder's store.sqlite, opened in this mode, and warns of unreachable
// targets. `stored` is `to_stored(study)`. Returns "six: 288 solves in out/six/store.sqlite". After Ctrl-C, prints how
// to continue, and throws Cancelled.
std::string run_study(const experiments::Study& study, const results::StoredStudy& stored,
                      const std::filesystem::path& folder, experiments::RunRequest request,
                      results::Store::Mode mode = results::Store::Mode::write);

// Returns the path of the store in a folder.
std::filesystem::path store_path(const std::filesystem::path& folder);

}  // namespace ikbench::cli
