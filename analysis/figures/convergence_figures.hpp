// Figures of how errors fall, and how many solves succeed, with the evaluations (analysis/inference/convergence.hpp).
#pragma once

#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::figures {

// "statistics-convergence" of a study with traces, and "statistics-solved-evaluations" of one with a tolerance. None if
// there are no solves.
std::vector<Figure> convergence_figures(const inference::StudyResults& study);

}  // namespace ikbench::figures
