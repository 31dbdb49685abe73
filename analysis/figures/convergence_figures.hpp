// Figures of the cost of an error: convergence, runtime distributions and performance profiles (methods and sources:
// analysis/inference/convergence.hpp).
#pragma once

#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::figures {

// "statistics-ecdf-error", and, as far as the study has
// - traces: "statistics-convergence", "statistics-ecdf-evaluations", and with comparable times
// "statistics-ecdf-seconds";
// - a tolerance: "statistics-solved-evaluations", and with comparable times "-seconds";
// - two solvers: "statistics-profile-evaluations" and with comparable times "-seconds" where there is a tolerance, else
//   "statistics-profile-error".
// None if there are no solves.
std::vector<Figure> convergence_figures(const inference::StudyResults& study);

}  // namespace ikbench::figures
