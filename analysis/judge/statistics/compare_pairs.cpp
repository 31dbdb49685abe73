#include "analysis/judge/statistics/compare_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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
                          [](auto& its, double alpha) { return t_test(its.differences, alpha, its.worth); }};
constexpr Method one_t{"one-sample t", By::means, true, paired_t.test};
constexpr Method unpaired_t{"Welch's t", By::means, false, [](auto& its, double alpha) {
                              return welch(its.of_first, its.of_second, alpha, its.worth);
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
const Method& method_of(const MetricSamples& observed, const AnalysisPlan& plan, const Group& a, const Group& b) {
  const bool is_printed =
      std::holds_alternative<SummaryStatistics>(a.sample) || std::holds_alternative<SummaryStatistics>(b.sample);
  const bool is_one = repeats_itself(a) || repeats_itself(b), is_share = observed.scale == EffectScale::share;
  const bool by_means =
      is_printed || is_share || observed.is_log_scale || (plan.test == AnalysisPlan::Test::means && !is_one);
  const By by = is_share && observed.trials == 1 && observed.fewest == 0 && !is_printed ? By::shares
                : by_means                                                              ? By::means
                                                                                        : By::ranks;
  if (by == By::ranks && !observed.is_paired && !is_one && may_be_copies(a) != may_be_copies(b)) return signs_and_ranks;
  return *methods[static_cast<std::size_t>(by)][is_printed ? 0 : is_one ? 2 : observed.is_paired];
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
  EffectScale scale = EffectScale::difference;  // of the amount
  double smallest_p = 1;
  int n = 0;
  std::optional<NotTested> open = {};

  bool has_one() const { return repeats_itself(*a) || repeats_itself(*b); }  // one value for all runs
  bool is_fact() const { return repeats_itself(*a) && repeats_itself(*b); }
};

// Returns whether two groups have different blocks, so that only some are common.
bool has_other_blocks(const Group& a, const Group& b) {
  const Measured *const of_a = measured(a), *const of_b = measured(b);
  return of_a != nullptr && of_b != nullptr && of_a->blocks != of_b->blocks;
}

// The sizes of the two groups in the blocks that both have.
std::pair<std::size_t, std::size_t> common_sizes(const Group& a, const Group& b) {
  if (!has_other_blocks(a, b)) return {size_of(a), size_of(b)};
  const Measured *const of_a = measured(a), *const of_b = measured(b);
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

Trial trial_of(const MetricSamples& observed, const AnalysisPlan& plan, const Pair& pair, bool takes_logs,
               double alpha) {
  Trial trial{.numbers = prepared(*pair.a, *pair.b, observed, pair.method->is_by_difference, takes_logs),
              .outcome = {}};
  const PairData& numbers = trial.numbers;
  const SummaryStatistics &first = numbers.of_first, &second = numbers.of_second;
  trial.outcome = pair.method->test(numbers, alpha);
  std::optional<Interval>& interval = trial.outcome.interval;
  if (observed.scale == EffectScale::share) {
    if (interval) interval = Interval{std::max(-1.0, interval->low), std::min(1.0, interval->high)};
    if (first.sd == 0 && second.sd == 0 && numbers.are_all_equal && !interval)
      interval = newcombe(first.mean, first.n, second.mean, second.n, alpha);
  } else if (numbers.are_all_equal) {
    interval.reset();
  }
  // As shown: a mean may be that of one huge value.
  const auto centre = [&](const std::vector<double>& values, const SummaryStatistics& its) {
    return pair.method->by == By::ranks ? described(values).median : its.mean;
  };
  const double one = centre(numbers.first, first), other = centre(numbers.second, second);
  const double relative = numbers.no_answer > 0 ? 0 : plan.margin * std::min(std::abs(one), std::abs(other));
  const double margin = observed.scale == EffectScale::share  ? plan.margin
                        : takes_logs || observed.is_log_scale ? std::log1p(plan.margin)
                                                              : std::max(observed.absolute_margin, relative);
  const auto lies_within = [&](const UnadjustedTest& outcome) {  // values without spread have their difference alone
    const Interval held = outcome.interval.value_or(Interval{outcome.estimate, outcome.estimate});
    return held.low >= -margin * (1 + 1e-9) && held.high <= margin * (1 + 1e-9);  // up to rounding
  };
  const Method& by_means = pair.method->is_by_difference ? paired_t : unpaired_t;
  const bool is_small = lies_within(trial.outcome);
  trial.outcome.estimate = numbers.unbound(trial.outcome.estimate);
  if (interval) interval->low = numbers.unbound(interval->low), interval->high = numbers.unbound(interval->high);
  // Equal values, and few that differ by one number, say nothing of failures that are rarer than so many can show.
  const bool are_equal = interval ? interval->low == 0 && interval->high == 0 : numbers.are_all_equal;
  const bool has_width = interval && interval->low < interval->high;
  const double rare = plan.margin > 0 ? plan.margin : AnalysisPlan().margin;  // an absolute margin is none of shares
  const bool can_fail = (are_equal || (!has_width && trial.outcome.p >= alpha)) &&
                        1 - wilson(1, std::min(first.n, second.n), alpha).low > rare;
  // Ranks alone would not see that rare values are far apart, nor ratios in blocks that the medians shown are.
  trial.is_same = is_small && !can_fail && lies_within({.estimate = one - other}) &&
                  (pair.method->by != By::ranks || lies_within(by_means.test(numbers, alpha)));
  return trial;
}

std::optional<Dominance> effect_of(const MetricSamples& observed, const Pair& pair, const PairData& numbers) {
  const bool has_differences = pair.method->is_by_difference;
  const std::vector<double>& first = has_differences ? numbers.differences : numbers.first;
  std::vector<double> second = has_differences ? std::vector{0.0} : numbers.second;
  if (observed.is_log_scale || first.empty() || second.empty()) return {};
  if (!std::ranges::is_sorted(second)) std::ranges::sort(second);
  double larger = 0, smaller = 0;
  for (const double value : first) {
    const auto [first_equal, end] = std::equal_range(second.begin(), second.end(), value);
    larger += static_cast<double>(first_equal - second.begin());
    smaller += static_cast<double>(second.end() - end);
  }
  const double pairs = static_cast<double>(first.size()) * static_cast<double>(second.size());
  return observed.better == Better::larger ? Dominance{larger / pairs, smaller / pairs}
                                           : Dominance{smaller / pairs, larger / pairs};
}

DeterministicResult fact_of(const MetricSamples& observed, const AnalysisPlan& plan, const Pair& pair) {
  double one = values_of(*pair.a).front(), other = values_of(*pair.b).front();
  if (observed.is_log_scale) one = std::exp(one), other = std::exp(other);
  return {is_worse_beyond_margin(observed, plan, one, other)   ? Verdict::worse
          : is_worse_beyond_margin(observed, plan, other, one) ? Verdict::better
                                                               : Verdict::same};
}

// The verdict of p, with an amount that cannot refute it. The pair's groups have the same blocks.
Comparison judged_on_common(const MetricSamples& observed, const AnalysisPlan& plan, const Pair& pair, double tests) {
  Comparison finding{.first = pair.a->name, .second = pair.b->name, .scale = pair.scale};
  if (pair.open) {
    finding.what = *pair.open;
    return finding;
  }
  const bool is_ratio = pair.scale == EffectScale::ratio, takes_logs = is_ratio && !observed.is_log_scale;
  const bool are_means = pair.method->by == By::means && observed.scale != EffectScale::share;
  const double alpha = plan.significance / tests, none = null_value(pair.scale);
  const Trial trial = trial_of(observed, plan, pair, takes_logs, alpha);
  constexpr double enough_solved = 20;  // of fewer, an interval of costs with heavy tails misses too often
  const bool are_enough = trial.numbers.solved >= enough_solved;
  const bool is_same = are_enough && (trial.is_same || (takes_logs && observed.absolute_margin > 0 &&
                                                        trial_of(observed, plan, pair, false, alpha).is_same));
  const UnadjustedTest& outcome = trial.outcome;
  const auto shown = [&](double value) { return is_ratio ? std::exp(value) : value; };
  if (std::isfinite(outcome.estimate)) finding.amount = EffectEstimate{shown(outcome.estimate)};
  if (pair.is_fact()) {
    finding.what = fact_of(observed, plan, pair);
    return finding;
  }
  TestResult tested{.p = std::min(1.0, outcome.p * tests),
                    .effect = effect_of(observed, pair, trial.numbers),
                    .test = pair.method->name,
                    .n = pair.n};
  const bool is_decided = tested.p < plan.significance;
  if (are_means && !observed.is_log_scale) tested.g = hedges_g(trial.numbers.of_first, trial.numbers.of_second);
  // Of logarithms p itself would be that of few.
  if (are_means && (observed.is_log_scale || is_same || is_decided) &&
      (is_dominated(*pair.a) || is_dominated(*pair.b))) {
    finding.what = NotTested{.why = NotTested::NotTestedReason::few_decide, .n = pair.n};
    return finding;
  }
  std::optional<Interval> interval;
  if (outcome.interval && are_enough) interval = Interval{shown(outcome.interval->low), shown(outcome.interval->high)};
  if (is_decided) {
    const int direction = outcome.direction;
    tested.verdict = (direction > 0) == (observed.better == Better::larger) ? Verdict::better : Verdict::worse;
    tested.is_small = is_same;
    if (finding.amount && (finding.amount->value - none) * direction <= 0) finding.amount.reset();
    if (interval && direction > 0 && interval->low <= none) interval->low = none, interval->excludes_low = true;
    if (interval && direction < 0 && interval->high >= none) interval->high = none, interval->excludes_high = true;
  } else {
    tested.verdict = is_same ? Verdict::same : Verdict::undecided;
    if (interval) interval = Interval{std::min(none, interval->low), std::max(none, interval->high)};
    if (!is_same && interval && interval->low >= interval->high) interval.reset();  // most are equal, but not all
    // With a chance of 0.8, if the difference is as large as here, by the root law of every test here. A larger p says
    // nothing of how large it is.
    const double enough =
        std::ceil(pair.n * std::pow((critical_z(alpha) + critical_z(0.4)) / critical_z(outcome.p), 2));
    if (!is_same && tested.p < 0.5 && enough > pair.n && enough < 1e6) tested.enough = static_cast<int>(enough);
  }
  if (finding.amount) finding.amount->interval = interval;
  finding.what = tested;
  return finding;
}

// Copies the two groups only where their blocks differ, and only while they are judged.
Comparison judged(const MetricSamples& observed, const AnalysisPlan& plan, const Pair& pair, double tests) {
  if (!has_other_blocks(*pair.a, *pair.b)) return judged_on_common(observed, plan, pair, tests);
  Group a = *pair.a, b = *pair.b;
  keep_common_blocks({&a, &b});
  Pair common = pair;
  common.a = &a;
  common.b = &b;
  return judged_on_common(observed, plan, common, tests);
}

std::optional<NotTested::NotTestedReason> why_not(const Method& method, const Group& a, const Group& b,
                                                  bool may_hold_copies) {
  const auto is_none = [](double value) { return std::isinf(value); };
  const auto has_none = [&](const Group& group) {  // no answer at all
    return !values_of(group).empty() && std::ranges::all_of(values_of(group), is_none);
  };
  std::set<NotTested::NotTestedReason> all;
  if (has_none(a) && has_none(b)) all.insert(NotTested::NotTestedReason::no_answer);
  if (may_hold_copies && may_be_copies(a) && may_be_copies(b)) all.insert(NotTested::NotTestedReason::copies);
  for (const Group* const group : {&a, &b}) {
    if (method.by == By::means && std::ranges::any_of(values_of(*group), is_none))
      all.insert(NotTested::NotTestedReason::infinite);
    if (const ExcludedSample* const its = untold(*group)) all.insert(its->why);
  }
  return all.empty() ? std::nullopt : std::optional(*all.begin());
}

// Groups whose values rise, so that no pair sorts them again; none where values belong together by their places.
std::vector<Group> rising_groups(const MetricSamples& observed) {
  if (observed.is_paired) return {};
  std::vector<Group> groups = observed.groups;
  for (Group& group : groups)
    if (auto* const its = std::get_if<Measured>(&group.sample)) std::ranges::sort(its->values);
  return groups;
}

// The pairs that the plan asks for. Throws std::invalid_argument, which names all groups, if the control is none.
std::vector<Pair> pairs_of(const MetricSamples& observed, const std::vector<Group>& rising, const AnalysisPlan& plan) {
  if (!plan.control.empty() && place_of(observed, plan.control) == observed.groups.size()) {
    std::vector<std::string> names;
    for (const Group& group : observed.groups) names.push_back(group.name);
    const std::string unknown = base::unknown_name("label", plan.control, names);
    throw std::invalid_argument(fmt::format("--control: {}", base::front(unknown, 1000)));
  }
  std::vector<Pair> pairs;
  for (auto a = observed.groups.begin(); a != observed.groups.end(); ++a) {
    for (auto b = a + 1; b != observed.groups.end(); ++b) {
      if (!plan.control.empty() && a->name != plan.control && b->name != plan.control) continue;
      Pair& pair = pairs.emplace_back(Pair{.a = &*a, .b = &*b, .method = &method_of(observed, plan, *a, *b)});
      if (pair.method->by == By::ranks && !rising.empty()) {
        pair.a = &rising[static_cast<std::size_t>(a - observed.groups.begin())];
        pair.b = &rising[static_cast<std::size_t>(b - observed.groups.begin())];
      }
      const bool has_differences =
          observed.scale == EffectScale::ratio && pair.method->by != By::ranks && !observed.is_log_scale;
      pair.scale = has_differences ? EffectScale::difference : observed.scale;
      const auto [m, n] = common_sizes(*a, *b);
      const std::size_t few = std::min(m, n), many = std::max(m, n);
      pair.n = static_cast<int>(few > 0 && pair.has_one() ? many : few);
      if (const auto why = why_not(*pair.method, *a, *b, observed.may_hold_copies))
        pair.open = NotTested{.why = *why, .n = pair.n};
      else if (pair.n < observed.fewest)
        pair.open = NotTested{.why = NotTested::NotTestedReason::too_few, .n = pair.n, .needed = observed.fewest};
      const std::size_t differences = may_be_copies(*a) ? n : may_be_copies(*b) ? m : many;
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
      pair->open = NotTested{.why = NotTested::NotTestedReason::too_few, .n = pair->n, .needed = static_cast<int>(n)};
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

Verdict verdict_of(const Comparison& finding) {
  if (const auto* const tested = std::get_if<TestResult>(&finding.what)) return tested->verdict;
  if (const auto* const fact = std::get_if<DeterministicResult>(&finding.what)) return fact->verdict;
  return is_open(finding, NotTested::NotTestedReason::few_decide) ? Verdict::undecided : Verdict::not_tested;
}

bool is_open(const Comparison& finding, NotTested::NotTestedReason why) {
  const auto* const open = std::get_if<NotTested>(&finding.what);
  return open != nullptr && open->why == why;
}

bool are_equal(const Comparison& finding) {
  if (std::holds_alternative<DeterministicResult>(finding.what))
    return finding.amount->value == null_value(finding.scale);
  const auto* const tested = std::get_if<TestResult>(&finding.what);
  return tested != nullptr && tested->effect && tested->effect->ahead == 0 && tested->effect->behind == 0;
}

bool is_dominated(const Group& group) {
  if (const Measured* const its = measured(group); its && its->worth > 0)
    return its->solved < 4 || its->worth < std::min(4.0, static_cast<double>(its->values.size()) / 2);
  double largest = 0, sum = 0;
  for (const double value : values_of(group)) largest = std::max(largest, std::abs(value)), sum += std::abs(value);
  return largest > sum / 2;
}

bool is_difference(Verdict verdict) { return verdict == Verdict::better || verdict == Verdict::worse; }

Verdict turned(Verdict verdict) {
  return verdict == Verdict::better ? Verdict::worse : verdict == Verdict::worse ? Verdict::better : verdict;
}

std::set<std::string> beaten_solvers(const std::vector<Comparison>& findings) {
  std::set<std::string> losers;
  for (const Comparison& finding : findings) {
    const Verdict verdict = verdict_of(finding);
    if (is_difference(verdict)) losers.insert(verdict == Verdict::better ? finding.second : finding.first);
  }
  return losers;
}

std::vector<Comparison> compare(const MetricSamples& observed, const AnalysisPlan& plan, std::size_t metrics) {
  return std::move(compare({{&observed, &plan}}, metrics).front());
}

std::vector<std::vector<Comparison>> compare(const std::vector<Member>& family, std::size_t metrics) {
  std::vector<std::vector<Pair>> members;
  std::vector<std::vector<Group>> rising;
  for (const Member& member : family) rising.push_back(rising_groups(*member.observed));
  for (std::size_t i = 0; i < family.size(); ++i)
    members.push_back(pairs_of(*family[i].observed, rising[i], *family[i].plan));
  const auto shares = static_cast<double>(metrics);
  const double significance = family.front().plan->significance / shares;
  const double tests = shares * static_cast<double>(std::max<std::size_t>(1, testable(members, significance)));
  std::vector<std::vector<Comparison>> findings(family.size());
  for (std::size_t i = 0; i < family.size(); ++i)
    for (const Pair& pair : members[i])
      findings[i].push_back(judged(*family[i].observed, *family[i].plan, pair, tests));
  return findings;
}

Comparison better_first(Comparison finding, std::string_view control, bool is_second_ahead) {
  const Verdict verdict = verdict_of(finding);
  const bool is_behind = is_difference(verdict) ? verdict == Verdict::worse : is_second_ahead;
  if (control.empty() ? !is_behind : finding.first != control) return finding;
  std::swap(finding.first, finding.second);
  if (auto& amount = finding.amount) {
    const auto end = [&](double value) { return finding.scale == EffectScale::ratio ? 1 / value : 0 - value; };
    amount->value = end(amount->value);
    if (const auto ends = amount->interval)
      amount->interval = Interval{end(ends->high), end(ends->low), ends->excludes_high, ends->excludes_low};
  }
  if (auto* const fact = std::get_if<DeterministicResult>(&finding.what)) fact->verdict = turned(fact->verdict);
  if (auto* const tested = std::get_if<TestResult>(&finding.what)) {
    tested->verdict = turned(tested->verdict);
    if (tested->effect) std::swap(tested->effect->ahead, tested->effect->behind);
    if (tested->g) tested->g = -*tested->g;
  }
  return finding;
}

bool is_worse_beyond_margin(const MetricSamples& observed, const AnalysisPlan& plan, double one, double other) {
  if (observed.scale == EffectScale::ratio)
    one = std::max(one, observed.floor), other = std::max(other, observed.floor);
  const double relative =
      plan.margin * (observed.scale == EffectScale::share ? 1 : std::min(std::abs(one), std::abs(other)));
  const double loss = observed.better == Better::smaller ? one - other : other - one;
  return loss > std::max(observed.absolute_margin, relative) + observed.rounding;
}

}  // namespace ikbench::judge
