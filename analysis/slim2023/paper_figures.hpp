// The figures of Slim et al. (2023) for any study: 5 the path, 6 to 8 error, variation and time per point, 9 the joint
// angles of each solver's first run, 10 to 12 box plots. For a study whose path is a circle also 14 the circle from
// above, 15 in space with the arm, 16 the joint angles, 17 the error at each point, 18 the average error over the
// iterations.
#pragma once

#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::slim2023 {

// Figures 14 to 18, without 16 if no answer has joints, without 18 if no solve has a trace; none if the path is no
// circle or nothing was solved.
std::vector<figures::Figure> circle_figures(const inference::StudyResults& study);

// All of them in the paper's order; none if nothing was solved.
std::vector<figures::Figure> paper_figures(const inference::StudyResults& study);

}  // namespace ikbench::slim2023
