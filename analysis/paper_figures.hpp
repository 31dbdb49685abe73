// The figures of Slim et al. (2023) for any study: 5 the path, 6-8 error, variation and time per point, 9 the joint
// angles of each solver's first run, 10-12 box plots over the run means; for a circle also 14-18 (circle_figures.hpp).
#pragma once

#include <vector>

#include "analysis/figure.hpp"
#include "analysis/statistics/quantile.hpp"
#include "analysis/study.hpp"

namespace ikbench {

Figure path_figure(const StudyResults& study);                   // figure-5
Figure curves_figure(const StudyResults& study, Metric metric);  // figure-6, 7, 8
std::vector<Figure> joint_figures(
    const StudyResults& study);  // figure-9-a, figure-9-b, ...: one per solver that has solves

struct BoxRequest {
  Metric metric = Metric::position_error_cm;
  Unit unit = Unit::run;
  QuantileType quartiles = QuantileType::type_5;  // MATLAB's, as the paper's
};
Figure box_figure(const StudyResults& study, const BoxRequest& request);  // figure-10, 11, 12

// All of them in the paper's order; none where nothing was solved.
std::vector<Figure> paper_figures(const StudyResults& study, Unit unit, QuantileType quartiles);

}  // namespace ikbench
