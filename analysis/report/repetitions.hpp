// A study solved again with other seeds.
#pragma once

#include <string>
#include <vector>

namespace ikbench::report {

// Results of one solver: by seed, one value per run.
struct RepeatedSolver {
  std::string label;
  std::vector<std::vector<double>> error_cm;
  std::vector<std::vector<double>> variation_deg;
};

}  // namespace ikbench::report
