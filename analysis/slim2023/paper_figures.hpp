// The figures of Slim et al. (2023) for any study: 5 the path, 6-8 error, variation and time per point, 9 the joint
// angles of each solver's first run, 10-12 box plots over the run means; for a circle also 14-18 (circle_figures.hpp).
#pragma once

#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/statistics/quantile.hpp"

namespace ikbench::slim2023 {

figures::Figure path_figure(const inference::StudyResults& study);                              // figure-5
figures::Figure curves_figure(const inference::StudyResults& study, inference::Metric metric);  // figure-6, 7, 8
std::vector<figures::Figure> joint_figures(
    const inference::StudyResults& study);  // figure-9-a, figure-9-b, ...: one per solver that has solves

struct BoxRequest {
  inference::Metric metric = inference::Metric::position_error_cm;
  results::Unit unit = results::Unit::run;
  statistics::QuantileType quartiles = statistics::QuantileType::type_5;  // MATLAB's, as the paper's
};
figures::Figure box_figure(const inference::StudyResults& study, const BoxRequest& request);  // figure-10, 11, 12

// All of them in the paper's order; none where nothing was solved.
std::vector<figures::Figure> paper_figures(const inference::StudyResults& study, results::Unit unit,
                                           statistics::QuantileType quartiles);

}  // namespace ikbench::slim2023
