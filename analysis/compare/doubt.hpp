// What a reader must know before he believes a result.
#pragma once

#include <string>
#include <vector>

namespace ikbench::compare {

// In the order of what they change.
enum class DoubtKind {
  plan_changed,
  runs_missing,
  incomplete,
  other_version,
  claimed_but_wrong,
  seconds_decide,
  budgets_differ,
  outside_limits,
  without_answer,
  times_not_comparable,
  out_of_reach,
  repeats_itself,
  few_decide_mean,
  too_few,
};

struct Doubt {
  DoubtKind kind;
  std::vector<std::string> who = {};  // solvers
  double count = 0, of = 0;           // 3 of 20; of too_few: 3 where it takes 20
  std::string what = {};              // why, in a few words: "solved in parallel"
};

// A line: "times of mine are not compared: the machine was busy in 100 of 100 solves".
std::string words_of(const Doubt& doubt);

}  // namespace ikbench::compare
