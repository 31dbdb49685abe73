// The printed table of solve rates, and what the studies of the same arms give.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "analysis/inference/judge.hpp"
#include "analysis/report/paper.hpp"
#include "analysis/statistics/proportion.hpp"

namespace ikbench::beeson2015 {

// Which of the table's two solvers that are here: KDL's Newton steps, without and with random restarts.
struct Rate {
  double printed = statistics::not_defined;  // share of solved poses
  statistics::Proportion ours = {};          // with Wilson's interval at 99 %
};

// How many iterations fit into the paper's 5 ms is not known: the same solves, ended after fewer iterations.
constexpr std::array<int, 4> budgets{25, 50, 100, 200};
struct Budgets {
  std::array<statistics::Proportion, budgets.size()> ours = {};
  // Within how many iterations our interval has the printed share; 0 where it never has.
  int first = 0, last = 0;
};

struct ArmRates {
  std::string arm;  // as the table has it
  Rate kdl, kdl_rr;
  Budgets kdl_within = {};
  double trac_ik = statistics::not_defined;  // as printed
  inference::Judgement restarts = {};        // KDL-RR held against KDL on the same poses
};

// Of the study and its companions, in their order; an arm without solves is left out.
std::vector<ArmRates> solve_rates(const report::Reported& reported);

// Whether the printed share is inside our interval.
bool agrees(const Rate& rate);

report::Table solve_rates_table(const std::vector<ArmRates>& arms);
report::Table iterations_table(const std::vector<ArmRates>& arms);
// The printed shares beside ours, a row an arm.
figures::Figure solve_rates_figure(const std::vector<ArmRates>& arms);

}  // namespace ikbench::beeson2015
