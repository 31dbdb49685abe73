// The regression check: is a solver (the candidate) worse than its baseline? `ikbench compare` makes a study of the
// two, which is judged like every other, and turns the result into an exit code. docs/compare.md is its documentation.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "analysis/judge/judge.hpp"

namespace ikbench::judge {

// The user's choices of which metrics decide.
struct RegressionOptions {
  std::optional<double> time_margin = {};  // times decide, by this margin
  std::vector<std::string> metrics = {};   // those of names_in_plan that decide; empty: all of them
};

// Thrown if two solvers cannot be compared, because one lacks solves that the other has.
struct LacksSolves : std::invalid_argument {
  using invalid_argument::invalid_argument;
};

// The result of a regression check in one metric. A metric in which nothing is to be reported has none.
enum class RegressionOutcome {
  worse,               // a difference is found, and is not shown to be below the margin
  worse_below_margin,  // a difference is found, and is below the margin, which is no loss
  better,              // a difference is found, and is not shown to be below the margin
  inconclusive,
  not_tested
};

struct MetricOutcome {
  std::string metric;    // name in files: "error"
  std::string quantity;  // name in sentences: "position error"
  RegressionOutcome outcome = RegressionOutcome::inconclusive;
  bool is_deciding = true;  // false: the metric is not in the plan, or the user left it out
};

// A comparison of one candidate with its baseline. Made by `check_regression`, and judged by `judge_all`.
struct RegressionCheck {
  std::string label = {};                     // in both stores; empty: two solvers of one store
  std::string candidate = {}, baseline = {};  // the labels in `judged`
  RegressionOptions options = {};
  // Until `judge_all` the samples of all labels of the store, then those of the candidate and the baseline. The last
  // metric is the share of solves that gave an answer. The study in it has the two labels only, and no solves.
  JudgedStudy judged = {};
  // In the order of the metrics. Times decide only if the options have a margin for them.
  std::vector<MetricOutcome> outcomes = {};
  std::vector<std::string> newly_unsolved = {};  // targets that only the baseline solved
  std::vector<std::string> newly_solved = {};    // targets that only the candidate solved
  int identical_solves = 0;                      // bit for bit
  // Missing answers, if the baseline gave all answers or the candidate gives none. They fail the check, even by chance.
  int new_failures = 0;
  bool is_identical = false;       // all solves, bit for bit: then only times are left to decide
  bool are_times_missing = false;  // though they decide
  bool is_compared = true;  // a deciding metric was compared, all solves are identical, or there are new failures

  bool counts_times() const { return options.time_margin.has_value(); }
  // Returns whether a deciding metric has this outcome.
  bool has(RegressionOutcome outcome) const;
  // Returns the quantities of the metrics with this outcome, in the order of the metrics.
  std::vector<std::string> quantities(RegressionOutcome outcome, bool is_deciding = true) const;
};

// Makes the check of two labels of a study, which is not judged yet. All labels of the study take part, so that the
// pair has the p that it has in the study's report; with a control that is neither of the two, the p of a report
// without a control. Throws LacksSolves if the two do not have the same solves, and std::invalid_argument if the
// options ask for metrics that the plan does not name.
RegressionCheck check_regression(StudyResults study, const std::string& candidate, const std::string& baseline,
                                 RegressionOptions options = {}, const std::string& label = "");
// Makes the check of one solver in two stores, by the baseline's plan. Times decide only if the two stores were solved
// in turn. Throws std::invalid_argument also if the tasks differ.
RegressionCheck check_regression(StudyResults baseline, StudyResults candidate, RegressionOptions options = {});
// Judges all checks, of which there must be at least one. The pairs of a metric in all checks are one family, which has
// the significance of a report.
void judge_all(std::vector<RegressionCheck>& checks);

// Returns the exit code for all checks together. 3: something is worse, or answers are newly missing. 1: in one check
// nothing was compared, or not the times that were asked for. 4: `is_strict`, and something is inconclusive or not
// tested. 0: otherwise.
int exit_code(const std::vector<RegressionCheck>& checks, bool is_strict);

}  // namespace ikbench::judge
