// The paper's claims between solvers in every universe of what the paper leaves open.
#pragma once

#include <string_view>
#include <vector>

#include "analysis/inference/multiverse.hpp"
#include "analysis/report/multiverse.hpp"

namespace ikbench::slim2023 {

// Those that claims.toml has every universe judge.
std::vector<inference::MultiverseClaim> claims_in_universes();

// `paper` names the printed tables. std::invalid_argument where there is no universe.
report::MultiverseReport multiverse_report(std::string_view paper, const inference::Multiverse& multiverse,
                                           const results::AnalysisPlan& plan);

}  // namespace ikbench::slim2023
