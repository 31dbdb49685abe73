// Printed tables with one row per solver, each number beside the same statistic of our solves.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "analysis/report/paper.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::claims {

// A table of results/published: the column `solver`, and statistics of solves by name (row_agreement.cpp).
struct PrintedTable {
  std::string study, table, caption;
  std::string beside = {};    // a companion with the same targets, which has the solvers that the study lacks
  std::string times_to = {};  // the solver by whose mean time the printed ones (column us_mean) and ours are divided
  std::map<std::string, std::string> not_attempted = {};  // why a printed row is not repeated, by its solver
};

// How the printed numbers agree with ours, by rows.
struct RowAgreement {
  int every_digit = 0, by_rounding = 0, by_chance = 0, outside = 0, not_attempted = 0;
};

struct ComparedRows {
  std::vector<report::Table> tables = {};  // rows-TABLE for each printed table whose study has solves
  RowAgreement found = {};
};

// Compares the tables with the solves of the study and its companions. A number agrees if ours rounds to its digits;
// else it is held against the range of rounding (last_bits.hpp), and then against the central 95 % of what other
// targets would give, by a bootstrap of targets.
ComparedRows compared_rows(const report::Reported& reported, const std::string& paper,
                           const std::vector<PrintedTable>& tables);

// "13 of 24 printed rows agree in every digit, ..."; empty without rows.
std::string agreement_sentence(const RowAgreement& found);

}  // namespace ikbench::claims
