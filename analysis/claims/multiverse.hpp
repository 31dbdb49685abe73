// The claims of a paper between solvers in every universe of its open points, and its printed numbers beside theirs.
#pragma once

#include "analysis/claims/claims_file.hpp"
#include "analysis/inference/multiverse.hpp"
#include "analysis/report/paper.hpp"

namespace ikbench::claims {

// Throws std::invalid_argument if there is no universe, or none has the paper's own solver.
report::MultiverseReport multiverse_report(const ClaimsFile& file, const inference::Multiverse& multiverse,
                                           const results::AnalysisPlan& plan);

}  // namespace ikbench::claims
