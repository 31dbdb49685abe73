// Whether solvers give all answers to a target: how many known answers each of them found, and how often it found all.
// Reports show it for studies with solvers that give several answers. `run` counts the answers
// (results/counted_answers.hpp); definitions are in docs/explanation/methods.md#all-answers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/judge/data/study_results.hpp"
#include "analysis/judge/judge.hpp"

namespace ikbench::judge {

// The answers of a solver to the targets that count.
struct AnswerSummary {
  std::string solver;
  double complete = 0;  // share of the targets for which it gave all known answers; of several runs, their mean
  double coverage = 0;  // mean share of the known answers
  double lowest_coverage = 1, highest_coverage = 0;
  double mean_found = 0;  // known answers per target
  int fewest_found = 0, most_found = 0;
  int declined = 0;  // solves without any answer
  // Counted over all targets that were looked at, also over those that do not count.
  int wrong = 0, doubled = 0;
  int wrong_beside_right = 0;  // wrong answers to targets that also got a right one
};

// All answers of a study.
struct AllAnswers {
  int targets = 0;               // that count
  int continua = 0;              // targets with a singular answer
  int unknown = 0;               // targets without a known answer
  std::int64_t all_targets = 0;  // of the study, of which at most max_counted_targets are looked at
  int repeats = 1;               // runs that have the same targets
  double mean_known = 0;         // known answers per target that counts
  int fewest_known = 0, most_known = 0;
  std::vector<AnswerSummary> solvers = {};    // in the order of the study
  std::vector<std::string> left_out = {};     // solvers of which some answers were not counted
  std::optional<JudgedMetric> complete = {};  // the share of complete targets; none if no target counts

  int looked_at() const { return targets + continua + unknown; }
};

// Returns the summary of a study's answers; nullopt if they were not counted.
std::optional<AllAnswers> all_answers_of(const StudyResults& study);
// Returns why the answers of a study are not counted although solvers gave several, as a sentence; empty if they are,
// or if no solver gave several.
std::string why_not_counted(const StudyResults& study);

}  // namespace ikbench::judge
