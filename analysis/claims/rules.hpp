// The rules that judge claims, and the claims of a paper judged by them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/claims/case.hpp"

namespace ikbench::claims {

// A rule returns no claim if the report has nothing to judge, and several if the sentence is about many: "{solver} on
// the {arm}".
struct NamedRule {
  std::string_view name;
  Claims (*rule)(const Case& of);
  bool needs_metrics = true;
};

const NamedRule* rule_named(std::string_view name);  // null if there is none of that name
std::vector<std::string> rule_names();

// The judged claims. For a study that is compared with the paper's means: all claims of the paper, untested ones
// included. Our claims, and claims about another study, only if there are numbers for them.
Claims judged(const ClaimsFile& file, const report::Reported& reported);

// Rules on a solver's means against others', of the study's numbers or the printed ones (rules_of_means.cpp).

// The solver's mean is the smallest in each of the claim's metrics. Of several solvers each is so against all others.
Claims smallest(const Case& of);
// All solvers in the printed order.
Claims ranking(const Case& of);
// The solver dominates the others: better in one of the metrics and worse in none.
Claims compromise(const Case& of);
// The solvers differ by one-way ANOVA, the paper's test, in all judged metrics.
Claims differ(const Case& of);
// The standard deviation over its runs is the smallest, by Brown and Forsythe's test of each pair, after Holm.
Claims least_spread(const Case& of);

// Rules on the solves of one solver (rules_of_solves.cpp).

// Its metric, averaged over the runs, is the smallest at each point.
Claims least_at_each_point(const Case& of);
// No answer has a joint outside its limits.
Claims inside_limits(const Case& of);
// Times of another program are not comparable: the ratios of the claim's solvers to its own one stand beside the
// printed ones, of the study or of the first companion that has them.
Claims ratios_of_times(const Case& of);
// Its metric is smaller than that of each of the claim's solvers of the companion, which go without something; fails
// against those whose answers are its own.
Claims has_effect(const Case& of);
// The claim's solvers reach the tolerance within the limit at every target; in part, if their median times are within
// it. From the study or the first companion that has them and a tolerance.
Claims in_time(const Case& of);
// The mean error of the first solver, on the claim's kind of path, is at most ten times the spacing of doubles at the
// farthest target.
Claims rounding_level(const Case& of);
// The printed share is inside the interval of ours: one claim per solver and arm, whose sentence has {solver}, {arm}
// and {share}. The verdict is "depends" if fewer iterations give the share, and as many give the other printed shares
// on this arm.
Claims rate_as_printed(const Case& of);
// The solver solves more than the one that it is compared with, or than all others, on every arm.
Claims solves_more(const Case& of);

// The times of one solver's solves until they reach the study's tolerance.
struct TimeAssessment {
  std::string solver;
  statistics::Description time_ms = {};  // of all solves, at the solver's median speed (analysis/inference/times.hpp)
  double iterations_median = statistics::not_defined;
  double evaluations_median = statistics::not_defined;
  int solves = 0;
  int never_reached = 0;
  int in_time = 0;  // reached the tolerance, and at the median speed in less than the limit
};
std::vector<TimeAssessment> assess_times(const inference::StudyResults& study, double limit_ms);

}  // namespace ikbench::claims
