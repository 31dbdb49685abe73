// Compares groups pair by pair. Every comparison in the program goes through `compare_pairs`, so that studies, CSV
// files, regression checks and papers' claims have one rule. A pair costs about 10 ms for thousands of values, and no
// pair holds a copy of its values. docs/explanation/methods.md explains the tests and the correction of p.
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

// The verdict about the first group of a comparison.
enum class Verdict {
  better,
  worse,
  equivalent,    // no difference is found, and the interval lies within the margin
  inconclusive,  // neither a difference nor equivalence is shown
  not_tested     // NotTested has the reason
};
// Returns the verdict in words, as sentences have it.
std::string_view name_of(Verdict verdict);

// The ratio of or the difference between two groups.
struct EffectEstimate {
  double value = 0;
  // The interval has the confidence 1 - significance / (size of the family * metrics). It excludes the null value (0,
  // or 1 for ratios) if and only if p decides.
  std::optional<Interval> interval = {};
};

// The shares of pairs of values, or of blocks, in which the first group is better, and in which it is worse. Their
// difference is Cliff's delta.
struct Dominance {
  double better = 0, worse = 0;
  // The interval of A12, which excludes 0.5 if and only if p decides; empty for shares of successes, whose difference
  // has one.
  std::optional<Interval> interval = {};

  // Returns A12, which counts equal values half (Vargha and Delaney, J. Educational and Behavioral Statistics 25 (2000)
  // 101).
  double a12() const { return (1 + better - worse) / 2; }
};

// The result of a test.
struct TestResult {
  Verdict verdict = Verdict::inconclusive;
  bool is_below_margin = false;             // a difference is found, and lies within the margin
  double adjusted_p = 1;                    // p * size of the family * metrics, at most 1
  std::optional<Dominance> dominance = {};  // empty for printed summaries and for logarithms
  std::optional<double> hedges_g = {};      // only where means decide; g_av for paired values (descriptives.hpp)
  std::string_view test = {};
  int n = 0;           // values of the smaller group, or those against one value of a deterministic solver; or blocks
  int required_n = 0;  // if inconclusive: about how many values could decide; 0: not known
};

// Both solvers are deterministic: the difference is exact, and no test is needed.
struct DeterministicResult {
  Verdict verdict = Verdict::equivalent;  // better or worse only by more than the margin
};

// Why no test decides a pair. If several reasons hold, the first counts. The first five are those of a group.
enum class NotTestedReason {
  missing_values,    // some solves or rows of a group have no value
  infinite_values,   // a group has values without an answer, which no mean can count
  not_comparable,    // a group was timed or counted in another way, or ended by the clock
  zero_spread,       // a group has a printed deviation of 0, which would decide everything
  nothing_solved,    // a group solved no target, so that no answer has a cost
  no_answer,         // all values of both groups are infinite
  copies,            // both groups have one number each, which may be a copied measurement
  sample_too_small,  // no data of this size could decide
  dominated          // few values decide the difference of means, so that the verdict is inconclusive
};
// Returns the reason of a pair with a group that is excluded for this reason.
NotTestedReason not_tested_reason(ExclusionReason reason);

// A pair that no test decides.
struct NotTested {
  NotTestedReason reason = NotTestedReason::sample_too_small;
  int n = 0;           // values of the smaller group, or common blocks
  int required_n = 0;  // if the sample is too small: values per group that could decide
};

// The result for one pair of groups in one metric.
struct Comparison {
  std::string first = {}, second = {};            // names of the groups
  std::size_t first_index = 0, second_index = 0;  // the places of these groups in MetricSamples::groups
  EffectScale scale = EffectScale::difference;    // of the estimate; differences where means decide
  // Empty if there is no result, if the estimate is not finite, or if the estimate would refute the verdict.
  std::optional<EffectEstimate> estimate = {};
  std::variant<TestResult, DeterministicResult, NotTested> result = NotTested();
};

// Returns the verdict about the first group. A pair that few values would decide is inconclusive.
Verdict verdict_of(const Comparison& comparison);
// Returns the effect of two equal groups.
constexpr double null_value(EffectScale scale) { return scale == EffectScale::ratio ? 1 : 0; }
// Returns whether a pair is not tested for this reason.
bool is_not_tested(const Comparison& comparison, NotTestedReason reason);
// Returns whether closed tests decided one of the pairs (closed_tests.hpp), and so all pairs that have a p.
bool are_by_closed_tests(const std::vector<Comparison>& comparisons);
// Returns whether no value of the one group differs from one of the other.
bool all_values_equal(const Comparison& comparison);

// Compares all pairs that the plan asks for. Design and plan decide the test, and never the spread of the values:
//
//   compared                                              unpaired                         paired
//   shares of one trial                                   Fisher's exact                   McNemar's exact
//   shares of several; logarithms; where the plan says    Welch's t                        paired t
//   means; of printed summaries (never paired)
//   other numbers, ratios by their logarithms             Brunner-Munzel and Mann-Whitney  signed ranks
//   the same with a file's equal values, perhaps copies   sign test and Mann-Whitney       signed ranks
//   runs with the value of a deterministic solver         sign test; shares and logarithms: one-sample t
//
// If signed ranks could decide none of the pairs of four to twelve groups, closed tests do where they can
// (closed_tests.hpp). Otherwise a pair is decided at the significance divided by the size of the family and by
// `metrics`. The family are the pairs that samples of these sizes could decide at all; `metrics` is the number of
// metrics that share the significance. Throws std::invalid_argument if the control is no group. Preconditions: paired
// groups without blocks have equal sizes, and values that are compared by ratios are above 0, or have a floor above 0.
std::vector<Comparison> compare_pairs(const MetricSamples& samples, const AnalysisPlan& plan, std::size_t metrics = 1);

// One metric of one study in a family of several, such as the studies of all labels that two stores have.
struct FamilyMember {
  const MetricSamples* samples;
  const AnalysisPlan* plan;
};
// Compares the pairs of all members, which share one significance. Returns the comparisons of each member.
std::vector<std::vector<Comparison>> compare_pairs(const std::vector<FamilyMember>& family, std::size_t metrics);

// Returns whether a verdict is better or worse.
bool is_difference(Verdict verdict);
// Returns the verdict about the second group.
Verdict reversed(Verdict verdict);
// Returns the names of the groups that are worse than another one.
std::set<std::string> beaten_solvers(const std::vector<Comparison>& comparisons);

// Returns whether few values make the mean of a group: one value lies farther from the median than all others together
// or is more than half of the sum of all absolute values, or, for costs per success, the effective sample size is too
// small or fewer than 4 targets were solved.
bool is_dominated(const Group& group);

// Returns whether an average is worse than another one by more than the margin.
bool is_worse_beyond_margin(const MetricSamples& samples, const AnalysisPlan& plan, double value, double other);

// Returns the comparison with the better group first. If neither is better, `is_second_ahead` swaps them. With a
// control the control always comes second.
Comparison better_first(Comparison comparison, std::string_view control, bool is_second_ahead = false);

}  // namespace ikbench::judge
