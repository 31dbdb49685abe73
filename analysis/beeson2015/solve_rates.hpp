// The printed table of solve rates, and what the studies of the same arms give.
#pragma once

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

struct ArmRates {
  std::string arm;  // as the table has it
  Rate kdl, kdl_rr;
  double trac_ik = statistics::not_defined;  // as printed
  inference::Judgement restarts = {};        // KDL-RR held against KDL on the same poses
};

// Of the study and its companions, in their order; an arm without solves is left out.
std::vector<ArmRates> solve_rates(const report::Reported& reported);

// Whether the printed share is inside our interval.
bool agrees(const Rate& rate);

report::Table solve_rates_table(const std::vector<ArmRates>& arms);
// The printed shares beside ours, a row an arm.
figures::Figure solve_rates_figure(const std::vector<ArmRates>& arms);

}  // namespace ikbench::beeson2015
