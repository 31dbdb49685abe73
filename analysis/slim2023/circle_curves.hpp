// Figures 16 to 18 of Slim et al. (2023), for a study whose path is a circle: 16 the joint angles, 17 the error at each
// point, 18 the average error over the iterations. The study has solves.
#pragma once

#include "analysis/figures/figure.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::slim2023 {

figures::Figure circle_joints_figure(const inference::StudyResults& study);  // figure-16
figures::Figure circle_errors_figure(const inference::StudyResults& study);  // figure-17
figures::Figure convergence_figure(const inference::StudyResults& study);    // figure-18; wants a trace

}  // namespace ikbench::slim2023
