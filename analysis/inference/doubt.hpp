// Reasons to doubt numbers, as values: kind, solvers and sizes. doubt.cpp has the words of each doubt kind. Code
// decides by the value and never reads the words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::inference {

// Each kind uses the fields that its words name (doubt.cpp).
enum class DoubtKind {
  // times of all solvers, or of `who`, are not compared with others
  solved_in_parallel,
  several_machines,
  unknown_machine,
  separate_sessions,
  times_disturbed,
  times_of_programs,
  // evaluations of `who` are not compared with others
  evaluations_uncounted,
  evaluations_claimed,
  // disturbances of times
  machine_loaded,
  slow_solves,
  // what the study compares
  unequal_evaluations,
  populations_only,
  single_target,
  // observations
  points_as_observations,
  rows_share_a_run,
  values_missing,
  uneven_runs,
  no_path_for_blocks,
  chained_solves,
  other_targets,
  no_common_run,
  single_block,
  // the plan
  plan_changed,
  solvers_dropped,
  control_absent,
  plan_not_recorded,
  no_plan,
  // the study, its solves, and its report
  no_tolerance,
  wrong_claims,
  out_of_reach,
  unknown_paper,
  solves_missing,
  figure_not_drawn,
};

struct Doubt {
  DoubtKind kind;
  std::vector<std::string> who = {};  // solvers, or machines
  double count = 0, of = 0;           // 3 of 20 solves
  double other = 0, value = statistics::not_defined, limit = statistics::not_defined;
  std::string what = {};                  // a file, a change, a place
  bool is_of_all = false;                 // for times: none can be compared; false: those of `who` are left out
  bool errors_too = false;                // errors are affected too, because solves end by wall time
  std::string study = {};                 // the study that it is about, if that is another than the reported one
  std::vector<std::string> studies = {};  // other studies with the same doubt
};
using Doubts = std::vector<Doubt>;

std::string_view title_of(DoubtKind kind);  // short title: "Times are not comparable"
std::string title_of(const Doubt& doubt);   // the same, with the solvers if it is about the times of some
std::string words_of(const Doubt& doubt);   // sentences
std::string words_of(const Doubts& doubts);
std::string_view brief_of(DoubtKind kind);  // why nothing is compared, in a few words; most kinds have none
// Solvers that a metric is not compared of, each with the reason in a few words: "mine (counts by itself)".
std::string left_out_words(const Doubts& doubts);
std::vector<std::string> list_of(const Doubts& doubts);  // the words of each
Doubts operator+(Doubts doubts, Doubts others);

}  // namespace ikbench::inference
