// The metrics that are more than a column of the record (metrics.inc): angles made of matrix norms, and what is said of
// a run as a whole. All are not defined where they have no meaning in the study.
#pragma once

#include "analysis/inference/metrics.hpp"

namespace ikbench::inference {

// Not defined of a solve without an answer.
inline double of_answer(const Solve& solve, double value) {
  return results::is_without_answer(solve.status) ? statistics::not_defined : value;
}

// Of the joints that slide.
double variation_m(const Solve& solve);

// Not defined where the study searches for positions alone.
double orientation_error_deg(const Solve& solve, const StudyResults& study);

// Mean, over the targets that are beyond the arm's reach, of the position error less its least possible value.
double excess_error_cm(Run run, const StudyResults& study);

// How the arm follows a path: from the first answer of a run to the last, without the move to the first point. Only
// where each solve has an answer and starts from the one before it, and the targets are a path rather than drawn one by
// one.
// Joints that turn and joints that slide are apart; only path_length_m is of those that slide.
double path_length_deg(Run run, const StudyResults& study);  // sum of the variations
double path_length_m(Run run, const StudyResults& study);
double largest_jump_deg(Run run, const StudyResults& study);  // of a single joint
double jumps(Run run, const StudyResults& study);  // moves in which a joint turns by more than the plan's jump_deg
// Mean of ||q_k+1 - 2 q_k + q_k-1|| over the inner points: 0 for angles that change evenly.
double second_difference_deg(Run run, const StudyResults& study);
// ||q_end - q_begin|| where the last target is the first one again, to 1e-9.
double return_deg(Run run, const StudyResults& study);

}  // namespace ikbench::inference
