// Figures 14 to 18 of Slim et al. (2023), for a study whose path is a circle: 14 the circle in the plane, 15 in space
// with the arm, 16 the joint angles, 17 the error at each point, 18 the average error over the iterations.
#pragma once

#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::slim2023 {

figures::Figure circle_plane_figure(const inference::StudyResults& study);   // figure-14
figures::Figure circle_space_figure(const inference::StudyResults& study);   // figure-15
figures::Figure circle_joints_figure(const inference::StudyResults& study);  // figure-16
figures::Figure circle_errors_figure(const inference::StudyResults& study);  // figure-17
figures::Figure convergence_figure(const inference::StudyResults& study);    // figure-18; wants a trace

// All of them, without figure-18 where no solve has a trace; none where the path is no circle or nothing was solved.
std::vector<figures::Figure> circle_figures(const inference::StudyResults& study);

}  // namespace ikbench::slim2023
