// The figures of Slim et al. (2023) for any study: 5 the path, 6-8 error, variation and time per point, 9 the joint
// angles of each solver's first run, 10-12 box plots; for a circle also 14-18 (circle_figures.hpp).
#pragma once

#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::slim2023 {

// All of them in the paper's order; none if nothing was solved.
std::vector<figures::Figure> paper_figures(const inference::StudyResults& study);

}  // namespace ikbench::slim2023
