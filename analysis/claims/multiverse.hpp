// The claims of a paper between solvers in every universe of what the paper leaves open.
#pragma once

#include "analysis/claims/claims_file.hpp"
#include "analysis/inference/multiverse.hpp"
#include "analysis/report/multiverse.hpp"

namespace ikbench::claims {

// Those that the file has every universe judge.
std::vector<inference::MultiverseClaim> claims_in_universes(const ClaimsFile& file);

// std::invalid_argument where there is no universe, or none has the paper's own solver.
report::MultiverseReport multiverse_report(const ClaimsFile& file, const inference::Multiverse& multiverse,
                                           const results::AnalysisPlan& plan);

}  // namespace ikbench::claims
