// Which of two is better: a finding for each pair of groups, and the one that is best.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/compare/observations.hpp"
#include "analysis/compare/tests_of_two.hpp"
#include "results/plan.hpp"

namespace ikbench::compare {

using results::Plan;

// Of the first.
enum class Verdict { better, worse, same, undecided, not_tested };
std::string_view name_of(Verdict verdict);

enum class Why {
  tested,
  lost,        // a group has observations without a value
  apart,       // the times of a group were measured otherwise
  fact,        // both solvers repeat themselves: no chance is in the difference
  too_few,     // no data of this size could decide
  few_decide,  // tested; one value is more than half of a group's sum, so its mean shows nothing better
};

struct Finding {
  std::string first, second;
  Scale scale = Scale::difference;        // of estimate and interval; means have differences
  std::optional<double> estimate = {};    // none if values are lost
  std::optional<Interval> interval = {};  // at 1 - significance / tested pairs
  std::optional<double> p = {};           // after Holm
  std::optional<double> effect = {};      // share of pairs or blocks in which the first is better, equal ones half
  std::string_view test = {};
  Verdict verdict = Verdict::not_tested;
  bool is_within_margin = false;  // the same, or better by less than the margin
  bool are_all_equal = false;
  Why why = Why::tested;
  int n = 0;       // observations, or common blocks; of the smaller group; of a sign test runs that differ
  int needed = 0;  // if too few: how many, in each group, could decide
};

// Throws std::invalid_argument if the control is no group. Paired groups have one size without blocks, and ratios are
// of values above 0, or have a floor above it.
std::vector<Finding> compare(const Observations& of, const Plan& plan);

// better or worse
bool is_difference(Verdict verdict);
// p and the interval say otherwise: Holm corrects p in steps, intervals hold all together, and those of counts come
// from another method than p. Then p decides.
bool contradicts_interval(const Finding& finding);

// The same pair, told with its better one first, or with the control second.
Finding better_first(Finding finding, std::string_view control);

// Of one metric. best: better than every other. A circle, or means that lie the other way by more than the margin,
// leave none: `usual` is then usually better, and the mean of `by_mean` is better.
struct Headline {
  std::string best = {}, usual = {}, by_mean = {};
  bool is_circle = false;
};
Headline headline(const Observations& of, const Plan& plan, const std::vector<Finding>& findings);

}  // namespace ikbench::compare
