// The figures of Slim et al. (2023): of its helix 5 the path with the arm, 6 to 8 error, variation and time by point,
// 9 the joint angles, 10 to 12 box plots beside the printed numbers; of its circle 14 it from above, 15 in space, 16
// the joint angles, 17 the error by point beside Table 8's, 18 the mean error by iteration.
#pragma once

#include <vector>

#include "analysis/compare/judge.hpp"
#include "analysis/figures/of_study.hpp"

namespace ikbench::slim2023 {

// Those of the study's path; none if nothing was solved.
std::vector<figures::Figure> figures_of(const compare::JudgedStudy& judged, const figures::Look& look);

}  // namespace ikbench::slim2023
