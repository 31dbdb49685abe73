// What the readings of a paper come to once they are solved, and what a paper makes of it.
#pragma once

#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

// One solver under one reading: by seed, a value a run.
struct ReadSolver {
  std::string label;
  bool is_moved = true;  // else its solves are those of the default, bit for bit
  std::vector<std::vector<double>> error_cm;
  std::vector<std::vector<double>> variation_deg;
};

struct ReadingResults {
  std::string name;
  std::string section = {};   // of the paper's notes
  std::string sentence = {};  // what it means
  int out_of_reach = 0;       // targets that no configuration reaches
  std::vector<ReadSolver> solvers = {};
};

struct ReadingsReport {
  Table table;             // "readings"
  figures::Figure figure;  // "readings"
};

}  // namespace ikbench::report
