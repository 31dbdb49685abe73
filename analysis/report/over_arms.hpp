// The verdict of studies that are reported together over their arms: an arm is one observation of each solver.
#pragma once

#include <span>

#include "analysis/report/rates.hpp"
#include "analysis/report/sentence.hpp"
#include "analysis/report/table.hpp"
#include "results/analysis_plan.hpp"

namespace ikbench::report {

struct OverArms {
  Table table;        // over-arms: a row for each pair of solvers
  Sentence sentence;  // who solves more, over all arms; empty if fewer than three arms have all solvers
};

// Judges the shares of solved poses with arms as blocks. The plan's significance, adjustment and margin count; its test
// does not, because the question is about means over arms.
OverArms over_arms(std::span<const RatesOfArm> arms, const results::AnalysisPlan& plan);

}  // namespace ikbench::report
