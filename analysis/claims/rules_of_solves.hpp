// Rules for claims about the solves of one solver: at each point, about its joints and its times, and about its work
// without one of its equations.
#pragma once

#include <vector>

#include "analysis/claims/case.hpp"

namespace ikbench::claims {

// Its error, averaged over the runs, is the smallest at each point.
std::vector<report::Claim> least_at_each_point(const Case& of);
// No answer has a joint outside its limits.
std::vector<report::Claim> inside_limits(const Case& of);
// Its metric is smaller than in the companion that goes without something; fails if no answer changes.
std::vector<report::Claim> has_effect(const Case& of);
// Never decided; tells how near answers come to joints that are straight.
std::vector<report::Claim> singularities(const Case& of);
// The solver reaches the tolerance within the limit at every target; in part, if the median time is within it. The
// claim's solvers are slower: their median times exceed it. From the study or the first companion that has them and a
// tolerance.
std::vector<report::Claim> in_time(const Case& of);
std::vector<report::Claim> too_slow(const Case& of);
// The mean error of the first solver, on the claim's kind of path, is at most ten times the spacing of doubles at the
// farthest target.
std::vector<report::Claim> rounding_level(const Case& of);

// The largest distance of a study's target from the base [cm]; 0 if no target is known.
double farthest_target_cm(const inference::StudyResults& study);

}  // namespace ikbench::claims
