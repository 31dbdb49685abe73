// Each alternative of what the paper leaves open by itself: what it does to the means of Table 3 and to the claims.
#pragma once

#include <string_view>

#include "analysis/inference/multiverse.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::slim2023 {

// Of a multiverse in which a universe has at most one choice that is not the default. std::invalid_argument where there
// is no universe.
report::Table one_at_a_time(std::string_view paper, const inference::Multiverse& multiverse,
                            const results::AnalysisPlan& plan);

}  // namespace ikbench::slim2023
