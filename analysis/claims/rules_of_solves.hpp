// Rules for claims about the solves of one solver: at each point, about its joints and its times, about its work
// without one of its equations, and about the poses that it solves on the arm of each study that is reported together.
#pragma once

#include "analysis/claims/case.hpp"

namespace ikbench::claims {

// Its metric, averaged over the runs, is the smallest at each point.
Claims least_at_each_point(const Case& of);
// No answer has a joint outside its limits.
Claims inside_limits(const Case& of);
// Its metric is smaller than in the companion that goes without something; fails if no answer changes.
Claims has_effect(const Case& of);
// The claim's solvers reach the tolerance within the limit at every target; in part, if their median times are within
// it. Or they are too slow: their median times exceed it. From the study or the first companion that has them and a
// tolerance.
Claims in_time(const Case& of);
Claims too_slow(const Case& of);
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
