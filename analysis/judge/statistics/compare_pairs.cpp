#include "analysis/judge/statistics/compare_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <stdexcept>
#include <utility>

#include "analysis/judge/statistics/closed_tests.hpp"
#include "analysis/judge/statistics/descriptives.hpp"
#include "analysis/judge/statistics/pair_data.hpp"
#include "base/names.hpp"

namespace ikbench::judge {
namespace {

// A test of two groups, and the smallest p that it can give.
struct Method {
  enum class By { ranks, means, shares };

  std::string_view name;
  By by;
  bool is_by_difference;  // tests differences of paired values, or from the one value of a deterministic solver
  UnadjustedTest (*test)(const PairData& data, double alpha);
  bool is_by_values_too = false;

  // Returns the smallest p that groups of `m` and `n` values with a number of differences can give.
  double smallest_p(std::size_t m, std::size_t n, std::size_t differences) const {
    const std::size_t few = std::min(m, n);
    // Two values never decide by means, because two say too little of a spread.
    if (by == By::means && (m == n || !is_by_difference)) return few < 3 ? 1 : 0;
    const double by_differences = is_by_difference ? min_p_paired(differences) : 0;
    if (is_by_difference && !is_by_values_too) return by_differences;
    if (few < 2) return 1;
    // In the rarest table of Fisher's test, all of one group are solved and none of the other. If the sizes are equal,
    // the opposite table is as rare.
    const bool is_single_table = by == By::shares && m != n;
    const double by_values = min_p_unpaired(m, n) / (is_single_table ? 2 : 1);
    return std::max(by_differences, by_values);
  }
};

using By = Method::By;

constexpr Method unpaired_ranks{"Brunner-Munzel and Mann-Whitney", By::ranks, false,
                                [](auto& data, double alpha) { return rank_test(data.first, data.second, alpha); }};
constexpr Method signed_ranks{"Wilcoxon's signed ranks", By::ranks, true,
                              [](auto& data, double alpha) { return signed_rank_test(data.differences, alpha); }};
constexpr Method signs{"sign test", By::ranks, true,
                       [](auto& data, double alpha) { return sign_test(data.differences, alpha); }};
constexpr Method signs_and_ranks{"sign test and Mann-Whitney", By::ranks, true,
                                 [](auto& data, double alpha) {
                                   UnadjustedTest outcome = sign_test(data.differences, alpha);
                                   outcome.p = std::max(outcome.p, mann_whitney(data.first, data.second));
                                   return outcome;
                                 },
                                 true};
constexpr Method paired_t{"paired t", By::means, true,
                          [](auto& data, double alpha) { return t_test(data.differences, alpha, data.effective_n); }};
constexpr Method one_t{"one-sample t", By::means, true, paired_t.test};
constexpr Method unpaired_t{"Welch's t", By::means, false, [](auto& data, double alpha) {
                              return welch(data.of_first, data.of_second, alpha, data.effective_n);
                            }};
constexpr Method paired_shares{"McNemar's exact", By::shares, true,
                               [](auto& data, double alpha) { return mcnemar(data.first, data.second, alpha); }};
constexpr Method unpaired_shares{"Fisher's exact", By::shares, false,
                                 [](auto& data, double alpha) { return fisher(data.first, data.second, alpha); }};

// The tests of one kind of numbers, by design.
struct Methods {
  const Method *unpaired, *paired, *against_one_value;
};
constexpr Methods methods[]{{&unpaired_ranks, &signed_ranks, &signs},  // in the order of By
                            {&unpaired_t, &paired_t, &one_t},
                            {&unpaired_shares, &paired_shares, &one_t}};

// The design of a pair, which decides the test together with the plan. The values do not decide the test, except that
// equal values of a file may be copies.
struct Design {
  bool is_printed = false;      // a group has only a printed summary
  bool is_against_one = false;  // a group is deterministic, so that one value stands for all its runs
};

By method_kind(const MetricSamples& samples, const AnalysisPlan& plan, const Design& design) {
  const bool has_single_trials = trials_per_value(samples) == 1 && samples.min_blocks == 0;
  if (is_proportion(samples) && has_single_trials && !design.is_printed) return By::shares;
  if (design.is_printed || is_proportion(samples) || is_log_scale(samples)) return By::means;
  return plan.test == AnalysisPlan::Test::means && !design.is_against_one ? By::means : By::ranks;
}

const Method& method_of(const MetricSamples& samples, const AnalysisPlan& plan, const Group& a, const Group& b) {
  const auto is_summary = [](const Group& group) { return std::holds_alternative<SummaryStatistics>(group.sample); };
  const Design design{.is_printed = is_summary(a) || is_summary(b),
                      .is_against_one = is_deterministic(a) || is_deterministic(b)};
  const By by = method_kind(samples, plan, design);
  const Methods& row = methods[static_cast<std::size_t>(by)];
  if (design.is_printed) return *row.unpaired;
  if (design.is_against_one) return *row.against_one_value;
  if (samples.is_paired) return *row.paired;
  // Equal values of a file may be copies of one measurement, so that only one of them counts.
  if (by == By::ranks && is_constant(a) != is_constant(b)) return signs_and_ranks;
  return *row.unpaired;
}

std::size_t size_of(const Group& group) {
  if (const auto* const summary = std::get_if<SummaryStatistics>(&group.sample))
    return static_cast<std::size_t>(summary->n);
  return values_of(group).size();
}

// The result of the closed tests of a pair, but for that of its own test.
struct ClosedTests {
  double largest_p;    // scaled, of the sets of at least three groups that have both
  std::size_t groups;  // all that are tested
  double metrics;      // that share the significance

  double adjusted_p(double p) const { return std::min(1.0, metrics * std::max(largest_p, scaled_p(p, 2, groups))); }
};

// Two groups of the samples. Pairs are many, so no pair holds values, and the samples must outlive the pair.
struct Pair {
  const Group *a, *b;
  const Method* method;
  std::size_t first_index = 0, second_index = 0;  // places of the groups in the samples
  EffectScale scale = EffectScale::difference;    // scale of the estimate
  double smallest_p = 1;
  int n = 0;
  std::optional<NotTested> not_tested = {};  // decided before any p is known
  std::optional<ClosedTests> closed = {};    // only where the pair cannot decide by itself

  bool has_deterministic() const { return is_deterministic(*a) || is_deterministic(*b); }
  bool are_both_deterministic() const { return is_deterministic(*a) && is_deterministic(*b); }
};

// Returns whether two groups have different blocks, so that the two share only some blocks.
bool has_other_blocks(const Group& a, const Group& b) {
  const Sample *const of_a = sample_of(a), *const of_b = sample_of(b);
  return of_a != nullptr && of_b != nullptr && of_a->blocks != of_b->blocks;
}

// Returns the sizes of the two groups in the blocks that both have.
std::pair<std::size_t, std::size_t> common_sizes(const Group& a, const Group& b) {
  if (!has_other_blocks(a, b)) return {size_of(a), size_of(b)};
  const Sample *const of_a = sample_of(a), *const of_b = sample_of(b);
  const auto is_in_a = [&](int block) { return std::ranges::binary_search(of_a->blocks, block); };
  const auto common = static_cast<std::size_t>(std::ranges::count_if(of_b->blocks, is_in_a));
  return {common, common};
}

// The unadjusted test of a pair on one scale.
struct Trial {
  PairData numbers;
  UnadjustedTest outcome;
  bool is_same = false;  // the difference lies within the margin on this scale
};

// Keeps the interval of proportions within what their difference can be, and adds an interval if all trials had the
// same outcome. Other values that are all equal have no interval.
void settle_interval(const MetricSamples& samples, const PairData& numbers, double alpha, UnadjustedTest& outcome) {
  std::optional<Interval>& interval = outcome.interval;
  if (!is_proportion(samples)) {
    if (numbers.are_all_equal) interval.reset();
    return;
  }
  if (interval) interval = Interval{std::max(-1.0, interval->low), std::min(1.0, interval->high)};
  const SummaryStatistics &first = numbers.of_first, &second = numbers.of_second;
  if (first.sd == 0 && second.sd == 0 && numbers.are_all_equal && !interval)
    interval = newcombe_interval({.share = first.mean, .n = static_cast<double>(first.n)},
                                 {.share = second.mean, .n = static_cast<double>(second.n)}, alpha);
}

// Returns the averages that a table shows: medians for a test of ranks, because one huge value could decide a mean, and
// means for other tests.
std::pair<double, double> shown_averages(const Method& method, const PairData& numbers) {
  if (method.by != By::ranks) return {numbers.of_first.mean, numbers.of_second.mean};
  return {describe_values(numbers.first).median, describe_values(numbers.second).median};
}

// Returns the margin on the scale of the test. A pair with infinite values has no relative margin.
double margin_of_trial(const MetricSamples& samples, const AnalysisPlan& plan, const Trial& trial, bool takes_logs,
                       std::pair<double, double> averages) {
  if (is_proportion(samples)) return plan.margin;
  if (takes_logs || is_log_scale(samples)) return std::log1p(plan.margin);
  if (trial.numbers.infinity_substitute > 0) return std::max(samples.absolute_margin, 0.0);
  const double smaller = std::min(std::abs(averages.first), std::abs(averages.second));
  return std::max(samples.absolute_margin, plan.margin * smaller);
}

// Returns whether the interval of a test lies within the margin, up to rounding. If the values have no spread, a test
// has no interval, and the estimate is judged.
bool lies_within(const UnadjustedTest& outcome, double margin) {
  const Interval interval = outcome.interval.value_or(Interval{outcome.estimate, outcome.estimate});
  return interval.low >= -margin * (1 + 1e-9) && interval.high <= margin * (1 + 1e-9);
}

void restore_infinities(const PairData& numbers, UnadjustedTest& outcome) {
  outcome.estimate = numbers.restore_infinity(outcome.estimate);
  if (!outcome.interval) return;
  outcome.interval->low = numbers.restore_infinity(outcome.interval->low);
  outcome.interval->high = numbers.restore_infinity(outcome.interval->high);
}

// Returns whether so few values could hide failures that are more frequent than the margin. Failures can hide only if
// all values are equal, or if p does not decide and the interval has no width.
bool may_hide_failures(const AnalysisPlan& plan, const Trial& trial, double alpha) {
  const std::optional<Interval>& interval = trial.outcome.interval;
  const PairData& numbers = trial.numbers;
  const bool are_equal = interval ? interval->low == 0 && interval->high == 0 : numbers.are_all_equal;
  const bool has_width = interval && interval->low < interval->high;
  if (!are_equal && (has_width || trial.outcome.p < alpha)) return false;
  // If the plan has an absolute margin, which does not apply to shares, the relative margin is 0.
  const double rare = plan.margin > 0 ? plan.margin : AnalysisPlan().margin;
  const auto n = static_cast<double>(std::min(numbers.of_first.n, numbers.of_second.n));
  return 1 - wilson_interval({.share = 1, .n = n}, alpha).low > rare;
}

// Returns whether the means differ by less than the margin, too, where ranks decide. Ranks do not see how far apart
// rare values are.
bool do_means_lie_within(const Method& method, const PairData& numbers, double alpha, double margin) {
  if (method.by != By::ranks) return true;
  const Method& by_means = method.is_by_difference ? paired_t : unpaired_t;
  return lies_within(by_means.test(numbers, alpha), margin);
}

Trial trial_of(const MetricSamples& samples, const AnalysisPlan& plan, const Pair& pair, bool takes_logs,
               double alpha) {
  const Method& method = *pair.method;
  Trial trial{.numbers = make_pair_data(*pair.a, *pair.b, samples, method.is_by_difference, takes_logs), .outcome = {}};
  trial.outcome = method.test(trial.numbers, alpha);
  settle_interval(samples, trial.numbers, alpha, trial.outcome);
  const auto [first, second] = shown_averages(method, trial.numbers);
  const double margin = margin_of_trial(samples, plan, trial, takes_logs, {first, second});
  const bool is_small = lies_within(trial.outcome, margin);
  restore_infinities(trial.numbers, trial.outcome);
  // The shown averages must lie within the margin, too, because a test of ratios in blocks does not see averages.
  trial.is_same = is_small && !may_hide_failures(plan, trial, alpha) &&
                  lies_within({.estimate = first - second}, margin) &&
                  do_means_lie_within(method, trial.numbers, alpha, margin);
  return trial;
}

// Returns the interval of A12: of the share of blocks if the values are paired, otherwise of the share of pairs of
// values.
Interval a12_interval_of(const PairData& numbers, const Dominance& dominance, bool is_larger_better, double alpha) {
  const auto n = static_cast<double>(numbers.differences.size());
  if (n > 0) return clopper_pearson_interval({.share = dominance.a12(), .n = n}, alpha);
  return is_larger_better ? a12_interval(numbers.first, numbers.second, alpha)
                          : a12_interval(numbers.second, numbers.first, alpha);
}

std::optional<Dominance> dominance_of(const MetricSamples& samples, const Pair& pair, const PairData& numbers,
                                      double alpha) {
  const bool has_differences = pair.method->is_by_difference;
  const std::vector<double>& first = has_differences ? numbers.differences : numbers.first;
  std::vector<double> second = has_differences ? std::vector{0.0} : numbers.second;
  if (is_log_scale(samples) || first.empty() || second.empty()) return {};
  if (!std::ranges::is_sorted(second)) std::ranges::sort(second);
  double larger = 0, smaller = 0;
  for (const double value : first) {
    const auto [first_equal, end] = std::equal_range(second.begin(), second.end(), value);
    larger += static_cast<double>(first_equal - second.begin());
    smaller += static_cast<double>(second.end() - end);
  }
  const double pairs = static_cast<double>(first.size()) * static_cast<double>(second.size());
  const bool is_larger_better = samples.better == Better::larger;
  Dominance dominance{larger / pairs, smaller / pairs};
  if (!is_larger_better) std::swap(dominance.better, dominance.worse);
  if (!is_proportion(samples) && !pair.closed)  // no interval of closed tests holds for all pairs
    dominance.interval = a12_interval_of(numbers, dominance, is_larger_better, alpha);
  return dominance;
}

// Makes the interval of A12 agree with the verdict: it ends at 0.5 if p decides, and otherwise includes 0.5. It is
// dropped if A12 is not on the verdict's side of 0.5, since A12 of paired values counts blocks, and signed ranks do
// not.
void settle_a12(Verdict verdict, Dominance& dominance) {
  constexpr double alike = 0.5;
  std::optional<Interval>& interval = dominance.interval;
  if (!interval) return;
  const double side = verdict == Verdict::better ? 1 : -1;
  if (is_difference(verdict) && side * (dominance.a12() - alike) <= 0) {
    interval.reset();
    return;
  }
  if (!is_difference(verdict)) {
    interval = {std::min(alike, interval->low), std::max(alike, interval->high)};
  } else if (verdict == Verdict::better && interval->low <= alike) {
    *interval = {.low = alike, .high = interval->high, .excludes_low = true};
  } else if (verdict == Verdict::worse && interval->high >= alike) {
    *interval = {.low = interval->low, .high = alike, .excludes_high = true};
  }
  if (interval->low >= interval->high) interval.reset();
}

DeterministicResult deterministic_result(const MetricSamples& samples, const AnalysisPlan& plan, const Pair& pair) {
  double first = values_of(*pair.a).front();
  double second = values_of(*pair.b).front();
  if (is_log_scale(samples)) {
    first = std::exp(first);
    second = std::exp(second);
  }
  if (is_worse_beyond_margin(samples, plan, first, second)) return {Verdict::worse};
  if (is_worse_beyond_margin(samples, plan, second, first)) return {Verdict::better};
  return {Verdict::equivalent};
}

// Returns the comparison of a pair, without a result.
Comparison comparison_of(const Pair& pair) {
  return {.first = pair.a->name,
          .second = pair.b->name,
          .first_index = pair.first_index,
          .second_index = pair.second_index,
          .scale = pair.scale};
}

// Returns about how many values would find a difference as large as here with a chance of 0.8, by the root law of
// every test here; 0 if that is not known, because a large p says nothing of how large the difference is.
int required_n(const Pair& pair, const UnadjustedTest& outcome, double adjusted_p, double alpha) {
  const double enough = std::ceil(pair.n * std::pow((critical_z(alpha) + critical_z(0.4)) / critical_z(outcome.p), 2));
  return adjusted_p < 0.5 && enough > pair.n && enough < 1e6 ? static_cast<int>(enough) : 0;
}

// Sets verdict and interval of a difference that p decides. An estimate or an end of the interval that would refute p
// is dropped.
void set_difference(const MetricSamples& samples, int direction, Comparison& comparison, TestResult& tested,
                    std::optional<Interval>& interval) {
  const double null = null_value(comparison.scale);
  tested.verdict = (direction > 0) == (samples.better == Better::larger) ? Verdict::better : Verdict::worse;
  if (comparison.estimate && (comparison.estimate->value - null) * direction <= 0) comparison.estimate.reset();
  if (interval && direction > 0 && interval->low <= null) {
    interval->low = null;
    interval->excludes_low = true;
  }
  if (interval && direction < 0 && interval->high >= null) {
    interval->high = null;
    interval->excludes_high = true;
  }
}

// Returns the interval of a pair that p does not decide, widened to include the null value.
std::optional<Interval> open_interval(const std::optional<Interval>& interval, double null, bool is_same) {
  if (!interval) return {};
  const Interval wide{std::min(null, interval->low), std::max(null, interval->high)};
  if (!is_same && wide.low >= wide.high) return {};  // most values are equal, but not all
  return wide;
}

// Returns how far the value that lies farther from the median than all others together lies from it; 0 if there is
// none.
double lone_distance(const std::vector<double>& values) {
  if (values.empty()) return 0;
  const double median = describe_values(values).median;
  double largest = 0, sum = 0;
  for (const double value : values) {
    largest = std::max(largest, std::abs(value - median));
    sum += std::abs(value - median);
  }
  return largest * (1 - 1e-9) > sum / 2 ? largest : 0;  // equal up to rounding is not farther
}

// Returns whether a group of costs per success is worth too few values for a verdict.
bool is_worth_little(const Group& group) {
  const Sample* const sample = sample_of(group);
  if (sample == nullptr || sample->effective_n == 0) return false;
  return sample->solved_targets < 4 ||
         sample->effective_n < std::min(4.0, static_cast<double>(sample->values.size()) / 2);
}

// Returns whether a difference of means rests on one value: on one that lies farther from the median of the tested
// numbers than all others together, and more than twice as far as the means lie apart. A common value added to all
// changes nothing.
bool does_one_decide(const Method& method, const Trial& trial) {
  const PairData& numbers = trial.numbers;
  const double farthest = method.is_by_difference
                              ? lone_distance(numbers.differences)
                              : std::max(lone_distance(numbers.first), lone_distance(numbers.second));
  return farthest * (1 - 1e-9) > 2 * std::abs(trial.outcome.estimate);
}

// Returns whether one value is more than half of the sum of all absolute values, and so makes a margin that is a share
// of the mean.
bool does_one_make_mean(std::span<const double> values) {
  double largest = 0, sum = 0;
  for (const double value : values) {
    largest = std::max(largest, std::abs(value));
    sum += std::abs(value);
  }
  return largest > sum / 2;
}

// Returns the comparison of a pair whose groups have the same blocks. If p decides, no estimate
// is shown that would refute p.
Comparison judged_on_common(const MetricSamples& samples, const AnalysisPlan& plan, const Pair& pair, double tests) {
  Comparison comparison = comparison_of(pair);
  if (pair.not_tested) {
    comparison.result = *pair.not_tested;
    return comparison;
  }
  const bool is_ratio = pair.scale == EffectScale::ratio, takes_logs = is_ratio && !is_log_scale(samples);
  const double alpha = plan.significance / tests;
  const Trial trial = trial_of(samples, plan, pair, takes_logs, alpha);
  const UnadjustedTest& outcome = trial.outcome;
  const auto shown = [&](double value) { return is_ratio ? std::exp(value) : value; };
  if (std::isfinite(outcome.estimate)) comparison.estimate = EffectEstimate{shown(outcome.estimate)};
  if (pair.are_both_deterministic()) {
    comparison.result = deterministic_result(samples, plan, pair);
    return comparison;
  }
  constexpr double enough_solved = 20;  // with fewer, an interval of costs with heavy tails misses too often
  const bool are_enough = trial.numbers.solved_targets >= enough_solved;
  // No interval of closed tests holds for all pairs, so that no closed test shows that a difference is small.
  const bool is_same = are_enough && !pair.closed &&
                       (trial.is_same || (takes_logs && samples.absolute_margin > 0 &&
                                          trial_of(samples, plan, pair, false, alpha).is_same));
  TestResult tested{.adjusted_p = pair.closed ? pair.closed->adjusted_p(outcome.p) : std::min(1.0, outcome.p * tests),
                    .dominance = dominance_of(samples, pair, trial.numbers, alpha),
                    .test = pair.closed ? closed_tests_name : pair.method->name,
                    .n = pair.n};
  const bool is_decided = tested.adjusted_p < plan.significance;
  const bool are_means = pair.method->by == By::means && !is_proportion(samples) && !is_log_scale(samples);
  if (are_means) tested.hedges_g = hedges_g(trial.numbers.of_first, trial.numbers.of_second);
  const bool is_margin_of_one =
      are_means && (does_one_make_mean(values_of(*pair.a)) || does_one_make_mean(values_of(*pair.b)));
  const bool is_by_few = is_decided ? are_means && does_one_decide(*pair.method, trial) : is_same && is_margin_of_one;
  // With costs per success, even a p that does not decide would come from few values.
  if (is_by_few || is_worth_little(*pair.a) || is_worth_little(*pair.b)) {
    comparison.result = NotTested{.reason = NotTestedReason::dominated, .n = pair.n};
    return comparison;
  }
  std::optional<Interval> interval;
  if (outcome.interval && are_enough) interval = Interval{shown(outcome.interval->low), shown(outcome.interval->high)};
  if (is_decided) {
    tested.is_below_margin = is_same && !is_margin_of_one;
    set_difference(samples, outcome.direction, comparison, tested, interval);
  } else {
    tested.verdict = is_same ? Verdict::equivalent : Verdict::inconclusive;
    interval = open_interval(interval, null_value(pair.scale), is_same);
    if (!is_same) tested.required_n = required_n(pair, outcome, tested.adjusted_p, alpha);
  }
  if (comparison.estimate) comparison.estimate->interval = interval;
  if (tested.dominance) settle_a12(tested.verdict, *tested.dominance);
  comparison.result = tested;
  return comparison;
}

// Returns the comparison of a pair. To save memory, the two groups are copied only if their blocks differ, and only for
// this call.
Comparison judged(const MetricSamples& samples, const AnalysisPlan& plan, const Pair& pair, double tests) {
  if (!has_other_blocks(*pair.a, *pair.b)) return judged_on_common(samples, plan, pair, tests);
  Group a = *pair.a, b = *pair.b;
  keep_common_blocks({&a, &b});
  Pair common = pair;
  common.a = &a;
  common.b = &b;
  return judged_on_common(samples, plan, common, tests);
}

// Returns why a pair of any size cannot be tested. If there are several reasons, returns the first in the order of the
// enum.
std::optional<NotTestedReason> reason_of(const Method& method, const Group& a, const Group& b, bool may_hold_copies) {
  const auto is_infinite = [](double value) { return std::isinf(value); };
  const auto has_no_answer = [&](const Group& group) {
    return !values_of(group).empty() && std::ranges::all_of(values_of(group), is_infinite);
  };
  std::optional<NotTestedReason> first;
  const auto add = [&](NotTestedReason reason) { first = first ? std::min(*first, reason) : reason; };
  if (has_no_answer(a) && has_no_answer(b)) add(NotTestedReason::no_answer);
  if (may_hold_copies && is_constant(a) && is_constant(b)) add(NotTestedReason::copies);
  for (const Group* const group : {&a, &b}) {
    if (method.by == By::means && std::ranges::any_of(values_of(*group), is_infinite))
      add(NotTestedReason::infinite_values);
    if (const ExcludedSample* const sample = excluded(*group)) add(not_tested_reason(sample->reason));
  }
  return first;
}

// Returns the groups with ascending values, so that no pair sorts values again; empty if the samples are paired, since
// paired values belong together by their places.
std::vector<Group> sorted_groups(const MetricSamples& samples) {
  if (samples.is_paired) return {};
  std::vector<Group> groups = samples.groups;
  for (Group& group : groups)
    if (auto* const sample = std::get_if<Sample>(&group.sample)) std::ranges::sort(sample->values);
  return groups;
}

EffectScale estimate_scale(const MetricSamples& samples, const Method& method) {
  const bool are_logs = is_log_scale(samples) || method.by == By::ranks;
  if (effect_scale(samples) == EffectScale::ratio && !are_logs) return EffectScale::difference;
  return effect_scale(samples);
}

Pair pair_of(const MetricSamples& samples, const AnalysisPlan& plan, std::size_t first, std::size_t second) {
  const Group &a = samples.groups[first], &b = samples.groups[second];
  Pair pair{.a = &a, .b = &b, .method = &method_of(samples, plan, a, b), .first_index = first, .second_index = second};
  pair.scale = estimate_scale(samples, *pair.method);
  const auto [m, n] = common_sizes(a, b);
  const std::size_t few = std::min(m, n), many = std::max(m, n);
  pair.n = static_cast<int>(few > 0 && pair.has_deterministic() ? many : few);
  if (const auto reason = reason_of(*pair.method, a, b, samples.may_hold_copies))
    pair.not_tested = NotTested{.reason = *reason, .n = pair.n};
  else if (pair.n < samples.min_blocks)
    pair.not_tested =
        NotTested{.reason = NotTestedReason::sample_too_small, .n = pair.n, .required_n = samples.min_blocks};
  std::size_t differences = many;  // against a group of equal values, each value of the other group is one difference
  if (is_constant(b)) differences = m;
  if (is_constant(a)) differences = n;
  pair.smallest_p = pair.n == 0 ? 1 : pair.method->smallest_p(m, n, differences);
  return pair;
}

// Throws std::invalid_argument, which names all groups, if the plan's control is no group.
void require_control(const MetricSamples& samples, const AnalysisPlan& plan) {
  if (plan.control.empty() || index_of(samples, plan.control) < samples.groups.size()) return;
  std::vector<std::string> names;
  names.reserve(samples.groups.size());
  for (const Group& group : samples.groups) names.push_back(group.name);
  const std::string message = base::unknown_name("label", plan.control, names);
  throw std::invalid_argument(fmt::format("--control: {}", base::front(message, 1000)));
}

// Returns the pairs that the plan asks for. `sorted` has the groups with ascending values, or is empty.
std::vector<Pair> pairs_of(const MetricSamples& samples, const std::vector<Group>& sorted, const AnalysisPlan& plan) {
  require_control(samples, plan);
  const auto is_control = [&](std::size_t group) { return samples.groups[group].name == plan.control; };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < samples.groups.size(); ++i) {
    for (std::size_t j = i + 1; j < samples.groups.size(); ++j) {
      if (!plan.control.empty() && !is_control(i) && !is_control(j)) continue;
      Pair& pair = pairs.emplace_back(pair_of(samples, plan, i, j));
      if (pair.method->by != By::ranks || sorted.empty()) continue;
      pair.a = &sorted[i];
      pair.b = &sorted[j];
    }
  }
  return pairs;
}

// Returns the smallest size of both groups with which the test of this pair can reach the level.
int smallest_testable_n(const Pair& pair, double level) {
  int n = 2;
  const auto smallest_p = [&] {
    const auto size = static_cast<std::size_t>(n);
    return pair.method->smallest_p(pair.has_deterministic() ? 1 : size, size, size);
  };
  while (smallest_p() >= level) ++n;
  return n;
}

// Returns the size of the family: the number of pairs that could reach the level with samples of these sizes, which is
// decided before any p is known. Pairs that cannot reach the level leave the family, those with the largest smallest p
// first, and are set to not tested.
std::size_t testable(std::vector<std::vector<Pair>>& members, double significance) {
  std::vector<Pair*> family;
  for (std::vector<Pair>& pairs : members)
    for (Pair& pair : pairs)
      if (!pair.not_tested && !pair.are_both_deterministic()) family.push_back(&pair);
  while (!family.empty()) {
    const double level = significance / static_cast<double>(family.size());
    const double worst = (*std::ranges::max_element(family, {}, &Pair::smallest_p))->smallest_p;
    if (worst < level) break;
    std::erase_if(family, [&](Pair* pair) {
      if (pair->smallest_p < worst) return false;
      pair->not_tested = NotTested{
          .reason = NotTestedReason::sample_too_small, .n = pair->n, .required_n = smallest_testable_n(*pair, level)};
      return true;
    });
  }
  return family.size();
}

// Returns the pairs that signed ranks would test if the blocks were more; empty if another pair is tested.
std::vector<Pair*> with_few_blocks(std::vector<Pair>& pairs) {
  std::vector<Pair*> few;
  for (Pair& pair : pairs) {
    if (!pair.not_tested && !pair.are_both_deterministic()) return {};
    if (!pair.not_tested || pair.not_tested->reason != NotTestedReason::sample_too_small) continue;
    if (pair.method == &signed_ranks) few.push_back(&pair);
  }
  return few;
}

// Lets closed tests decide the pairs of one metric, if signed ranks cannot decide any of them, and if the blocks that
// all groups have suffice. Otherwise sets how many blocks would suffice. Returns the number of pairs that are tested.
std::size_t add_closed_tests(const MetricSamples& samples, std::vector<Pair>& pairs, double significance,
                             double metrics) {
  const std::vector<Pair*> few = with_few_blocks(pairs);
  std::map<std::size_t, std::size_t> places;  // in `groups`, by the places in the samples
  for (const Pair* const pair : few) {
    places.try_emplace(pair->first_index);
    places.try_emplace(pair->second_index);
  }
  if (!may_be_closed(places.size())) return 0;
  std::vector<Group> groups;
  for (auto& [index, place] : places) {
    place = groups.size();
    groups.push_back(samples.groups[index]);
  }
  const std::vector<std::vector<double>> columns =
      settled_blocks(std::move(groups), samples, few.front()->scale == EffectScale::ratio);
  const std::size_t k = columns.size(), blocks = columns.front().size();
  const double level = level_of_set(2, k, significance);
  if (min_p_paired(blocks) >= level) {
    for (Pair* const pair : few)
      if (pair->smallest_p >= level) pair->not_tested->required_n = smallest_testable_n(*pair, level);
    return 0;
  }
  const std::vector<double> largest = largest_p_of_sets({columns.begin(), columns.end()});
  for (Pair* const pair : few) {
    const std::size_t place = places.at(pair->first_index) * k + places.at(pair->second_index);
    pair->closed = ClosedTests{.largest_p = largest[place], .groups = k, .metrics = metrics};
    pair->not_tested.reset();
  }
  return few.size();
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  constexpr std::array<std::string_view, 5> names{"better", "worse", "same", "inconclusive", "not tested"};
  return names[static_cast<std::size_t>(verdict)];
}

NotTestedReason not_tested_reason(ExclusionReason reason) {
  switch (reason) {
    case ExclusionReason::missing_values:
      return NotTestedReason::missing_values;
    case ExclusionReason::infinite_values:
      return NotTestedReason::infinite_values;
    case ExclusionReason::not_comparable:
      return NotTestedReason::not_comparable;
    case ExclusionReason::zero_spread:
      return NotTestedReason::zero_spread;
    case ExclusionReason::nothing_solved:
      return NotTestedReason::nothing_solved;
  }
  return NotTestedReason::not_comparable;
}

Verdict verdict_of(const Comparison& comparison) {
  if (const auto* const tested = std::get_if<TestResult>(&comparison.result)) return tested->verdict;
  if (const auto* const exact = std::get_if<DeterministicResult>(&comparison.result)) return exact->verdict;
  return is_not_tested(comparison, NotTestedReason::dominated) ? Verdict::inconclusive : Verdict::not_tested;
}

bool is_not_tested(const Comparison& comparison, NotTestedReason reason) {
  const auto* const not_tested = std::get_if<NotTested>(&comparison.result);
  return not_tested != nullptr && not_tested->reason == reason;
}

bool are_by_closed_tests(const std::vector<Comparison>& comparisons) {
  return std::ranges::any_of(comparisons, [](const Comparison& comparison) {
    const auto* const tested = std::get_if<TestResult>(&comparison.result);
    return tested != nullptr && tested->test == closed_tests_name;
  });
}

bool all_values_equal(const Comparison& comparison) {
  if (std::holds_alternative<DeterministicResult>(comparison.result))
    return comparison.estimate && comparison.estimate->value == null_value(comparison.scale);
  const auto* const tested = std::get_if<TestResult>(&comparison.result);
  return tested != nullptr && tested->dominance && tested->dominance->better == 0 && tested->dominance->worse == 0;
}

bool is_dominated(const Group& group) {
  const std::vector<double> values(values_of(group).begin(), values_of(group).end());
  return is_worth_little(group) || lone_distance(values) > 0 || does_one_make_mean(values);
}

bool is_difference(Verdict verdict) { return verdict == Verdict::better || verdict == Verdict::worse; }

Verdict reversed(Verdict verdict) {
  switch (verdict) {
    case Verdict::better:
      return Verdict::worse;
    case Verdict::worse:
      return Verdict::better;
    case Verdict::equivalent:
    case Verdict::inconclusive:
    case Verdict::not_tested:
      break;
  }
  return verdict;
}

std::set<std::string> beaten_solvers(const std::vector<Comparison>& comparisons) {
  std::set<std::string> beaten;
  for (const Comparison& comparison : comparisons) {
    const Verdict verdict = verdict_of(comparison);
    if (is_difference(verdict)) beaten.insert(verdict == Verdict::better ? comparison.second : comparison.first);
  }
  return beaten;
}

std::vector<Comparison> compare_pairs(const MetricSamples& samples, const AnalysisPlan& plan, std::size_t metrics) {
  return std::move(compare_pairs({{&samples, &plan}}, metrics).front());
}

std::vector<std::vector<Comparison>> compare_pairs(const std::vector<FamilyMember>& family, std::size_t metrics) {
  std::vector<std::vector<Pair>> members;
  std::vector<std::vector<Group>> sorted;
  members.reserve(family.size());
  sorted.reserve(family.size());
  for (const FamilyMember& member : family) sorted.push_back(sorted_groups(*member.samples));
  for (std::size_t i = 0; i < family.size(); ++i)
    members.push_back(pairs_of(*family[i].samples, sorted[i], *family[i].plan));
  const auto shares = static_cast<double>(metrics);
  const double significance = family.front().plan->significance / shares;
  std::size_t tested = testable(members, significance);
  if (tested == 0 && family.size() == 1)
    tested = add_closed_tests(*family[0].samples, members[0], significance, shares);
  const double tests = shares * static_cast<double>(std::max<std::size_t>(1, tested));
  std::vector<std::vector<Comparison>> comparisons(family.size());
  for (std::size_t i = 0; i < family.size(); ++i)
    for (const Pair& pair : members[i])
      comparisons[i].push_back(judged(*family[i].samples, *family[i].plan, pair, tests));
  return comparisons;
}

Comparison better_first(Comparison comparison, std::string_view control, bool is_second_ahead) {
  const Verdict verdict = verdict_of(comparison);
  const bool is_behind = is_difference(verdict) ? verdict == Verdict::worse : is_second_ahead;
  const bool is_in_order = control.empty() ? !is_behind : comparison.first != control;
  if (is_in_order) return comparison;
  std::swap(comparison.first, comparison.second);
  std::swap(comparison.first_index, comparison.second_index);
  if (auto& estimate = comparison.estimate) {
    const auto mirrored = [&](double value) { return comparison.scale == EffectScale::ratio ? 1 / value : 0 - value; };
    estimate->value = mirrored(estimate->value);
    if (const auto interval = estimate->interval)
      estimate->interval =
          Interval{mirrored(interval->high), mirrored(interval->low), interval->excludes_high, interval->excludes_low};
  }
  if (auto* const exact = std::get_if<DeterministicResult>(&comparison.result))
    exact->verdict = reversed(exact->verdict);
  if (auto* const tested = std::get_if<TestResult>(&comparison.result)) {
    tested->verdict = reversed(tested->verdict);
    if (auto& dominance = tested->dominance) {
      std::swap(dominance->better, dominance->worse);
      if (const auto interval = dominance->interval)
        dominance->interval =
            Interval{1 - interval->high, 1 - interval->low, interval->excludes_high, interval->excludes_low};
    }
    if (tested->hedges_g) tested->hedges_g = -*tested->hedges_g;
  }
  return comparison;
}

bool is_worse_beyond_margin(const MetricSamples& samples, const AnalysisPlan& plan, double value, double other) {
  if (effect_scale(samples) == EffectScale::ratio) {
    value = std::max(value, floor_of(samples));
    other = std::max(other, floor_of(samples));
  }
  const double unit = is_proportion(samples) ? 1 : std::min(std::abs(value), std::abs(other));
  const double loss = samples.better == Better::smaller ? value - other : other - value;
  return loss > std::max(samples.absolute_margin, plan.margin * unit) + samples.resolution;
}

}  // namespace ikbench::judge
