// Agreement with the printed Table 3: would a repetition of our study, with other random numbers, print this?
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/inference/study.hpp"
#include "analysis/report/repetitions.hpp"
#include "analysis/report/table.hpp"
#include "analysis/statistics/bootstrap.hpp"

namespace ikbench::slim2023 {

// One printed number of error or variation. The range is the 95 % predictive one of that statistic, from our study with
// other seeds.
struct Agreement {
  std::string solver;
  inference::Metric metric;
  std::string statistic;  // "mean", as a column of the printed table
  std::string printed;    // its digits
  double ours = statistics::not_defined;
  double ratio = statistics::not_defined;  // ours by the printed; not defined if that is 0
  statistics::Estimate expected = {};
  bool is_expected = false;  // a number that rounds to the printed digits is in the range
};

// Limit of ours by the printed, in both directions, for "near".
constexpr double near_ratio = 1.5;
report::Nearness nearness_of(double ratio);

// "in our range", "1.8 times, outside our range 0.6213 to 0.8254"
std::string words_of(const Agreement& agreement);
report::Nearness nearness_of(const Agreement& agreement);

// The agreement of each printed number of the repeated solvers. `repetitions` are the run means of the study by seed;
// empty if there are none.
std::vector<Agreement> agreements(const inference::StudyResults& study,
                                  std::span<const report::RepeatedSolver> repetitions);

// One block per metric, all five statistics of a solver in a row; nothing if there are no repetitions.
std::optional<report::Table> agreement_table(const inference::StudyResults& study,
                                             std::span<const report::RepeatedSolver> repetitions);

// The number of agreements in our range, and the ratios of the other means; empty if there are none.
std::string agreement_sentence(const std::vector<Agreement>& agreements);
// How many of our own numbers are outside our range, and how many would be by chance.
std::string own_sentence(const std::vector<Agreement>& agreements);

}  // namespace ikbench::slim2023
