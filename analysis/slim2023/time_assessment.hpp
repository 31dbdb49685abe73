// Table 7 of Slim et al. (2023): how long a solve takes until it comes to the tolerance, at random targets.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/inference/study.hpp"
#include "analysis/report/table.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::slim2023 {

constexpr double real_time_ms = 50;  // a solve that takes less leaves room for 20 a second

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
  int in_time = 0;  // reached the tolerance, and at the median speed in less than real_time_ms
};
std::vector<TimeAssessment> assess_times(const inference::StudyResults& study);

// What the printed mean and maximum say of real time.
std::string printed_real_time(const PrintedTime& printed);

// Nothing where the study is not one of random targets that is held against a printed Table 7.
std::optional<report::Table> table_7(const inference::StudyResults& study);

// What the tolerance costs, by expected running times with intervals, beside the paper's ratios.
// Nothing where there is no Table 7, the study has no tolerance, or times are not comparable.
std::optional<report::Table> table_7_cost(const inference::StudyResults& study);

// How many solves came to the tolerance in real time, and which did not; empty where there is no Table 7.
std::string real_time_verdict(const inference::StudyResults& study);

}  // namespace ikbench::slim2023
