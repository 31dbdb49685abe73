// Figures 14 to 18 of Slim et al. (2023), for a study whose path is a circle: 14 the circle in the plane, 15 in space
// with the arm; 16 to 18 are of circle_curves.hpp.
#pragma once

#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::slim2023 {

figures::Figure circle_plane_figure(const inference::StudyResults& study);  // figure-14
figures::Figure circle_space_figure(const inference::StudyResults& study);  // figure-15

// All of them, without figure-18 if no solve has a trace; none if the path is no circle or nothing was solved.
std::vector<figures::Figure> circle_figures(const inference::StudyResults& study);

}  // namespace ikbench::slim2023
