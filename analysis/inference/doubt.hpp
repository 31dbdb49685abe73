// What makes numbers doubtful, as a value: what it is, of whom, and how much. doubt.cpp has the words of each. Code
// decides by the value, and nothing reads the words.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::inference {

// The fields that each has are those that its words name (doubt.cpp).
enum class DoubtKind {
  // the times of all solvers, or those of `who`, are compared with no others
  solved_in_parallel,
  several_machines,
  unknown_machine,
  separate_sessions,
  times_imported,
  times_disturbed,
  times_of_programs,
  // the evaluations of `who` are compared with no others
  evaluations_uncounted,
  evaluations_claimed,
  // what is in times
  two_speeds,
  machine_loaded,
  slow_solves,
  interruptions,
  stolen_time,
  other_repeats,
  mostly_transport,
  evaluated_one_by_one,
  // observations
  points_as_observations,
  rows_share_a_run,
  uneven_runs,
  blocks_averaged,
  blocks_left_out,
  values_missing,
  runs_incomplete,
  no_path_for_blocks,
  chained_solves,
  other_targets,
  no_common_run,
  single_block,
  other_test,
  // the plan
  plan_changed,
  solvers_dropped,
  plan_unreadable,
  plan_not_recorded,
  no_plan,
  looked_before,
  // the study, its solves, and its report
  wrong_claims,
  out_of_reach,
  unknown_paper,
  solves_missing,
  imported_verified,
  imported_unverified,
  figures_edited,
  figure_not_drawn,
  said_elsewhere,  // `what`: by who read the store or the file
};

struct Doubt {
  DoubtKind kind;
  std::vector<std::string> who = {};  // solvers, or machines
  double count = 0, of = 0;           // 3 of 20 solves
  double other = 0, value = statistics::not_defined, limit = statistics::not_defined;
  std::string what = {};                  // a file, a change, a place
  bool is_of_all = false;                 // of times: none can be compared; else those of `who` are left out
  bool has_programs = false;              // among `who`
  bool errors_too = false;                // solves end by their wall time, so errors depend on what times do
  std::vector<std::string> studies = {};  // other studies of which it is so
};
using Doubts = std::vector<Doubt>;

std::string_view title_of(DoubtKind kind);  // in a few words: "Times are not comparable"
std::string words_of(const Doubt& doubt);   // sentences
std::string words_of(const Doubts& doubts);
std::vector<std::string> list_of(const Doubts& doubts);  // the words of each
Doubts operator+(Doubts doubts, Doubts others);

}  // namespace ikbench::inference
