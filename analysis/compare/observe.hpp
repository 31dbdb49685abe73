// The one door from solves to numbers that are compared: what is odd becomes a doubt here, and what passes is finite.
#pragma once

#include <string>
#include <vector>

#include "analysis/compare/metrics.hpp"
#include "analysis/compare/study.hpp"

namespace ikbench::compare {

enum class DoubtKind {
  runs_missing,
  without_answer,
  claimed_but_wrong,
  outside_limits,
  budgets_differ,
  times_not_comparable,
  out_of_reach,
  too_few,
  few_decide_mean,
  plan_changed,
  repeats_itself,
  other_version,
};

struct Doubt {
  DoubtKind kind;
  std::vector<std::string> who = {};  // solvers
  double count = 0, of = 0;           // 3 of 20
  std::string what = {};              // why, in a few words: "solved in parallel"
};

// A line: "times of mine are not compared: the machine was busy in 100 of 100 solves".
std::string words_of(const Doubt& doubt);

bool gave_answer(const results::SolveRecord& solve);

// Of all that concerns more than one metric.
std::vector<Doubt> doubts_of(const StudyResults& study);

struct Observed {
  Observations observations;
  std::vector<Doubt> doubts = {};
};

// One observation is the mean of a run over its targets where solves are chained (of times the median); else a target,
// its mean over the runs.
Observed observe(const StudyResults& study, const Metric& metric);

}  // namespace ikbench::compare
