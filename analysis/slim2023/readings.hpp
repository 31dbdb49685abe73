// Readings of a paper held against its printed Table 3: which one moves which number, and how far from the paper.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::slim2023 {

// One solver under one reading: by seed, a value a run.
struct ReadSolver {
  std::string label;
  bool is_moved = true;  // else its solves are those of the default, bit for bit
  std::vector<std::vector<double>> error_cm;
  std::vector<std::vector<double>> variation_deg;
};

struct ReadingResults {
  std::string name;
  std::string section = {};   // of docs/paper-notes.md
  std::string sentence = {};  // what it means
  int out_of_reach = 0;       // targets that no configuration reaches
  std::vector<ReadSolver> solvers = {};
};

struct ReadingsReport {
  report::Table table;     // "readings"
  figures::Figure figure;  // "readings"
};

// The first of the readings is the default, by which the others are measured. std::invalid_argument where there is
// none.
ReadingsReport readings_report(std::string_view paper, std::span<const ReadingResults> readings);

}  // namespace ikbench::slim2023
