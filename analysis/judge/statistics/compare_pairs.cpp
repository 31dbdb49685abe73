#include "analysis/judge/statistics/compare_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <utility>

#include "analysis/judge/statistics/descriptives.hpp"
#include "analysis/judge/statistics/pair_data.hpp"
#include "base/names.hpp"

namespace ikbench::judge {
namespace {

// What a test does with two groups.
struct Method {
  enum class By { ranks, means, shares };

  std::string_view name;
  By by;
  bool is_by_difference;  // of pairs, or of values and the one of a solver that repeats itself
  UnadjustedTest (*test)(const PairData& its, double alpha);
  bool is_by_values_too = false;

  // That groups of these sizes, and so many differences, can give.
  double smallest_p(std::size_t m, std::size_t n, std::size_t differences) const {
    const std::size_t few = std::min(m, n);
    // Of two values the larger is more than half of their sum.
    if (by == By::means && (m == n || !is_by_difference)) return few < 3 ? 1 : 0;
    const double by_differences = is_by_difference ? min_p_paired(differences) : 0;
    if (is_by_difference && !is_by_values_too) return by_differences;
    // The rarest table of Fisher's test is one, or of groups of one size two: all of one solved and none of the other,
    // or the other way round.
    const double by_values = few < 2 ? 1 : min_p_unpaired(m, n) / (by == By::shares && m != n ? 2 : 1);
    return std::max(by_differences, by_values);
  }
};

using By = Method::By;

constexpr Method unpaired_ranks{"Brunner-Munzel and Mann-Whitney", By::ranks, false,
                                [](auto& its, double alpha) { return rank_test(its.first, its.second, alpha); }};
constexpr Method signed_ranks{"Wilcoxon's signed ranks", By::ranks, true,
                              [](auto& its, double alpha) { return signed_rank_test(its.differences, alpha); }};
constexpr Method signs{"sign test", By::ranks, true,
                       [](auto& its, double alpha) { return sign_test(its.differences, alpha); }};
constexpr Method signs_and_ranks{"sign test and Mann-Whitney", By::ranks, true,
                                 [](auto& its, double alpha) {
                                   UnadjustedTest outcome = sign_test(its.differences, alpha);
                                   outcome.p = std::max(outcome.p, mann_whitney(its.first, its.second));
                                   return outcome;
                                 },
                                 true};
constexpr Method paired_t{"paired t", By::means, true,
                          [](auto& its, double alpha) { return t_test(its.differences, alpha, its.effective_n); }};
constexpr Method one_t{"one-sample t", By::means, true, paired_t.test};
constexpr Method unpaired_t{"Welch's t", By::means, false, [](auto& its, double alpha) {
                              return welch(its.of_first, its.of_second, alpha, its.effective_n);
                            }};
constexpr Method paired_shares{"McNemar's exact", By::shares, true,
                               [](auto& its, double alpha) { return mcnemar(its.first, its.second, alpha); }};
constexpr Method unpaired_shares{"Fisher's exact", By::shares, false,
                                 [](auto& its, double alpha) { return fisher(its.first, its.second, alpha); }};

// By what is compared: unpaired, paired, and against the one value of a solver that repeats itself.
constexpr const Method* methods[][3]{{&unpaired_ranks, &signed_ranks, &signs},
                                     {&unpaired_t, &paired_t, &one_t},
                                     {&unpaired_shares, &paired_shares, &one_t}};

// What design and plan choose, never the values, unless a file's may be copies.
const Method& method_of(const MetricSamples& samples, const AnalysisPlan& plan, const Group& a, const Group& b) {
  const bool is_printed =
      std::holds_alternative<SummaryStatistics>(a.sample) || std::holds_alternative<SummaryStatistics>(b.sample);
  const bool is_one = repeats_itself(a) || repeats_itself(b), is_share = is_proportion(samples);
  const bool by_means =
      is_printed || is_share || is_log_scale(samples) || (plan.test == AnalysisPlan::Test::means && !is_one);
  const By by = is_share && trials_per_value(samples) == 1 && samples.min_blocks == 0 && !is_printed ? By::shares
                : by_means                                                                           ? By::means
                                                                                                     : By::ranks;
  if (by == By::ranks && !samples.is_paired && !is_one && is_constant(a) != is_constant(b)) return signs_and_ranks;
  return *methods[static_cast<std::size_t>(by)][is_printed ? 0 : is_one ? 2 : samples.is_paired];
}

std::size_t size_of(const Group& group) {
  if (const auto* const summary = std::get_if<SummaryStatistics>(&group.sample))
    return static_cast<std::size_t>(summary->n);
  return values_of(group).size();
}

// Two groups of the observations, which outlive it: pairs are many, so each holds no values.
struct Pair {
  const Group *a, *b;
  const Method* method;
  std::size_t first_index = 0, second_index = 0;  // of the groups in the observations
  EffectScale scale = EffectScale::difference;    // of the amount
  double smallest_p = 1;
  int n = 0;
  std::optional<NotTested> open = {};

  bool has_one() const { return repeats_itself(*a) || repeats_itself(*b); }  // one value for all runs
  bool is_fact() const { return repeats_itself(*a) && repeats_itself(*b); }
};

// Returns whether two groups have different blocks, so that only some are common.
bool has_other_blocks(const Group& a, const Group& b) {
  const Sample *const of_a = sample_of(a), *const of_b = sample_of(b);
  return of_a != nullptr && of_b != nullptr && of_a->blocks != of_b->blocks;
}

// The sizes of the two groups in the blocks that both have.
std::pair<std::size_t, std::size_t> common_sizes(const Group& a, const Group& b) {
  if (!has_other_blocks(a, b)) return {size_of(a), size_of(b)};
  const Sample *const of_a = sample_of(a), *const of_b = sample_of(b);
  const auto is_in_a = [&](int block) { return std::ranges::binary_search(of_a->blocks, block); };
  const auto common = static_cast<std::size_t>(std::ranges::count_if(of_b->blocks, is_in_a));
  return {common, common};
}

// A pair on one scale: its numbers, what the test says of them, and whether a difference lies within the margin there.
struct Trial {
  PairData numbers;
  UnadjustedTest outcome;
  bool is_same = false;
};

Trial trial_of(const MetricSamples& samples, const AnalysisPlan& plan, const Pair& pair, bool takes_logs,
               double alpha) {
  Trial trial{.numbers = make_pair_data(*pair.a, *pair.b, samples, pair.method->is_by_difference, takes_logs),
              .outcome = {}};
  const PairData& numbers = trial.numbers;
  const SummaryStatistics &first = numbers.of_first, &second = numbers.of_second;
  trial.outcome = pair.method->test(numbers, alpha);
  std::optional<Interval>& interval = trial.outcome.interval;
  if (is_proportion(samples)) {
    if (interval) interval = Interval{std::max(-1.0, interval->low), std::min(1.0, interval->high)};
    if (first.sd == 0 && second.sd == 0 && numbers.are_all_equal && !interval)
      interval = newcombe_interval(first.mean, first.n, second.mean, second.n, alpha);
  } else if (numbers.are_all_equal) {
    interval.reset();
  }
  // As shown: a mean may be that of one huge value.
  const auto centre = [&](const std::vector<double>& values, const SummaryStatistics& its) {
    return pair.method->by == By::ranks ? describe_values(values).median : its.mean;
  };
  const double one = centre(numbers.first, first), other = centre(numbers.second, second);
  const double relative = numbers.infinity_substitute > 0 ? 0 : plan.margin * std::min(std::abs(one), std::abs(other));
  const double margin = is_proportion(samples)                ? plan.margin
                        : takes_logs || is_log_scale(samples) ? std::log1p(plan.margin)
                                                              : std::max(samples.absolute_margin, relative);
  const auto lies_within = [&](const UnadjustedTest& outcome) {  // values without spread have their difference alone
    const Interval held = outcome.interval.value_or(Interval{outcome.estimate, outcome.estimate});
    return held.low >= -margin * (1 + 1e-9) && held.high <= margin * (1 + 1e-9);  // up to rounding
  };
  const Method& by_means = pair.method->is_by_difference ? paired_t : unpaired_t;
  const bool is_small = lies_within(trial.outcome);
  trial.outcome.estimate = numbers.restore_infinity(trial.outcome.estimate);
  if (interval)
    interval->low = numbers.restore_infinity(interval->low), interval->high = numbers.restore_infinity(interval->high);
  // Equal values, and few that differ by one number, say nothing of failures that are rarer than so many can show.
  const bool are_equal = interval ? interval->low == 0 && interval->high == 0 : numbers.are_all_equal;
  const bool has_width = interval && interval->low < interval->high;
  const double rare = plan.margin > 0 ? plan.margin : AnalysisPlan().margin;  // an absolute margin is none of shares
  const bool can_fail = (are_equal || (!has_width && trial.outcome.p >= alpha)) &&
                        1 - wilson_interval(1, std::min(first.n, second.n), alpha).low > rare;
  // Ranks alone would not see that rare values are far apart, nor ratios in blocks that the medians shown are.
  trial.is_same = is_small && !can_fail && lies_within({.estimate = one - other}) &&
                  (pair.method->by != By::ranks || lies_within(by_means.test(numbers, alpha)));
  return trial;
}

std::optional<Dominance> effect_of(const MetricSamples& samples, const Pair& pair, const PairData& numbers) {
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
  return samples.better == Better::larger ? Dominance{larger / pairs, smaller / pairs}
                                          : Dominance{smaller / pairs, larger / pairs};
}

DeterministicResult fact_of(const MetricSamples& samples, const AnalysisPlan& plan, const Pair& pair) {
  double one = values_of(*pair.a).front(), other = values_of(*pair.b).front();
  if (is_log_scale(samples)) one = std::exp(one), other = std::exp(other);
  return {is_worse_beyond_margin(samples, plan, one, other)   ? Verdict::worse
          : is_worse_beyond_margin(samples, plan, other, one) ? Verdict::better
                                                              : Verdict::equivalent};
}

// Returns the comparison of a pair, without a result.
Comparison comparison_of(const Pair& pair) {
  return {.first = pair.a->name,
          .second = pair.b->name,
          .first_index = pair.first_index,
          .second_index = pair.second_index,
          .scale = pair.scale};
}

// The verdict of p, with an amount that cannot refute it. The pair's groups have the same blocks.
Comparison judged_on_common(const MetricSamples& samples, const AnalysisPlan& plan, const Pair& pair, double tests) {
  Comparison comparison = comparison_of(pair);
  if (pair.open) {
    comparison.result = *pair.open;
    return comparison;
  }
  const bool is_ratio = pair.scale == EffectScale::ratio, takes_logs = is_ratio && !is_log_scale(samples);
  const bool are_means = pair.method->by == By::means && !is_proportion(samples);
  const double alpha = plan.significance / tests, none = null_value(pair.scale);
  const Trial trial = trial_of(samples, plan, pair, takes_logs, alpha);
  constexpr double enough_solved = 20;  // of fewer, an interval of costs with heavy tails misses too often
  const bool are_enough = trial.numbers.solved_targets >= enough_solved;
  const bool is_same = are_enough && (trial.is_same || (takes_logs && samples.absolute_margin > 0 &&
                                                        trial_of(samples, plan, pair, false, alpha).is_same));
  const UnadjustedTest& outcome = trial.outcome;
  const auto shown = [&](double value) { return is_ratio ? std::exp(value) : value; };
  if (std::isfinite(outcome.estimate)) comparison.estimate = EffectEstimate{shown(outcome.estimate)};
  if (pair.is_fact()) {
    comparison.result = fact_of(samples, plan, pair);
    return comparison;
  }
  TestResult tested{.adjusted_p = std::min(1.0, outcome.p * tests),
                    .dominance = effect_of(samples, pair, trial.numbers),
                    .test = pair.method->name,
                    .n = pair.n};
  const bool is_decided = tested.adjusted_p < plan.significance;
  if (are_means && !is_log_scale(samples)) tested.hedges_g = hedges_g(trial.numbers.of_first, trial.numbers.of_second);
  // Of logarithms p itself would be that of few.
  if (are_means && (is_log_scale(samples) || is_same || is_decided) &&
      (is_dominated(*pair.a) || is_dominated(*pair.b))) {
    comparison.result = NotTested{.reason = NotTestedReason::dominated, .n = pair.n};
    return comparison;
  }
  std::optional<Interval> interval;
  if (outcome.interval && are_enough) interval = Interval{shown(outcome.interval->low), shown(outcome.interval->high)};
  if (is_decided) {
    const int direction = outcome.direction;
    tested.verdict = (direction > 0) == (samples.better == Better::larger) ? Verdict::better : Verdict::worse;
    tested.is_below_margin = is_same;
    if (comparison.estimate && (comparison.estimate->value - none) * direction <= 0) comparison.estimate.reset();
    if (interval && direction > 0 && interval->low <= none) interval->low = none, interval->excludes_low = true;
    if (interval && direction < 0 && interval->high >= none) interval->high = none, interval->excludes_high = true;
  } else {
    tested.verdict = is_same ? Verdict::equivalent : Verdict::inconclusive;
    if (interval) interval = Interval{std::min(none, interval->low), std::max(none, interval->high)};
    if (!is_same && interval && interval->low >= interval->high) interval.reset();  // most are equal, but not all
    // With a chance of 0.8, if the difference is as large as here, by the root law of every test here. A larger p says
    // nothing of how large it is.
    const double enough =
        std::ceil(pair.n * std::pow((critical_z(alpha) + critical_z(0.4)) / critical_z(outcome.p), 2));
    if (!is_same && tested.adjusted_p < 0.5 && enough > pair.n && enough < 1e6)
      tested.required_n = static_cast<int>(enough);
  }
  if (comparison.estimate) comparison.estimate->interval = interval;
  comparison.result = tested;
  return comparison;
}

// Copies the two groups only where their blocks differ, and only while they are judged.
Comparison judged(const MetricSamples& samples, const AnalysisPlan& plan, const Pair& pair, double tests) {
  if (!has_other_blocks(*pair.a, *pair.b)) return judged_on_common(samples, plan, pair, tests);
  Group a = *pair.a, b = *pair.b;
  keep_common_blocks({&a, &b});
  Pair common = pair;
  common.a = &a;
  common.b = &b;
  return judged_on_common(samples, plan, common, tests);
}

// Returns why a pair cannot be tested, whatever its size; the first reason, if there are several.
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

// Groups whose values rise, so that no pair sorts them again; none where values belong together by their places.
std::vector<Group> rising_groups(const MetricSamples& samples) {
  if (samples.is_paired) return {};
  std::vector<Group> groups = samples.groups;
  for (Group& group : groups)
    if (auto* const its = std::get_if<Sample>(&group.sample)) std::ranges::sort(its->values);
  return groups;
}

// The pairs that the plan asks for. Throws std::invalid_argument, which names all groups, if the control is none.
std::vector<Pair> pairs_of(const MetricSamples& samples, const std::vector<Group>& rising, const AnalysisPlan& plan) {
  if (!plan.control.empty() && index_of(samples, plan.control) == samples.groups.size()) {
    std::vector<std::string> names;
    for (const Group& group : samples.groups) names.push_back(group.name);
    const std::string unknown = base::unknown_name("label", plan.control, names);
    throw std::invalid_argument(fmt::format("--control: {}", base::front(unknown, 1000)));
  }
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < samples.groups.size(); ++i) {
    for (std::size_t j = i + 1; j < samples.groups.size(); ++j) {
      const Group *const a = &samples.groups[i], *const b = &samples.groups[j];
      if (!plan.control.empty() && a->name != plan.control && b->name != plan.control) continue;
      Pair& pair = pairs.emplace_back(
          Pair{.a = a, .b = b, .method = &method_of(samples, plan, *a, *b), .first_index = i, .second_index = j});
      if (pair.method->by == By::ranks && !rising.empty()) {
        pair.a = &rising[i];
        pair.b = &rising[j];
      }
      const bool has_differences =
          effect_scale(samples) == EffectScale::ratio && pair.method->by != By::ranks && !is_log_scale(samples);
      pair.scale = has_differences ? EffectScale::difference : effect_scale(samples);
      const auto [m, n] = common_sizes(*a, *b);
      const std::size_t few = std::min(m, n), many = std::max(m, n);
      pair.n = static_cast<int>(few > 0 && pair.has_one() ? many : few);
      if (const auto why = reason_of(*pair.method, *a, *b, samples.may_hold_copies))
        pair.open = NotTested{.reason = *why, .n = pair.n};
      else if (pair.n < samples.min_blocks)
        pair.open =
            NotTested{.reason = NotTestedReason::sample_too_small, .n = pair.n, .required_n = samples.min_blocks};
      const std::size_t differences = is_constant(*a) ? n : is_constant(*b) ? m : many;
      pair.smallest_p = pair.n == 0 ? 1 : pair.method->smallest_p(m, n, differences);
    }
  }
  return pairs;
}

// How many pairs data of this size can decide, before any p is known: those that cannot leave, the least able first.
std::size_t testable(std::vector<std::vector<Pair>>& members, double significance) {
  std::vector<Pair*> family;
  for (std::vector<Pair>& pairs : members)
    for (Pair& pair : pairs)
      if (!pair.open && !pair.is_fact()) family.push_back(&pair);
  while (!family.empty()) {
    const double level = significance / static_cast<double>(family.size());
    const double worst = (*std::ranges::max_element(family, {}, &Pair::smallest_p))->smallest_p;
    if (worst < level) break;
    std::erase_if(family, [&](Pair* pair) {
      if (pair->smallest_p < worst) return false;
      std::size_t n = 2;
      while (pair->method->smallest_p(pair->has_one() ? 1 : n, n, n) >= level) ++n;
      pair->open =
          NotTested{.reason = NotTestedReason::sample_too_small, .n = pair->n, .required_n = static_cast<int>(n)};
      return true;
    });
  }
  return family.size();
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  constexpr std::array<std::string_view, 5> names{"better", "worse", "same", "not decided", "not tested"};
  return names[static_cast<std::size_t>(verdict)];
}

Verdict verdict_of(const Comparison& comparison) {
  if (const auto* const tested = std::get_if<TestResult>(&comparison.result)) return tested->verdict;
  if (const auto* const fact = std::get_if<DeterministicResult>(&comparison.result)) return fact->verdict;
  return is_not_tested(comparison, NotTestedReason::dominated) ? Verdict::inconclusive : Verdict::not_tested;
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

bool is_not_tested(const Comparison& comparison, NotTestedReason reason) {
  const auto* const open = std::get_if<NotTested>(&comparison.result);
  return open != nullptr && open->reason == reason;
}

bool all_values_equal(const Comparison& comparison) {
  if (std::holds_alternative<DeterministicResult>(comparison.result))
    return comparison.estimate->value == null_value(comparison.scale);
  const auto* const tested = std::get_if<TestResult>(&comparison.result);
  return tested != nullptr && tested->dominance && tested->dominance->better == 0 && tested->dominance->worse == 0;
}

bool is_dominated(const Group& group) {
  if (const Sample* const its = sample_of(group); its && its->effective_n > 0)
    return its->solved_targets < 4 || its->effective_n < std::min(4.0, static_cast<double>(its->values.size()) / 2);
  double largest = 0, sum = 0;
  for (const double value : values_of(group)) largest = std::max(largest, std::abs(value)), sum += std::abs(value);
  return largest > sum / 2;
}

bool is_difference(Verdict verdict) { return verdict == Verdict::better || verdict == Verdict::worse; }

Verdict reversed(Verdict verdict) {
  return verdict == Verdict::better ? Verdict::worse : verdict == Verdict::worse ? Verdict::better : verdict;
}

std::set<std::string> beaten_solvers(const std::vector<Comparison>& comparisons) {
  std::set<std::string> losers;
  for (const Comparison& comparison : comparisons) {
    const Verdict verdict = verdict_of(comparison);
    if (is_difference(verdict)) losers.insert(verdict == Verdict::better ? comparison.second : comparison.first);
  }
  return losers;
}

std::vector<Comparison> compare(const MetricSamples& samples, const AnalysisPlan& plan, std::size_t metrics) {
  return std::move(compare({{&samples, &plan}}, metrics).front());
}

std::vector<std::vector<Comparison>> compare(const std::vector<FamilyMember>& family, std::size_t metrics) {
  std::vector<std::vector<Pair>> members;
  std::vector<std::vector<Group>> rising;
  for (const FamilyMember& member : family) rising.push_back(rising_groups(*member.samples));
  for (std::size_t i = 0; i < family.size(); ++i)
    members.push_back(pairs_of(*family[i].samples, rising[i], *family[i].plan));
  const auto shares = static_cast<double>(metrics);
  const double significance = family.front().plan->significance / shares;
  const double tests = shares * static_cast<double>(std::max<std::size_t>(1, testable(members, significance)));
  std::vector<std::vector<Comparison>> comparisons(family.size());
  for (std::size_t i = 0; i < family.size(); ++i)
    for (const Pair& pair : members[i])
      comparisons[i].push_back(judged(*family[i].samples, *family[i].plan, pair, tests));
  return comparisons;
}

void set_group_indices(std::vector<Comparison>& comparisons, const MetricSamples& samples) {
  std::map<std::string_view, std::size_t> indices;
  for (const Group& group : samples.groups) indices.emplace(group.name, indices.size());
  const auto index_of_group = [&](const std::string& name) {
    const auto found = indices.find(name);
    if (found == indices.end()) throw std::invalid_argument(fmt::format("a comparison names no group: {}", name));
    return found->second;
  };
  for (Comparison& comparison : comparisons) {
    comparison.first_index = index_of_group(comparison.first);
    comparison.second_index = index_of_group(comparison.second);
  }
}

Comparison better_first(Comparison comparison, std::string_view control, bool is_second_ahead) {
  const Verdict verdict = verdict_of(comparison);
  const bool is_behind = is_difference(verdict) ? verdict == Verdict::worse : is_second_ahead;
  if (control.empty() ? !is_behind : comparison.first != control) return comparison;
  std::swap(comparison.first, comparison.second);
  std::swap(comparison.first_index, comparison.second_index);
  if (auto& amount = comparison.estimate) {
    const auto end = [&](double value) { return comparison.scale == EffectScale::ratio ? 1 / value : 0 - value; };
    amount->value = end(amount->value);
    if (const auto ends = amount->interval)
      amount->interval = Interval{end(ends->high), end(ends->low), ends->excludes_high, ends->excludes_low};
  }
  if (auto* const fact = std::get_if<DeterministicResult>(&comparison.result)) fact->verdict = reversed(fact->verdict);
  if (auto* const tested = std::get_if<TestResult>(&comparison.result)) {
    tested->verdict = reversed(tested->verdict);
    if (tested->dominance) std::swap(tested->dominance->better, tested->dominance->worse);
    if (tested->hedges_g) tested->hedges_g = -*tested->hedges_g;
  }
  return comparison;
}

bool is_worse_beyond_margin(const MetricSamples& samples, const AnalysisPlan& plan, double one, double other) {
  if (effect_scale(samples) == EffectScale::ratio)
    one = std::max(one, floor_of(samples)), other = std::max(other, floor_of(samples));
  const double relative = plan.margin * (is_proportion(samples) ? 1 : std::min(std::abs(one), std::abs(other)));
  const double loss = samples.better == Better::smaller ? one - other : other - one;
  return loss > std::max(samples.absolute_margin, relative) + samples.resolution;
}

}  // namespace ikbench::judge
