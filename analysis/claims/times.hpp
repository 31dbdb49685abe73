// The times of solves until they reach the study's tolerance, at random targets.
#pragma once

#include <string>
#include <vector>

#include "analysis/claims/printed.hpp"
#include "analysis/inference/study.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::claims {

// The times of one solver of a study.
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

// Compares the printed mean and maximum with that limit.
std::string printed_words(const PrintedTime& printed, double limit_ms);

}  // namespace ikbench::claims
