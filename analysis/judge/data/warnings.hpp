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
  misreported,             // a solver says another error than its answer has
  time_limit_decides,      // what is reached in a limit of time, on a busy machine or several
  budgets_differ,          // evaluations that solvers may make
  counts_not_comparable,   // evaluations: by the solver itself, or by nobody
  limit_violations,        // answers
  no_answer,               // solves, or infinite values of a file
  times_not_comparable,    // measured in parallel, in too few sessions or apart, or on a busy machine
  unreachable_targets,     // targets
  deterministic,           // every run gave the same, so they count as one
  dominated_by_few,        // one value is most of a sum
  ranks_disagree,          // better by ranks, worse by its median or mean
  favoured_by_drop,        // rows of a file are left out, and solvers lack different shares of them
  may_be_one_measurement,  // every block of a file has the same values
};

struct Warning {
  WarningKind kind;
  std::vector<std::string> solvers = {};  // solvers
  double count = 0, total = 0;            // 3 of 20
  std::string detail = {};                // why, in a few words: "solved in parallel"
};

// A line: "times of mine are not compared: the machine was busy in 100 of 100 solves".
std::string warning_text(const Warning& warning);

// Of all that concerns more than one metric.
std::vector<Warning> study_warnings(const StudyResults& study);
// Of one: whom these name is not compared in it; all, if none is named.
std::vector<Warning> time_warnings(const StudyResults& study);
// What solvers reach in seconds depends on the load.
std::vector<Warning> clock_warnings(const StudyResults& study);
// The same, and whose evaluations are not ours to compare.
std::vector<Warning> evaluation_warnings(const StudyResults& study);

}  // namespace ikbench::judge
