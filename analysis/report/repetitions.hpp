// A study solved again with other seeds.
#pragma once

#include <string>
#include <vector>

namespace ikbench::report {

// One of its solvers: by seed, a value a run.
struct RepeatedSolver {
  std::string label;
  std::vector<std::vector<double>> error_cm;
  std::vector<std::vector<double>> variation_deg;
};

}  // namespace ikbench::report
