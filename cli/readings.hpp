// Solves the readings of a paper's study, for `ikbench readings` and for the report of `ikbench reproduce`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/report/paper.hpp"
#include "cli/series.hpp"
#include "experiments/readings.hpp"

namespace ikbench::cli {

struct Read {
  std::optional<report::ReadingsReport> report = {};  // none where not even the default was finished
  std::size_t done = 0;                               // combinations, counting the default
  bool is_complete = false;                           // else it was cancelled
};

Read read(const report::Paper& paper, const experiments::ReadingsPlan& plan, const SeriesArguments& arguments);

// The run means of a plan without an interpretation, by seed; none where it was cancelled.
std::vector<report::ReadSolver> repetitions(const experiments::ReadingsPlan& plan, const SeriesArguments& arguments);

}  // namespace ikbench::cli
