// What a reader must know before he believes a result.
#pragma once

#include <string>
#include <vector>

namespace ikbench::compare {

enum class DoubtKind {
  runs_missing,
  incomplete,
  without_answer,
  claimed_but_wrong,
  outside_limits,
  budgets_differ,
  times_not_comparable,
  seconds_decide,
  out_of_reach,
  too_few,
  few_decide_mean,
  plan_changed,
  repeats_itself,
  other_version,
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
