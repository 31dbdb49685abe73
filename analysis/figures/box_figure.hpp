// Box plots of one metric, one box per solver.
#pragma once

#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::figures {

// Numbers of a solver from elsewhere, drawn in grey beside its box.
struct Mark {
  std::string solver;
  double min, median, max;
  double resolution = 0;  // a smallest value of 0 means: below this
};

// The plan gives unit and quartiles.
struct BoxRequest {
  std::string name;
  inference::Metric metric = inference::Metric::position_error_cm;
  std::vector<Mark> printed = {};
  std::string printed_words = "printed minimum, median and maximum";
};
Figure box_figure(const inference::StudyResults& study, const BoxRequest& request);

}  // namespace ikbench::figures
