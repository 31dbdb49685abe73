// The claims of a paper between solvers in every universe of its open points, and its printed numbers beside theirs.
#pragma once

#include "analysis/claims/claims_file.hpp"
#include "analysis/inference/multiverse.hpp"
#include "analysis/report/paper.hpp"

namespace ikbench::claims {

// Throws std::invalid_argument if there is no universe, or none has the paper's own solver.
report::MultiverseReport multiverse_report(const ClaimsFile& file, const inference::Multiverse& multiverse,
                                           const results::AnalysisPlan& plan);

// Each alternative of the open points by itself (one_at_a_time.cpp): its effect on the printed means and on the claims.
// Needs a multiverse in which a universe has at most one choice that is not the default. Throws std::invalid_argument
// if there is no universe.
report::Table one_at_a_time(const ClaimsFile& file, const inference::Multiverse& multiverse,
                            const results::AnalysisPlan& plan);

}  // namespace ikbench::claims
