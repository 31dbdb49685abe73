// Describes how the error of solves falls with their cost: quantiles over solves, costs to reach an error after COCO
// (Hansen et al. 2021, doi 10.1080/10556788.2020.1808977), performance profiles after Dolan and Moré (2002, doi
// 10.1007/s101070100263). Where a solve has no improvements stored, iteration i of n stands for i/n of what it cost.
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "analysis/inference/metrics.hpp"
#include "analysis/inference/study.hpp"

namespace ikbench::inference {

// The cost of a target that is not reached, and the error of an answer that is not finite.
constexpr double censored = std::numeric_limits<double>::infinity();

// `cost`, here and below: Metric::evaluations or Metric::seconds. Censored where it is not finite; 0 where it is
// negative.
double total_cost(const StudyResults& study, const Solve& solve, Metric cost);

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
std::vector<Step> course_of(const StudyResults& study, const Solve& solve);
// The end of every iteration: the course that decides.
std::vector<Step> iterations_of(const StudyResults& study, const Solve& solve);
bool has_improvements(const Solve& solve);

// The error as the verifier has it [cm]; censored where it is not finite.
double final_error_cm(const Solve& solve);

// The angle at which a solve of the study ends; infinite unless poses are searched.
double tolerance_deg(const StudyResults& study);

// Returns the cost of the solve when its best error first was at or below each target; targets descend. A solve whose
// answer is not finite, refused or not as good as claimed reaches none, because its trace is only the solver's word.
std::vector<double> costs_to_targets(const StudyResults& study, const Solve& solve, std::span<const double> targets_cm,
                                     Metric cost, std::span<const Step> course);

// Returns at each number of evaluations the median and the 25 and 75 % quantiles (Hyndman and Fan's type 5) of the best
// error [cm], censored if too few solves have an answer yet. A solve that has ended keeps its last error.
std::vector<statistics::Estimate> error_bands(const StudyResults& study, const Solves& traces,
                                              std::span<const double> evaluations);
// Log-spaced, from the earliest first step to the dearest solve; empty without courses.
std::vector<double> evaluations_axis(const StudyResults& study, const std::vector<Solves>& traces);

// 51 log-spaced errors [cm], descending: from 10 (or ten times a larger tolerance) down to the tolerance of the study,
// or without one to the whole decade below the smallest error of any solve, but not below 1e-8.
std::vector<double> target_errors_cm(const StudyResults& study);

// The share of values that are at or below `at`. Its interval, if it has one, is made by clusters.hpp.
struct Share {
  double at;
  double share;
  double low = statistics::not_defined;
  double high = statistics::not_defined;
};

// The empirical distribution function, at every value or at 200 log-spaced ones. Censored values count in
// the whole and nowhere else.
std::vector<Share> shares_within(std::vector<double> values);

// The cost of each solver divided by the smallest of all solvers at the same problem. A problem is a point of a run.
// Solvers without solves take no part and have no ratios.
struct Profile {
  std::vector<std::vector<double>> ratios;  // of each solver at each problem; censored where it fails
  Solves solves;                            // one solver's of each problem
  int problems = 0;
  int left_out = 0;  // where a solver has no solve, or another target
  int unsolved = 0;  // of the problems: where every solver fails
  bool has_zero_costs = false;
};

// The cost of a solve, censored where it fails. 0/0 is 1; a cost above a smallest of 0 is infinitely many times as
// much.
using CostOf = std::function<double(const Solve&)>;
Profile performance_profile(const StudyResults& study, const CostOf& cost_of);

// Says in a sentence how often each solver comes closest to the target. Means over runs do not show it, because the
// worst points decide them. Empty if fewer than two solvers share a problem, and if solves end at a tolerance, because
// within it solvers are the same.
std::string closest_point_by_point(const StudyResults& study);

}  // namespace ikbench::inference
