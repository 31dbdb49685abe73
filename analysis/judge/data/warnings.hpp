// What is odd in the data, which a report says before its numbers are believed: who finds it, and its words, in one
// file.
#pragma once

#include <string>
#include <vector>

namespace ikbench::judge {

struct StudyResults;

// In the order of what they change.
enum class WarningKind {
  plan_changed,            // after solves were seen
  runs_missing,            // or rows of a file without a label
  incomplete,              // values of a file are missing
  stale_solves,            // another version of the program made solves, which are ignored
  claimed_but_wrong,       // a solver says another error than its answer has
  time_limit_decides,      // what is reached in a limit of time, on a busy machine or several
  budgets_differ,          // evaluations that solvers may make
  counts_not_comparable,   // evaluations: by the solver itself, or by nobody
  limit_violations,        // answers
  without_answer,          // solves, or infinite values of a file
  times_not_comparable,    // measured in parallel, in too few sessions or apart, or on a busy machine
  out_of_reach,            // targets
  repeats_itself,          // every run gave the same, so they count as one
  dominated_by_few,        // one value is most of a sum
  ranks_disagree,          // better by ranks, worse by its median or mean
  favoured_by_drop,        // rows of a file are left out, and solvers lack different shares of them
  may_be_one_measurement,  // every block of a file has the same values
};

struct Doubt {
  WarningKind kind;
  std::vector<std::string> who = {};  // solvers
  double count = 0, of = 0;           // 3 of 20
  std::string what = {};              // why, in a few words: "solved in parallel"
};

// A line: "times of mine are not compared: the machine was busy in 100 of 100 solves".
std::string words_of(const Doubt& doubt);

// Of all that concerns more than one metric.
std::vector<Doubt> doubts_of(const StudyResults& study);
// Of one: whom these name is not compared in it; all, if none is named.
std::vector<Doubt> time_warnings(const StudyResults& study);
// What solvers reach in seconds depends on the load.
std::vector<Doubt> clock_warnings(const StudyResults& study);
// The same, and whose evaluations are not ours to compare.
std::vector<Doubt> evaluation_warnings(const StudyResults& study);

}  // namespace ikbench::judge
