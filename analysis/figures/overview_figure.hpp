// A study at a glance: the cost of each solver's accuracy in joint movement and in time.
#pragma once

#include <string>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::figures {

// The means of a solver as a paper printed them.
struct OverviewMark {
  std::string solver;
  double error_cm, variation_deg, seconds;
};

// "overview": one disc per solver, mean position error against mean angles variation; its area is the computing time
// relative to the slowest. Printed means are rings, relative to the slowest printed.
Figure overview_figure(const inference::StudyResults& study, const std::vector<OverviewMark>& printed);

}  // namespace ikbench::figures
