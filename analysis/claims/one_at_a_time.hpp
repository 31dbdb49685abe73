// Each alternative of a paper's open points by itself: its effect on the printed means and on the claims.
#pragma once

#include "analysis/claims/claims_file.hpp"
#include "analysis/inference/multiverse.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::claims {

// Needs a multiverse in which a universe has at most one choice that is not the default. Throws std::invalid_argument
// if there is no universe.
report::Table one_at_a_time(const ClaimsFile& file, const inference::Multiverse& multiverse,
                            const results::AnalysisPlan& plan);

}  // namespace ikbench::claims
