// Describes how the error of solves falls with their evaluations, and the shares that were reached within some. Where a
// solve has no improvements stored, iteration i of n stands for i/n of its evaluations.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "analysis/inference/study.hpp"

namespace ikbench::inference {

// The cost of a target that is not reached, and the error of an answer that is not finite.
constexpr double censored = std::numeric_limits<double>::infinity();

double evaluations_of(const Solve& solve);  // 0 where it is negative

using Solves = std::vector<const Solve*>;
std::vector<Solves> solves_by_solver(const StudyResults& study);  // in the order of study.solvers

// Returns whether solves of a run may depend on each other: each may start at the answer of the one before.
bool is_chained(const StudyResults& study);

// Returns whether it is known how the solve went: it has a trace, or it ended before its first iteration.
bool has_trace(const Solve& solve);
const std::vector<double>& trace_cm(const Solve& solve);  // empty where it has none
// Returns the solves whose course is known; of poses those with improvements or a trace.
std::vector<Solves> traced_by_solver(const StudyResults& study);

// The best error of a solve after so many evaluations.
struct Step {
  double evaluations, error_cm;
};
// Every evaluation at which the best error became smaller, as stored; without these the end of every iteration.
std::vector<Step> course_of(const Solve& solve);
bool has_improvements(const Solve& solve);

// The angle at which a solve of the study ends; infinite unless poses are searched.
double tolerance_deg(const StudyResults& study);

// Returns at each number of evaluations the median and the 25 and 75 % quantiles (Hyndman and Fan's type 5) of the best
// error [cm], censored if too few solves have an answer yet. A solve that has ended keeps its last error; one whose
// answer is not finite, refused or not as good as claimed has none, because its trace is only the solver's word.
std::vector<statistics::Estimate> error_bands(const Solves& traces, std::span<const double> evaluations);
// Log-spaced, from the earliest first step to the dearest solve; empty without courses.
std::vector<double> evaluations_axis(const std::vector<Solves>& traces);

// The share of values that are at or below `at`.
struct Share {
  double at;
  double share;
};

// The empirical distribution function, at every value or at 200 log-spaced ones. Censored values count in
// the whole and nowhere else.
std::vector<Share> shares_within(std::vector<double> values);

}  // namespace ikbench::inference
