// Figures 14 to 18 of Slim et al. (2023), for a study whose path is a circle: 14 the circle from above, 15 in space
// with the arm, 16 the joint angles, 17 the error at each point, 18 the average error over the iterations.
#pragma once

#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::slim2023 {

// All of them, without figure-16 if no answer has joints, without figure-18 if no solve has a trace; none if the path
// is no circle or nothing was solved.
std::vector<figures::Figure> circle_figures(const inference::StudyResults& study);

}  // namespace ikbench::slim2023
