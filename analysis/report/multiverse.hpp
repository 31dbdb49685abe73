// A paper's report on its multiverse: shares of its claims, tables and the specification curve.
#pragma once

#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/report/claims.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

struct MultiverseReport {
  std::vector<ClaimShares> claims;
  std::vector<std::string> sentences = {};    // compare the printed numbers with the universes
  std::vector<Table> tables = {};             // "multiverse", "multiverse-alternatives", "multiverse-printed", ...
  std::vector<figures::Figure> figures = {};  // "multiverse"
};

}  // namespace ikbench::report
