// Solving, with progress and warnings, for the commands that do it.
#pragma once

#include <filesystem>
#include <string>

#include "cli/options.hpp"
#include "experiments/runner.hpp"
#include "results/store.hpp"

namespace ikbench::cli {

struct RunArguments {
  std::string out;
  int jobs = 1;
};

void add_run_options(const Command& command, RunArguments& arguments);

// Runs a study, and its to_stored, into the folder's store.sqlite, opened in this mode, with progress, and warns of
// targets out of reach. Returns "six: 288 solves in out/six/store.sqlite"; after Ctrl-C it says how to continue, and
// throws Cancelled.
std::string run_study(const experiments::Study& study, const results::StoredStudy& stored,
                      const std::filesystem::path& folder, experiments::RunRequest request,
                      results::Store::Mode mode = results::Store::Mode::write);

std::filesystem::path store_path(const std::filesystem::path& folder);

}  // namespace ikbench::cli
