// Is a solver worse than its baseline? A study of the two, judged like every other.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/compare/judge.hpp"

namespace ikbench::compare {

struct Gate {
  // Without solves and values. Of two solvers, the candidate first; the last metric is the share of solves that gave an
  // answer.
  JudgedStudy judged;
  std::vector<std::string> worse, better, not_decided;  // quantities; the last also of what is not tested
  bool are_same = false;                                // all solves, bit for bit: then nothing is left to decide
  int compared = 0;                                     // targets, or runs of chained solves
  std::optional<double> visible_loss;                   // smallest loss of the share solved that the test would show
};

// Of two studies of one solver each, by the candidate's plan, whose significance the metrics that can be worse share
// with the `labels` that are compared. Solves that the baseline lacks are left out. Throws std::invalid_argument if the
// two had different tasks, or if the candidate lacks solves. Random targets of other seeds are no different task, and
// make groups unpaired.
Gate gate(StudyResults baseline, StudyResults candidate, std::size_t labels = 1);

std::string compared_of(const Gate& gate);  // "100 targets"
// "A loss of 9 points or more would show in 100 targets."
std::string sight_of(const Gate& gate);

// 3: something is worse; 4: something is not decided, and that counts; else 0. Of all labels together.
int exit_code(const std::vector<Gate>& gates, bool is_strict);

}  // namespace ikbench::compare
