// Is a solver worse than its baseline? A study of the two, judged like every other.
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

// Two that cannot be compared, since one lacks solves that the other has.
struct LacksSolves : std::invalid_argument {
  using invalid_argument::invalid_argument;
};

struct RegressionCheck {
  std::string label = {};                     // in both stores; empty: two solvers of one store
  std::string candidate = {}, baseline = {};  // the labels in `judged`
  RegressionOptions options = {};
  // Until it is decided of all labels of the store and not yet compared, then of the candidate and the baseline. The
  // last metric is the share of solves that gave an answer. Without solves of other labels.
  JudgedStudy judged = {};
  // Quantities of the metrics that decide: time only with a margin for it. worse_below_margin: by less than the margin,
  // which is no loss.
  std::vector<std::string> worse = {}, better = {}, worse_below_margin = {}, inconclusive = {}, not_tested = {};
  std::vector<std::string> also_worse = {}, also_better = {};  // quantities of other metrics, which decide nothing
  std::vector<std::string> newly_unsolved = {},
                           newly_solved = {};  // targets: solved by the baseline alone, by the candidate alone
  int identical_solves = 0;                    // solves, bit for bit
  int new_failures = 0;            // answers, where before none was or now none is left: fails, even if by chance
  bool is_identical = false;       // all solves, bit for bit: then nothing is left to decide but time
  bool are_times_missing = false;  // though they decide
  bool is_compared = true;         // some quantity that decides was compared, or something is worse

  bool counts_times() const { return options.time_margin.has_value(); }
};

// Of two labels of a study: observed and not yet judged. All labels of the study take part, so that the pair has the p
// that it has in the study's report; with a control that is neither of the two, the p of a report without a control.
// Throws LacksSolves if the two have not the same solves, and std::invalid_argument for options that ask for what the
// plan lacks.
RegressionCheck gate(StudyResults study, const std::string& candidate, const std::string& baseline,
                     RegressionOptions options = {}, const std::string& label = "");
// Of one solver in two stores, by the baseline's plan; times decide only if the two were solved in turn. Throws also if
// the tasks differ.
RegressionCheck gate(StudyResults baseline, StudyResults candidate, RegressionOptions options = {});
// Judges all of at least one. A metric's pairs of all gates are one family, and its significance is that of a report.
void judge_all(std::vector<RegressionCheck>& gates);

// 3: something is worse, or answers are newly missing; 1: of a label nothing was compared, or not the times that were
// asked for; 4: something is not decided, and that counts; else 0. Of all labels together.
int exit_code(const std::vector<RegressionCheck>& gates, bool is_strict);

}  // namespace ikbench::judge
