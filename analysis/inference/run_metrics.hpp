// Computes the metrics that are no column of the record (metrics.inc): angles from matrix norms, and metrics of a whole
// run. A metric without meaning in the study is not defined.
#pragma once

#include "analysis/inference/metrics.hpp"

namespace ikbench::inference {

// Returns the value, or not defined if the solve has no answer.
inline double of_answer(const Solve& solve, double value) {
  return results::is_without_answer(solve.status) ? statistics::not_defined : value;
}

// Variation of the prismatic joints [m].
double variation_m(const Solve& solve);
double instructions(const Solve& solve);  // not defined where they were not counted

// Not defined if the study searches for positions only.
double orientation_error_deg(const Solve& solve, const StudyResults& study);

// Mean, over the targets that are beyond the arm's reach, of the position error less its least possible value.
double excess_error_cm(Run run, const StudyResults& study);

// The metrics below describe how the arm follows a path, from the first answer of a run to the last, without the move
// to the first point. They need an answer to each solve, starts from the previous answer, and targets on a path. Only
// path_length_m takes prismatic joints; all others take revolute joints.
double path_length_deg(Run run, const StudyResults& study);  // sum of the variations
double path_length_m(Run run, const StudyResults& study);
double largest_jump_deg(Run run, const StudyResults& study);  // largest move of a single joint
double jumps(Run run,
             const StudyResults& study);  // number of moves in which a joint turns by more than the plan's jump_deg
// Mean of ||q_k+1 - 2 q_k + q_k-1|| over the inner points: 0 for angles that change evenly.
double second_difference_deg(Run run, const StudyResults& study);
// ||q_end - q_begin|| if the last target equals the first, within 1e-9.
double return_deg(Run run, const StudyResults& study);

}  // namespace ikbench::inference
