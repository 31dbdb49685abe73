// Warnings about the data, which a report shows before its numbers. All of them are found and worded in this file, so
// that each fault has one rule and one sentence. docs/reference/report.md lists them.
#pragma once

#include <string>
#include <vector>

namespace ikbench::judge {

struct StudyResults;

// The kinds of warnings, in the order of reports.
enum class WarningKind {
  plan_changed,            // the plan was changed after solves were made
  runs_missing,            // runs are missing or incomplete, or rows of a file have no label
  incomplete,              // values of a file are missing
  stale_solves,            // another version of the program made solves, which are ignored
  misreported,             // a solver reported another error than its answer has
  time_limit_decides,      // a time limit ended solves on a busy machine, or on several machines
  budgets_differ,          // solvers may make different numbers of evaluations
  counts_not_comparable,   // evaluations were counted by the solver itself, or not at all
  limit_violations,        // answers are outside the joint limits
  no_answer,               // solves have no answer, or values of a file are infinite
  times_not_comparable,    // times were measured in parallel, in too few or other sessions, or on a busy machine
  unreachable_targets,     // no solver can reach some targets
  deterministic,           // every run gave the same answers, so that all runs count as one
  dominated_by_few,        // few values are most of a sum
  ranks_disagree,          // a solver is better by ranks, but worse by its median or mean
  favoured_by_drop,        // rows of a file are left out, and solvers lack different shares of them
  may_be_one_measurement,  // every block of a file has the same values
  wrong_answers,           // most answers of a solver miss their targets by one known cause
  answer_anomalies,  // a file of answers has doubled rows, wrong answers beside right ones, or cells without a number
  budget_not_known,  // answers made elsewhere have no times, so that a time limit may not have been kept
};

struct Warning {
  WarningKind kind;
  std::vector<std::string> solvers = {};  // empty: all
  double count = 0, total = 0;            // 3 of 20
  std::string detail = {};                // why, in a few words: "solved in parallel"
};

// Returns a line such as "times of mine are not compared: the machine was busy in 100 of 100 solves".
std::string warning_text(const Warning& warning);

// Returns why the solvers of a warning are not compared: "the machine was busy". Empty for warnings of other kinds.
std::string reason_not_compared(const Warning& warning);

// Returns the warnings that concern more than one metric.
std::vector<Warning> study_warnings(const StudyResults& study);
// Return the warnings about times, about metrics that a time limit decides, and about evaluations, which include those
// of a time limit. The solvers that such a warning names are not compared in these metrics; if it names none, no solver
// is.
std::vector<Warning> time_warnings(const StudyResults& study);
std::vector<Warning> clock_warnings(const StudyResults& study);
std::vector<Warning> evaluation_warnings(const StudyResults& study);

}  // namespace ikbench::judge
