// Which of two is better: a finding for each pair of groups. When a number decides between groups, it is judged here,
// whatever it is of: studies, files, gates, claims and readings have no other rule.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "analysis/judge/data/samples.hpp"
#include "analysis/judge/statistics/two_sample_tests.hpp"
#include "results/study.hpp"

namespace ikbench::judge {

using results::AnalysisPlan;

// Of the first. same: within the margin. undecided: p decides nothing. not_tested: an open finding says why.
enum class Verdict { better, worse, equivalent, inconclusive, not_tested };
std::string_view name_of(Verdict verdict);

struct EffectEstimate {
  double value = 0;
  std::optional<Interval> interval = {};  // at 1 - significance / tested pairs; without 0 (ratios: 1) if p decides
};

// Shares of pairs or blocks in which the first is better, and worse. Their difference is Cliff's delta; A12 has equal
// ones half (Vargha and Delaney, J. Educational and Behavioral Statistics 25 (2000) 101).
struct Dominance {
  double better = 0, worse = 0;
  double a12() const { return (1 + better - worse) / 2; }
};

struct TestResult {
  Verdict verdict = Verdict::inconclusive;
  bool is_below_margin = false;             // a difference within the margin
  double adjusted_p = 1;                    // times the tested pairs; below the significance it decides
  std::optional<Dominance> dominance = {};  // none of summaries and of logarithms
  std::optional<double> hedges_g = {};      // Hedges', of paired values g_av, where means decide (describe.hpp)
  std::string_view test = {};
  int n = 0;           // observations, or common blocks; of the smaller group, or those that a solver that
                       // repeats itself is held against
  int required_n = 0;  // of undecided with p < 0.5: about how many could decide; 0: nobody knows
};

// Both solvers repeat themselves: no chance is in the difference.
struct DeterministicResult {
  Verdict verdict = Verdict::equivalent;  // better and worse by more than the margin
};

// Why no test decides a pair. If several reasons hold, the first counts. The first five are those of a group.
enum class NotTestedReason {
  missing_values,    // some solves or rows of a group have no value
  infinite_values,   // a group has values without an answer, which no mean can count
  not_comparable,    // a group was timed or counted in another way, or ended by the clock
  zero_spread,       // a group has a printed deviation of 0, which would decide everything
  nothing_solved,    // a group solved no target, so that no answer has a cost
  no_answer,         // all values of both groups are infinite
  copies,            // both groups have one number each, and nothing tells measurements from copies
  sample_too_small,  // no data of this size could decide
  dominated          // one value is so much of a group's sum that its mean shows nothing better
};
// Returns the reason of a pair with a group that is excluded for this reason.
NotTestedReason not_tested_reason(ExclusionReason reason);

struct NotTested {
  NotTestedReason reason = NotTestedReason::sample_too_small;
  int n = 0;           // observations of the smaller group, or common blocks
  int required_n = 0;  // if too few: how many, in each group, could decide
};

// The result for one pair of groups in one metric.
struct Comparison {
  std::string first = {}, second = {};            // names of the groups
  std::size_t first_index = 0, second_index = 0;  // the places of these groups in MetricSamples::groups
  EffectScale scale = EffectScale::difference;    // of the amount; means have differences
  std::optional<EffectEstimate> estimate =
      {};  // of what is tested, if it does not refute the verdict; of facts, and of few
  std::variant<TestResult, DeterministicResult, NotTested> result = NotTested();
};

// What every finding has in common.
Verdict verdict_of(const Comparison& comparison);  // few that decide leave it undecided
constexpr double null_value(EffectScale scale) { return scale == EffectScale::ratio ? 1 : 0; }
bool is_not_tested(const Comparison& comparison, NotTestedReason reason);
bool all_values_equal(const Comparison& comparison);  // no value differs

// What decides the test, never how the values are spread:
//
//   compared                                              unpaired                         paired
//   shares of one trial                                   Fisher's exact                   McNemar's exact
//   shares of several; logarithms; where the plan says    Welch's t                        paired t
//   means; of printed summaries (never paired)
//   other numbers, ratios by their logarithms             Brunner-Munzel and Mann-Whitney  signed ranks
//   the same with a file's equal values, perhaps copies   sign test and Mann-Whitney       signed ranks
//   runs with the value of a solver that repeats itself   sign test; shares and logarithms: one-sample t
//
// A pair is decided at the significance divided by the number of pairs that data of these sizes can decide at all, and
// by `metrics`, the number of metrics that share the significance. Throws std::invalid_argument if the control is no
// group. Paired groups have one size without blocks, and ratios are of values above 0, or have a floor above it.
std::vector<Comparison> compare(const MetricSamples& samples, const AnalysisPlan& plan, std::size_t metrics = 1);

// One metric of several studies, such as those of the labels that two stores have: their pairs share the significance.
struct FamilyMember {
  const MetricSamples* samples;
  const AnalysisPlan* plan;
};
// The findings of each member of a family.
std::vector<std::vector<Comparison>> compare(const std::vector<FamilyMember>& family, std::size_t metrics);

bool is_difference(Verdict verdict);                                       // better or worse
Verdict reversed(Verdict verdict);                                         // of the second
std::set<std::string> beaten_solvers(const std::vector<Comparison>& all);  // worse than another

// A mean: one value is more than half of the sum of all sizes; of costs per solved target few values are worth most of
// it, or fewer than 4 are solved.
bool is_dominated(const Group& group);

// A mean or median is worse than another by more than the margin.
bool is_worse_beyond_margin(const MetricSamples& samples, const AnalysisPlan& plan, double one, double other);

// Sets the indices of comparisons that were made of other samples, such as of a part of these groups. Throws
// std::invalid_argument if a comparison names a group that the samples do not have.
void set_group_indices(std::vector<Comparison>& comparisons, const MetricSamples& samples);

// The same pair, told with its better one first, or if none is with its second where that is ahead; or else with the
// control second.
Comparison better_first(Comparison comparison, std::string_view control, bool is_second_ahead = false);

}  // namespace ikbench::judge
