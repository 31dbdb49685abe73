// Each alternative of what the paper leaves open by itself: what it does to the printed means and to the claims.
#pragma once

#include "analysis/claims/claims_file.hpp"
#include "analysis/inference/multiverse.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::claims {

// Of a multiverse in which a universe has at most one choice that is not the default. std::invalid_argument where there
// is no universe.
report::Table one_at_a_time(const ClaimsFile& file, const inference::Multiverse& multiverse,
                            const results::AnalysisPlan& plan);

}  // namespace ikbench::claims
