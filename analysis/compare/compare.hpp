// Which of two is better: a finding for each pair of groups, and those that are best.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/compare/observations.hpp"
#include "analysis/compare/tests_of_two.hpp"
#include "results/study.hpp"

namespace ikbench::compare {

using results::Plan;

// Of the first. same: within the margin. undecided: p decides nothing. not_tested: for the reason of Why.
enum class Verdict { better, worse, same, undecided, not_tested };
std::string_view name_of(Verdict verdict);

enum class Why {
  tested,
  lost,        // a group has observations without a value
  apart,       // a group was timed or counted otherwise, ended by the clock, or has no spread
  fact,        // both solvers repeat themselves: no chance is in the difference
  too_few,     // no data of this size could decide
  few_decide,  // one value is more than half of a group's sum, so the means would show nothing better
};

struct Finding {
  std::string first, second;
  Scale scale = Scale::difference;        // of estimate and interval; means have differences
  std::optional<double> estimate = {};    // of what is tested or a fact; none if it would refute the verdict
  std::optional<Interval> interval = {};  // at 1 - significance / tested pairs; without 0 (ratios: 1) if p decides
  std::optional<double> p = {};           // times the tested pairs; below the significance it decides
  std::optional<double> effect = {};      // share of pairs or blocks in which the first is better, equal ones half
  std::string_view test = {};
  Verdict verdict = Verdict::not_tested;
  bool is_within_margin = false;  // the same, or better by less than the margin
  bool are_all_equal = false;
  Why why = Why::tested;
  int n = 0;       // observations, or common blocks; of the smaller group; of a sign test runs that differ
  int needed = 0;  // if too few: how many, in each group, could decide
};

// What decides the test. Groups of which only means are known (printed summaries) have Welch's t. The one value of a
// solver that repeats itself has no spread, so the other's runs are held against it by the sign test. A file of equal
// values does not say whether they are copies: the larger p of that and Mann-Whitney's decides. A share of one
// trial is 0 or 1: Fisher's exact test, in blocks McNemar's. A share of several trials goes by t, since its mean is
// asked. All other numbers go by ranks, or by t where the plan says means; on a ratio scale ranks are of logarithms.
// Blocks make them paired: signed ranks, the paired t. Nothing asks how the values are spread: a test chosen by the
// values that it then judges is wrong more often than it says. A pair is decided at the significance divided by the
// number of pairs that data of these sizes can decide at all.
//
// So many metrics share the significance. Throws std::invalid_argument if the control is no group. Paired groups have
// one size without blocks, and ratios are of values above 0, or have a floor above it.
std::vector<Finding> compare(const Observations& observed, const Plan& plan, std::size_t metrics = 1);

// Before any p is known: data of this size can decide some pair, and its values are not all equal.
bool can_decide(const Observations& observed, const Plan& plan);

// better or worse
bool is_difference(Verdict verdict);
Verdict turned(Verdict verdict);                                   // of the second
std::set<std::string> losers_of(const std::vector<Finding>& all);  // worse than another

bool does_one_value_decide(const Group& group);  // a mean: it is more than half of the sum of all sizes

// A mean or median is worse than another by more than the margin.
bool is_worse_than_margin(const Observations& observed, const Plan& plan, double one, double other);

// The same pair, told with its better one first, or if none is with its second where that is ahead; or else with the
// control second.
Finding better_first(Finding finding, std::string_view control, bool is_second_ahead = false);

// Of one metric.
struct Headline {
  std::vector<std::string> best = {};  // nobody is better, and each is better than all who are not among them
  // None is best where `usual` is better than `other` while its median (by ranks), or else its mean, is worse by more
  // than the margin.
  std::string usual = {}, other = {};
  bool is_median_worse = false;
  bool is_circle = false;  // each is worse than another
};
Headline headline(const Observations& observed, const Plan& plan, const std::vector<Finding>& findings);

}  // namespace ikbench::compare
