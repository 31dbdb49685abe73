// The printed table of solve rates, and what the studies of the same arms give.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "analysis/inference/judge.hpp"
#include "analysis/report/paper.hpp"
#include "analysis/statistics/proportion.hpp"

namespace ikbench::beeson2015 {

// How many iterations fit into the paper's 5 ms is not known, so a rate is given for each of these: the same solves,
// ended earlier.
constexpr std::array<int, 5> budgets{25, 50, 100, 200, 500};

// The share of poses that one solver of the table solves on one arm.
struct Rate {
  double printed = statistics::not_defined;
  statistics::Proportion ours = {};  // in all iterations, with Wilson's interval at 99 %
  std::array<statistics::Proportion, budgets.size()> within = {};
  // Our interval contains the printed share within so many iterations; 0 if it never does.
  int first = 0, last = 0;
};

struct ArmRates {
  std::string arm;                           // as the table has it
  Rate kdl = {}, kdl_rr = {};                // KDL's Newton steps, without and with random restarts
  int iterations = 0;                        // most of a solve
  double trac_ik = statistics::not_defined;  // as printed
  inference::Judgement restarts = {};        // KDL-RR held against KDL on the same poses
};

// One row for each arm of the study and its companions, in their order; an arm without solves is left out.
std::vector<ArmRates> solve_rates(const report::Reported& reported);

// Whether the printed share is inside our interval.
bool agrees(const Rate& rate);

report::Table solve_rates_table(const std::vector<ArmRates>& arms);
report::Table iterations_table(const std::vector<ArmRates>& arms);
// The printed shares beside ours, a row an arm.
figures::Figure solve_rates_figure(const std::vector<ArmRates>& arms);

}  // namespace ikbench::beeson2015
