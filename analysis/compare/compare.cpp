#include "analysis/compare/compare.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "analysis/compare/describe.hpp"

namespace ikbench::compare {
namespace {

// What design and plan choose, never the values.
enum class Method { ranks, signed_ranks, sign, sign_and_ranks, paired_t, mcnemar, welch, fisher };
enum Trait : unsigned { by_ranks = 1, by_t = 2, by_difference = 4, by_sign = 8 };
constexpr std::array<std::pair<std::string_view, unsigned>, 8> methods{
    {{"Brunner-Munzel and Mann-Whitney", by_ranks},
     {"Wilcoxon's signed ranks", by_ranks | by_difference},
     {"sign test", by_ranks | by_difference | by_sign},
     {"sign test and Mann-Whitney", by_ranks | by_difference | by_sign},
     {"paired t", by_t | by_difference},
     {"McNemar's exact", by_difference},
     {"Welch's t", by_t},
     {"Fisher's exact", 0}}};
bool is(Method method, Trait trait) { return (methods[static_cast<std::size_t>(method)].second & trait) != 0; }

Method method_of(const Observations& observed, const Plan& plan, const Group& a, const Group& b) {
  if (a.summary || b.summary) return Method::welch;
  if (a.copies > 0 || b.copies > 0) return Method::sign;
  if (observed.scale == Scale::share && observed.trials == 1)
    return observed.is_paired ? Method::mcnemar : Method::fisher;
  const bool by_means = observed.scale == Scale::share || plan.test == Plan::Test::means;
  if (observed.is_paired) return by_means ? Method::paired_t : Method::signed_ranks;
  if (by_means) return Method::welch;
  return a.may_repeat != b.may_repeat ? Method::sign_and_ranks : Method::ranks;
}

std::size_t size_of(const Group& group) {
  return group.summary ? static_cast<std::size_t>(group.summary->n) : group.values.size();
}

bool has_no_answer(const Group& group) {
  return std::ranges::any_of(group.values, [](double value) { return std::isinf(value); });
}

struct Pair {
  Group a, b;  // of the blocks that both have
  Method method;
  double smallest_p = 1;
  Finding finding = {};
};

bool are_on_logs(const Observations& observed, const Pair& pair) {
  return observed.scale == Scale::ratio && is(pair.method, by_ranks);
}

// Relative: smaller than a difference in the fifteenth digit, the last that every double can tell.
constexpr double rounding_of_doubles = 4 * std::numeric_limits<double>::epsilon();

// Makes values equal that lie within the rounding above the smallest of them: the metric's, or that of doubles.
void remove_rounding(std::vector<double>& values, double rounding) {
  std::vector<std::pair<double, double*>> order;  // pairs stay in the cache, which places alone would not
  order.reserve(values.size());
  for (double& value : values) order.emplace_back(value, &value);
  std::ranges::sort(order, {}, &std::pair<double, double*>::first);
  for (std::size_t first = 0, next = 0; first < order.size(); first = next) {
    const double least = order[first].first, most = least + std::max(rounding, rounding_of_doubles * std::abs(least));
    for (; next < order.size() && order[next].first <= most; ++next) *order[next].second = least;
  }
}

// The values of a pair as its test takes them. A group with a summary has none.
struct Two {
  std::vector<double> a, b, differences;
  double no_answer = 0;  // stands for infinite values, and is larger than all that comes of others; 0: there are none
  bool are_all_equal = false;

  Two(const Observations& observed, const Pair& pair, bool are_logs) {
    std::vector<double> all = pair.a.values;
    all.insert(all.end(), pair.b.values.begin(), pair.b.values.end());
    if (are_logs) {
      for (double& value : all) value = std::max(value, observed.floor);
    }
    remove_rounding(all, observed.rounding);
    if (are_logs) std::ranges::transform(all, all.begin(), [](double value) { return std::log(value); });
    double most = std::max(observed.absolute_margin, are_logs ? 100.0 : 0.0);
    for (const double value : all) most = std::isinf(value) ? most : std::max(most, std::abs(value));
    for (double& value : all) {
      if (std::isinf(value)) value = no_answer = most > 0 ? 1e4 * most : 1;
    }
    a.assign(all.begin(), all.begin() + std::ssize(pair.a.values));
    b.assign(all.begin() + std::ssize(pair.a.values), all.end());
    are_all_equal = !all.empty() && std::ranges::count(all, all.front()) == std::ssize(all);
    if (!is(pair.method, by_difference)) return;
    std::vector<double> sizes{0};
    double largest = are_logs ? 1 : 0;
    const bool is_one_value_of_a = a.size() == 1 || pair.a.may_repeat,
               is_one_value_of_b = b.size() == 1 || pair.b.may_repeat;
    const std::size_t runs = is_one_value_of_a ? b.size() : a.size();
    for (std::size_t i = 0; i < runs; ++i) {  // by block; or from the one value of a group
      const double x = a[is_one_value_of_a ? 0 : i], y = b[is_one_value_of_b ? 0 : i];
      differences.push_back(x - y);
      sizes.push_back(std::abs(x - y));
      largest = std::max({largest, std::abs(x), std::abs(y)});
    }
    remove_rounding(sizes, rounding_of_doubles * largest);
    for (std::size_t i = 0; i < differences.size(); ++i) differences[i] = std::copysign(sizes[i + 1], differences[i]);
    are_all_equal = std::ranges::count(differences, 0.0) == std::ssize(differences);
  }
};

// The smallest that data of these sizes can give.
double smallest_p(Method method, std::size_t m, std::size_t n) {
  if (is(method, by_t)) return std::min(m, n) < 3 ? 1 : 0;  // of two values the larger is more than half of their sum
  if (is(method, by_difference) && method != Method::sign_and_ranks) return smallest_p_paired(n);
  if (std::min(m, n) < 2) return 1;
  if (method == Method::sign_and_ranks) return std::max(smallest_p_paired(std::max(m, n)), smallest_p_unpaired(m, n));
  // The rarest table of Fisher's test is one, or of groups of one size two.
  return smallest_p_unpaired(m, n) / (method == Method::fisher && m != n ? 2 : 1);
}

Tested tested_by(Method method, const Two& two, const Summary& first, const Summary& second, double alpha) {
  if (method == Method::ranks) return rank_test(two.a, two.b, alpha);
  if (method == Method::signed_ranks) return signed_rank_test(two.differences, alpha);
  if (is(method, by_sign)) {
    Tested tested = sign_test(two.differences, alpha);
    if (method == Method::sign_and_ranks) tested.p = std::max(tested.p, mann_whitney(two.a, two.b));
    return tested;
  }
  if (method == Method::paired_t) return t_test(two.differences, alpha);
  if (method == Method::mcnemar) return mcnemar(two.a, two.b, alpha);
  return method == Method::fisher ? fisher(two.a, two.b, alpha) : welch(first, second, alpha);
}

// Tests a pair on one scale, whose numbers it returns, and says in the finding what does not depend on their unit.
Tested examined(const Observations& observed, const Plan& plan, const Pair& pair, bool are_logs, double alpha,
                Finding& finding) {
  const Two two(observed, pair, are_logs);
  const Summary first = pair.a.summary ? *pair.a.summary : summarise(two.a);
  const Summary second = pair.b.summary ? *pair.b.summary : summarise(two.b);
  const bool is_share = observed.scale == Scale::share, are_constant = first.sd == 0 && second.sd == 0;
  finding.are_all_equal = two.are_all_equal;
  Tested tested = tested_by(pair.method, two, first, second, alpha);
  std::optional<Interval>& interval = tested.interval;
  std::optional<double> share_larger;
  if (is(pair.method, by_difference)) {
    double twice = 0;
    for (const double each : two.differences) twice += (each > 0) + (each >= 0);
    share_larger = twice / 2 / static_cast<double>(two.differences.size());
  } else if (!two.a.empty() && !two.b.empty()) {
    share_larger = a12(two.a, two.b);
  }
  if (share_larger) finding.effect = observed.better == Better::larger ? *share_larger : 1 - *share_larger;
  if (is_share && interval) interval = Interval{std::max(-1.0, interval->low), std::min(1.0, interval->high)};
  if (is_share && are_constant && finding.are_all_equal && !interval)
    interval = newcombe(first.mean, first.n, second.mean, second.n, alpha);
  if (!is_share && finding.are_all_equal) interval.reset();

  const double relative = two.no_answer > 0 ? 0 : plan.margin * std::min(std::abs(first.mean), std::abs(second.mean));
  const double margin = is_share                      ? plan.margin
                        : are_logs                    ? std::log1p(plan.margin)
                        : are_on_logs(observed, pair) ? observed.absolute_margin
                                                      : std::max(observed.absolute_margin, relative);
  const auto lies_within = [margin](const Tested& each) {  // values without spread have their difference alone
    const Interval held = each.interval.value_or(Interval{each.estimate, each.estimate});
    return held.low >= -margin && held.high <= margin;
  };
  // Equal values say nothing of failures that are rarer than so many can show.
  const bool are_equal = interval ? interval->low == 0 && interval->high == 0 : finding.are_all_equal;
  const bool can_fail = are_equal && 1 - wilson(1, std::min(first.n, second.n), alpha).low > plan.margin;
  const Method by_means = is(pair.method, by_difference) ? Method::paired_t : Method::welch;
  finding.is_within_margin =
      !can_fail && lies_within(tested) &&
      (!is(pair.method, by_ranks) || lies_within(tested_by(by_means, two, first, second, alpha)));
  const auto unbound = [&](double& value) {
    if (two.no_answer > 0 && std::abs(value) > two.no_answer / 8)
      value = std::copysign(std::numeric_limits<double>::infinity(), value);
  };
  unbound(tested.estimate);
  if (interval) unbound(interval->low), unbound(interval->high);
  return tested;
}

// The verdict of p, with an estimate and an interval that cannot refute it.
void set_verdict(const Observations& observed, const Plan& plan, const Pair& pair, int direction, Finding& finding) {
  const double none = finding.scale == Scale::ratio ? 1 : 0;
  std::optional<Interval>& interval = finding.interval;
  if (*finding.p >= plan.significance) {
    finding.verdict = finding.is_within_margin ? Verdict::same : Verdict::undecided;
    if (interval) interval = Interval{std::min(none, interval->low), std::max(none, interval->high)};
    const bool has_width = interval && interval->low < interval->high;
    if (finding.verdict == Verdict::undecided && !has_width) interval.reset();  // most values are equal, but not all
    return;
  }
  if (is(pair.method, by_t) && observed.scale != Scale::share &&
      (does_one_value_decide(pair.a) || does_one_value_decide(pair.b))) {
    finding.verdict = Verdict::undecided;
    finding.why = Why::few_decide;
    finding.is_within_margin = false;
    finding.p.reset();
    interval.reset();
    return;
  }
  finding.verdict = (direction > 0) == (observed.better == Better::larger) ? Verdict::better : Verdict::worse;
  if (finding.estimate && (*finding.estimate - none) * direction <= 0) {
    finding.estimate.reset();
    interval.reset();
  }
  if (!interval) return;
  const double width = interval->high - interval->low, rounding = std::isinf(width) ? 0 : 1e-9 * width;  // of bisection
  if (direction > 0 && interval->low <= none + rounding) interval->low = none, interval->excludes_low = true;
  if (direction < 0 && interval->high >= none - rounding) interval->high = none, interval->excludes_high = true;
}

// Keeps the values of blocks that both have.
void keep_common_blocks(Group& one, Group& other) {
  const auto keep = [](Group& group, const std::vector<int>& blocks) {
    std::vector<double> values;
    for (std::size_t i = 0; i < group.blocks.size(); ++i) {
      if (std::ranges::binary_search(blocks, group.blocks[i])) values.push_back(group.values[i]);
    }
    group.values = std::move(values);
  };
  if (one.blocks == other.blocks) return;
  keep(one, other.blocks);
  keep(other, one.blocks);
}

// The pairs that the plan asks for.
std::vector<Pair> pairs_of(const Observations& observed, const Plan& plan) {
  std::vector<Pair> pairs;
  for (auto a = observed.groups.begin(); a != observed.groups.end(); ++a) {
    for (auto b = a + 1; b != observed.groups.end(); ++b) {
      if (!plan.control.empty() && a->name != plan.control && b->name != plan.control) continue;
      Pair& pair = pairs.emplace_back(Pair{.a = *a, .b = *b, .method = method_of(observed, plan, *a, *b)});
      keep_common_blocks(pair.a, pair.b);
      Finding& finding = pair.finding = {.first = a->name, .second = b->name};
      finding.n = static_cast<int>(std::min(size_of(pair.a), size_of(pair.b)));
      if (a->copies > 0 && b->copies > 0) finding.why = Why::fact;
      if (a->is_apart || b->is_apart) finding.why = Why::apart;
      const bool has_infinite = has_no_answer(*a) || has_no_answer(*b);
      if (a->lost > 0 || b->lost > 0 || (has_infinite && is(pair.method, by_t))) finding.why = Why::lost;
      if (finding.why != Why::tested || finding.n == 0) continue;
      pair.smallest_p = smallest_p(pair.method, size_of(pair.a), size_of(pair.b));
      if (!is(pair.method, by_sign)) continue;
      // Runs that differ from the value of the solver that repeats itself.
      const std::vector<double> differences = Two(observed, pair, false).differences;
      finding.n = static_cast<int>(std::ranges::count_if(differences, [](double each) { return each != 0; }));
      const double least = smallest_p_paired(static_cast<std::size_t>(finding.n));
      pair.smallest_p = pair.method == Method::sign ? least : std::max(least, pair.smallest_p);
    }
  }
  return pairs;
}

// Empty unless the mean or the median of the better one lies the other way.
Headline usually_better(const Observations& observed, const Plan& plan, const std::string& winner,
                        const std::string& loser) {
  Group better = observed.groups[place_of(observed, winner)], other = observed.groups[place_of(observed, loser)];
  keep_common_blocks(better, other);
  const auto is_worse = [&](double one, double two) { return is_worse_than_margin(observed, plan, one, two); };
  const Description its = describe(better), theirs = describe(other);
  const bool is_median_worse =
      is(method_of(observed, plan, better, other), by_ranks) && is_worse(its.median, theirs.median);
  if (!is_median_worse && !is_worse(its.mean, theirs.mean)) return {};
  return {.usual = winner, .other = loser, .is_median_worse = is_median_worse};
}

// How many pairs data of this size can decide, before any p is known: those that cannot leave, the least able first.
std::size_t testable(std::vector<Pair>& pairs, double significance) {
  std::vector<Pair*> family;
  for (Pair& pair : pairs) {
    if (pair.finding.why == Why::tested) family.push_back(&pair);
  }
  while (!family.empty()) {
    const double level = significance / static_cast<double>(family.size());
    const double worst = (*std::ranges::max_element(family, {}, &Pair::smallest_p))->smallest_p;
    if (worst < level) break;
    std::erase_if(family, [&](Pair* pair) {
      if (pair->smallest_p < worst) return false;
      pair->finding.why = Why::too_few;
      std::size_t n = 2;
      while (smallest_p(pair->method, n, n) >= level) ++n;
      pair->finding.needed = static_cast<int>(n);
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

bool does_one_value_decide(const Group& group) {
  std::vector<double> sizes = group.values;
  for (double& size : sizes) size = std::abs(size);
  return !sizes.empty() && std::ranges::max(sizes) > std::accumulate(sizes.begin(), sizes.end(), 0.0) / 2;
}

bool is_difference(Verdict verdict) { return verdict == Verdict::better || verdict == Verdict::worse; }

Verdict turned(Verdict verdict) {
  if (!is_difference(verdict)) return verdict;
  return verdict == Verdict::better ? Verdict::worse : Verdict::better;
}

std::set<std::string> losers_of(const std::vector<Finding>& findings) {
  std::set<std::string> losers;
  for (const Finding& finding : findings) {
    if (is_difference(finding.verdict))
      losers.insert(finding.verdict == Verdict::better ? finding.second : finding.first);
  }
  return losers;
}

bool can_decide(const Observations& observed, const Plan& plan) {
  std::vector<Pair> pairs = pairs_of(observed, plan);
  testable(pairs, plan.significance);
  return std::ranges::any_of(pairs, [&](const Pair& pair) {
    return pair.finding.why == Why::tested && !Two(observed, pair, are_on_logs(observed, pair)).are_all_equal;
  });
}

std::vector<Finding> compare(const Observations& observed, const Plan& plan, std::size_t metrics) {
  if (!plan.control.empty() && place_of(observed, plan.control) == observed.groups.size())
    throw std::invalid_argument("the control '" + plan.control + "' is no group");
  std::vector<Pair> pairs = pairs_of(observed, plan);
  const auto shares = static_cast<double>(metrics);
  const double tests =
      shares * static_cast<double>(std::max<std::size_t>(1, testable(pairs, plan.significance / shares)));
  const double alpha = plan.significance / tests;
  for (Pair& pair : pairs) {
    Finding& finding = pair.finding;
    const bool are_logs = are_on_logs(observed, pair), is_tested = finding.why == Why::tested;
    finding.scale = observed.scale == Scale::ratio && !are_logs ? Scale::difference : observed.scale;
    if (!is_tested && finding.why != Why::fact) continue;
    const Tested tested = examined(observed, plan, pair, are_logs, alpha, finding);
    if (are_logs && observed.absolute_margin > 0) {
      Finding plain = finding;
      examined(observed, plan, pair, false, alpha, plain);
      finding.is_within_margin |= plain.is_within_margin;
    }
    const auto shown = [&](double value) { return are_logs ? std::exp(value) : value; };
    if (std::isfinite(tested.estimate)) finding.estimate = shown(tested.estimate);
    finding.is_within_margin &= is_tested;
    if (!is_tested) continue;
    finding.test = methods[static_cast<std::size_t>(pair.method)].first;
    if (tested.interval && finding.estimate)
      finding.interval = Interval{shown(tested.interval->low), shown(tested.interval->high)};
    finding.p = std::min(1.0, tested.p * tests);
    set_verdict(observed, plan, pair, tested.direction, finding);
  }
  std::vector<Finding> findings;
  for (Pair& pair : pairs) findings.push_back(std::move(pair.finding));
  return findings;
}

Finding better_first(Finding finding, std::string_view control, bool is_second_ahead) {
  const bool is_behind = is_difference(finding.verdict) ? finding.verdict == Verdict::worse : is_second_ahead;
  if (control.empty() ? !is_behind : finding.first != control) return finding;
  std::swap(finding.first, finding.second);
  const auto turn = [&](double value) { return finding.scale == Scale::ratio ? 1 / value : 0 - value; };
  if (finding.estimate) finding.estimate = turn(*finding.estimate);
  if (const auto ends = finding.interval)
    finding.interval = Interval{turn(ends->high), turn(ends->low), ends->excludes_high, ends->excludes_low};
  if (finding.effect) finding.effect = 1 - *finding.effect;
  finding.verdict = turned(finding.verdict);
  return finding;
}

bool is_worse_than_margin(const Observations& observed, const Plan& plan, double one, double other) {
  if (observed.scale == Scale::ratio) one = std::max(one, observed.floor), other = std::max(other, observed.floor);
  const double relative = plan.margin * (observed.scale == Scale::share ? 1 : std::min(std::abs(one), std::abs(other)));
  const double loss = observed.better == Better::smaller ? one - other : other - one;
  return loss > std::max(observed.absolute_margin, relative) + observed.rounding;
}

Headline headline(const Observations& observed, const Plan& plan, const std::vector<Finding>& findings) {
  const std::set<std::string> losers = losers_of(findings);
  const std::size_t best = observed.groups.size() - losers.size();
  if (losers.empty() || best == 0) return {.is_circle = !losers.empty()};
  Headline said;
  std::size_t known = 0;  // pairs of two unbeaten ones that were tested, and of one that beats a loser
  for (const Finding& finding : findings) {
    const bool is_first_best = !losers.contains(finding.first), is_second_best = !losers.contains(finding.second);
    if (is_first_best && is_second_best) known += finding.verdict != Verdict::not_tested;
    if (is_first_best == is_second_best || !is_difference(finding.verdict)) continue;
    ++known;
    if (said.usual.empty())
      said = usually_better(observed, plan, is_first_best ? finding.first : finding.second,
                            is_first_best ? finding.second : finding.first);
  }
  if (known < best * losers.size() + best * (best - 1) / 2) return {};
  for (const Group& group : observed.groups) {
    if (said.usual.empty() && !losers.contains(group.name)) said.best.push_back(group.name);
  }
  return said;
}

}  // namespace ikbench::compare
