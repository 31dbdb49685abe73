// Is a solver worse than its baseline? A study of the two, judged like every other.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/judge/judge.hpp"

namespace ikbench::judge {

struct Gate {
  std::string label;  // of both; empty: two solvers of one store
  // Without solves, once decided without values. Of two solvers, the candidate first; the last metric is the share of
  // solves that gave an answer.
  JudgedStudy judged;
  bool do_times_decide = false;  // asked for
  // Quantities; time only if times decide. worse_by_little: by less than the margin, which is no loss.
  std::vector<std::string> worse, better, worse_by_little, not_decided, not_tested;
  std::vector<std::string> lost = {}, won = {};  // targets: solved by the baseline alone, by the candidate alone
  int same = 0;                                  // solves, bit for bit
  int newly_missing = 0;           // answers, where before none was or now none is left: fails, even if by chance
  bool are_same = false;           // all solves, bit for bit: then nothing is left to decide but time
  bool are_times_missing = false;  // though they decide
  bool is_compared = true;         // some quantity besides the share of answers was compared, or something is worse
};

// Of a study of two solvers, the candidate first; observed and not yet judged. With a margin of their own times decide.
// Throws std::invalid_argument if they have not the same solves.
Gate gate(StudyResults study, std::optional<double> time_margin = {}, const std::string& label = "");
// Of one solver in two stores, by the baseline's plan; times decide only if the two were solved in turn. Throws also if
// the tasks differ.
Gate gate(StudyResults baseline, StudyResults candidate, std::optional<double> time_margin = {});
// Judges all, by a significance that all metrics of all gates share that can be worse: of equal solvers, one is in
// no more compares than it says.
void decide(std::vector<Gate>& gates);

// 3: something is worse, or answers are newly missing; 1: of a label nothing was compared, or not the times that were
// asked for; 4: something is not decided, and that counts; else 0. Of all labels together.
int exit_code(const std::vector<Gate>& gates, bool is_strict);

}  // namespace ikbench::judge
