// Printed tables with one row per solver, each number beside the same statistic of our solves; and the lock of a paper,
// whose set-ups are held against such a table.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/report/paper.hpp"
#include "numerics/toml_table.hpp"

namespace ikbench::claims {

// A table of results/published: the column `solver`, and statistics of solves by name (row_agreement.cpp).
struct PrintedTable {
  std::string study, table, caption;
  std::string beside = {};    // a companion with the same targets, which has the solvers that the study lacks
  std::string times_to = {};  // the solver by whose mean time the printed ones (column us_mean) and ours are divided
  std::map<std::string, std::string> not_attempted = {};  // why a printed row is not repeated, by its solver
};

// Compares the tables with the solves of the study and its companions: a table rows-TABLE for each whose study has
// solves. A number agrees if ours rounds to its digits; else it is held against the range of rounding (last_bits.hpp),
// and then against the central 95 % of what other targets would give, by a bootstrap of targets. The sentence counts
// the rows.
report::StudyPieces compared_rows(const report::Reported& reported, const std::string& paper,
                                  const std::vector<PrintedTable>& tables);

// The lock as the paper's collection says it. Throws std::invalid_argument, also where a solver is not a row of the
// printed table.
report::Lock read_lock(numerics::TomlReader reader, const std::string& paper);

}  // namespace ikbench::claims
