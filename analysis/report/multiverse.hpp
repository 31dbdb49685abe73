// What a paper makes of its multiverse: shares of its claims, tables and the specification curve.
#pragma once

#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/report/claims.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

struct MultiverseReport {
  std::vector<ClaimShares> claims;
  std::vector<std::string> sentences = {};    // what the printed numbers say of the universes
  std::vector<Table> tables = {};             // "multiverse", "multiverse-alternatives", "multiverse-printed", ...
  std::vector<figures::Figure> figures = {};  // "multiverse"
};

}  // namespace ikbench::report
