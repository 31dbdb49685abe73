// How long solves take until they come to the study's tolerance, at random targets.
#pragma once

#include <string>
#include <vector>

#include "analysis/claims/printed.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::claims {

// Of a solve that comes to the tolerance, for which the verifier has a rounding of its own.
double most_error_cm(const inference::StudyResults& study);

// How long one solver of a study took.
struct TimeAssessment {
  std::string solver;
  statistics::Description time_ms = {};  // of all solves, at the solver's median speed (analysis/inference/times.hpp)
  statistics::Description reached_ms = {};  // of those alone that came to the tolerance, at the median speed
  double iterations_median = statistics::not_defined;
  double iterations_reached_median = statistics::not_defined;
  double evaluations_median = statistics::not_defined;
  int solves = 0;
  int never_reached = 0;
  int in_time = 0;  // reached the tolerance, and at the median speed in less than the limit
};
std::vector<TimeAssessment> assess_times(const inference::StudyResults& study, double limit_ms);

// What the printed mean and maximum say of that limit.
std::string printed_words(const PrintedTime& printed, double limit_ms);

}  // namespace ikbench::claims
