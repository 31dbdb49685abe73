// Solves all combinations of what a paper leaves open, for `ikbench multiverse` and for the report of `ikbench
// reproduce`.
#pragma once

#include <optional>

#include "analysis/report/paper.hpp"
#include "cli/series.hpp"
#include "experiments/multiverse.hpp"

namespace ikbench::cli {

// None where it was cancelled: a share of some of the universes is no share.
std::optional<report::MultiverseReport> judged_universes(const report::Paper& paper,
                                                         const experiments::MultiversePlan& plan,
                                                         const SeriesArguments& arguments);

}  // namespace ikbench::cli
