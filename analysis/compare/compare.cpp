#include "analysis/compare/compare.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <stdexcept>

namespace ikbench::compare {
namespace {

// What design and plan choose, never the values.
enum class Method { ranks, signed_ranks, sign, welch, paired_t, fisher, mcnemar };
constexpr std::array<std::string_view, 7> method_names{"Brunner-Munzel and Mann-Whitney",
                                                       "Wilcoxon's signed ranks",
                                                       "sign test",
                                                       "Welch's t",
                                                       "paired t",
                                                       "Fisher's exact",
                                                       "McNemar's exact"};

bool is_by_ranks(Method method) { return method <= Method::sign; }
bool is_by_difference(Method method) {
  return method == Method::signed_ranks || method == Method::sign || method == Method::paired_t ||
         method == Method::mcnemar;
}

Method method_of(const Observations& of, const Plan& plan, const Group& a, const Group& b) {
  if (a.summary || b.summary) return Method::welch;
  if (a.copies > 0 || b.copies > 0) return Method::sign;
  if (of.scale == Scale::share && of.trials == 1) return of.is_paired ? Method::mcnemar : Method::fisher;
  const bool by_means = of.scale == Scale::share || plan.test == Plan::Test::means;
  if (of.is_paired) return by_means ? Method::paired_t : Method::signed_ranks;
  return by_means ? Method::welch : Method::ranks;
}

bool is_by_t(Method method) { return method == Method::welch || method == Method::paired_t; }
std::size_t size_of(const Group& group) {
  return group.summary ? static_cast<std::size_t>(group.summary->n) : group.values.size();
}

struct Pair {
  Group a, b;
  Method method;
  double smallest_p = 1;
  Finding finding = {};
};

bool are_on_logs(const Observations& of, const Pair& pair) {
  return of.scale == Scale::ratio && is_by_ranks(pair.method);
}

// Makes values equal that lie within the rounding above the smallest of them: the metric's, or the twelfth digit.
void remove_rounding(std::vector<double>& values, double rounding) {
  std::vector<double*> order;
  for (double& value : values) order.push_back(&value);
  std::ranges::sort(order, {}, [](const double* value) { return *value; });
  for (std::size_t first = 0, next = 0; first < order.size(); first = next) {
    const double least = *order[first], most = least + std::max(rounding, 1e-12 * std::abs(least));
    for (; next < order.size() && *order[next] <= most; ++next) *order[next] = least;
  }
}

// The values of a pair as its test takes them. A group with a summary has none.
struct Two {
  std::vector<double> a, b, differences;

  Two(const Observations& of, const Pair& pair, bool are_logs) {
    std::vector<double> all = pair.a.values;
    all.insert(all.end(), pair.b.values.begin(), pair.b.values.end());
    if (of.scale == Scale::ratio) {
      for (double& value : all) value = std::max(value, of.floor);
    }
    remove_rounding(all, of.rounding);
    if (are_logs) {
      for (double& value : all) value = std::log(value);
    }
    a.assign(all.begin(), all.begin() + std::ssize(pair.a.values));
    b.assign(all.begin() + std::ssize(pair.a.values), all.end());
    if (is_by_difference(pair.method)) subtract(are_logs ? 1 : 0);
  }

 private:
  // By block; where a group has one value, from that.
  void subtract(double largest) {
    std::vector<double> sizes{0};
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
      const double one = a[a.size() == 1 ? 0 : i], other = b[b.size() == 1 ? 0 : i];
      differences.push_back(one - other);
      sizes.push_back(std::abs(one - other));
      largest = std::max({largest, std::abs(one), std::abs(other)});
    }
    remove_rounding(sizes, 1e-12 * largest);
    for (std::size_t i = 0; i < differences.size(); ++i) differences[i] = std::copysign(sizes[i + 1], differences[i]);
  }
};

double smallest_p(const Pair& pair, const Two& two) {
  const std::size_t few = std::min(size_of(pair.a), size_of(pair.b)), many = std::max(size_of(pair.a), size_of(pair.b));
  const auto equal = static_cast<std::size_t>(std::ranges::count(two.differences, 0.0));
  if (pair.method == Method::sign) return smallest_p_paired(many - equal);
  if (few < 2) return 1;
  if (is_by_t(pair.method)) return 0;
  return is_by_difference(pair.method) ? smallest_p_paired(few) : smallest_p_unpaired(few, many);
}

// What a pair's tests say on one scale.
struct Outcome {
  Tested tested;
  std::optional<double> effect = {};  // of the larger
  bool is_within = false, is_beyond = false, are_all_equal = false;
};

Tested tested_by(Method method, const Two& two, const Summary& one, const Summary& other, double alpha) {
  switch (method) {
    case Method::ranks:
      return rank_test(two.a, two.b, alpha);
    case Method::signed_ranks:
      return signed_rank_test(two.differences, alpha);
    case Method::sign:
      return sign_test(two.differences, alpha);
    case Method::paired_t:
      return t_test(two.differences, alpha);
    case Method::fisher:
      return fisher(two.a, two.b, alpha);
    case Method::mcnemar:
      return mcnemar(two.a, two.b, alpha);
    case Method::welch:
      break;
  }
  return welch(one, other, alpha);
}

Outcome outcome(const Observations& of, const Plan& plan, const Pair& pair, bool are_logs, double alpha) {
  const Two two(of, pair, are_logs);
  const Summary one = pair.a.summary ? *pair.a.summary : summarise(two.a);
  const Summary other = pair.b.summary ? *pair.b.summary : summarise(two.b);
  const bool is_share = of.scale == Scale::share, by_difference = is_by_difference(pair.method);
  const bool are_constant = one.sd == 0 && other.sd == 0;
  Outcome result{.tested = tested_by(pair.method, two, one, other, alpha)};
  std::optional<Interval>& interval = result.tested.interval;
  if (by_difference) {
    result.are_all_equal = std::ranges::count(two.differences, 0.0) == std::ssize(two.differences);
    result.effect = a12(two.differences, std::array{0.0});
  } else {
    result.are_all_equal = are_constant && one.mean == other.mean;
    if (!two.a.empty() && !two.b.empty()) result.effect = a12(two.a, two.b);
  }
  if (is_share && are_constant && !interval) interval = newcombe(one.mean, one.n, other.mean, other.n, alpha);
  if (!is_share && result.are_all_equal) interval.reset();

  const double relative = plan.margin * std::min(std::abs(one.mean), std::abs(other.mean));
  const double margin = is_share                ? plan.margin
                        : are_logs              ? std::log1p(plan.margin)
                        : are_on_logs(of, pair) ? plan.absolute_margin
                                                : std::max(plan.absolute_margin, relative);
  const auto lies_within = [margin](const std::optional<Interval>& each) {
    return each && each->low < each->high && each->low >= -margin && each->high <= margin;
  };
  result.is_within = lies_within(interval);
  if (result.is_within && is_by_ranks(pair.method))
    result.is_within =
        lies_within((by_difference ? t_test(two.differences, alpha) : welch(one, other, alpha)).interval);
  if (!interval && result.are_all_equal)
    result.is_within = 1 - wilson(1, std::min(one.n, other.n), alpha).low <= plan.margin;
  result.is_beyond = interval && (interval->low > margin || interval->high < -margin);
  return result;
}

bool does_one_value_decide(const Group& group) {
  double sum = 0, largest = 0;
  for (const double value : group.values) {
    sum += std::abs(value);
    largest = std::max(largest, std::abs(value));
  }
  return largest > sum / 2;
}

void judge(const Observations& of, const Plan& plan, Pair& pair, bool is_first_larger) {
  Finding& finding = pair.finding;
  finding.verdict = finding.is_within_margin ? Verdict::same : Verdict::undecided;
  if (*finding.p >= plan.significance) return;
  finding.verdict = is_first_larger == (of.better == Better::larger) ? Verdict::better : Verdict::worse;
  if (of.scale == Scale::share || is_by_ranks(pair.method)) return;
  if (!does_one_value_decide(pair.a) && !does_one_value_decide(pair.b)) return;
  finding.verdict = Verdict::undecided;
  finding.why = Why::few_decide;
}

// Keeps the values of blocks that both have.
void keep_common_blocks(Group& one, Group& other) {
  const auto keep = [](Group& of, const std::vector<int>& blocks) {
    std::vector<double> values;
    for (std::size_t i = 0; i < of.blocks.size(); ++i) {
      if (std::ranges::binary_search(blocks, of.blocks[i])) values.push_back(of.values[i]);
    }
    of.values = std::move(values);
  };
  if (one.blocks == other.blocks) return;
  keep(one, other.blocks);
  keep(other, one.blocks);
}

// The pairs that the plan asks for.
std::vector<Pair> pairs_of(const Observations& of, const Plan& plan) {
  std::vector<Pair> pairs;
  for (auto a = of.groups.begin(); a != of.groups.end(); ++a) {
    for (auto b = a + 1; b != of.groups.end(); ++b) {
      if (!plan.control.empty() && a->name != plan.control && b->name != plan.control) continue;
      Pair& pair = pairs.emplace_back(Pair{.a = *a, .b = *b, .method = method_of(of, plan, *a, *b)});
      keep_common_blocks(pair.a, pair.b);
      pair.finding = {.metric = of.metric, .first = a->name, .second = b->name};
      pair.finding.n = static_cast<int>(std::min(size_of(pair.a), size_of(pair.b)));
      pair.finding.why = a->lost > 0 || b->lost > 0       ? Why::lost
                         : a->is_apart || b->is_apart     ? Why::apart
                         : a->copies > 0 && b->copies > 0 ? Why::fact
                                                          : Why::tested;
      if (pair.finding.why == Why::tested && pair.finding.n > 0)
        pair.smallest_p = smallest_p(pair, Two(of, pair, false));
    }
  }
  return pairs;
}

// The pairs that data of this size can decide, before any p is known: those that cannot leave, the least able first.
std::vector<Pair*> testable(std::vector<Pair>& pairs, double significance) {
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
      std::size_t n = 2;
      while (!is_by_t(pair->method) &&
             (is_by_difference(pair->method) ? smallest_p_paired(n) : smallest_p_unpaired(n, n)) >= level)
        ++n;
      pair->finding.why = Why::too_few;
      pair->finding.needed = static_cast<int>(n);
      return true;
    });
  }
  return family;
}

void check(const Observations& of, const Plan& plan) {
  if (!plan.control.empty() && std::ranges::find(of.groups, plan.control, &Group::name) == of.groups.end())
    throw std::invalid_argument("the control '" + plan.control + "' is no group");
  const Group* before = nullptr;
  for (const Group& group : of.groups) {
    if (group.lost > 0 || size_of(group) == 0) continue;
    if (of.is_paired && before && before->blocks.empty() && before->values.size() != group.values.size())
      throw std::invalid_argument("paired groups differ in size");
    if (of.scale == Scale::ratio && !group.summary && std::max(std::ranges::min(group.values), of.floor) <= 0)
      throw std::invalid_argument("ratios of '" + group.name + "' need values above 0");
    before = &group;
  }
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  constexpr std::array<std::string_view, 5> names{"better", "worse", "same", "not decided", "not tested"};
  return names[static_cast<std::size_t>(verdict)];
}

std::vector<Finding> compare(const Observations& of, const Plan& plan) {
  check(of, plan);
  std::vector<Pair> pairs = pairs_of(of, plan);
  const std::vector<Pair*> family = testable(pairs, plan.significance);
  const double alpha = plan.significance / static_cast<double>(std::max<std::size_t>(1, family.size()));
  std::vector<double> p;
  std::vector<int> directions;
  for (Pair& pair : pairs) {
    Finding& finding = pair.finding;
    if (finding.why == Why::lost || finding.why == Why::apart || finding.n == 0) continue;
    const bool are_logs = are_on_logs(of, pair);
    Outcome found = outcome(of, plan, pair, are_logs, alpha);
    if (are_logs && plan.absolute_margin > 0) {
      const Outcome plain = outcome(of, plan, pair, false, alpha);
      found.is_within = found.is_within || plain.is_within;
      found.is_beyond = found.is_beyond && plain.is_beyond;
    }
    const auto shown = [&](double value) { return are_logs ? std::exp(value) : value; };
    finding.scale = of.scale == Scale::ratio && !are_logs ? Scale::difference : of.scale;
    finding.estimate = shown(found.tested.estimate);
    if (found.effect) finding.effect = of.better == Better::larger ? *found.effect : 1 - *found.effect;
    finding.are_all_equal = found.are_all_equal;
    if (finding.why != Why::tested) continue;
    finding.test = method_names[static_cast<std::size_t>(pair.method)];
    if (const auto& found_interval = found.tested.interval)
      finding.interval = Interval{shown(found_interval->low), shown(found_interval->high)};
    finding.is_within_margin = found.is_within;
    finding.is_beyond_margin = found.is_beyond;
    p.push_back(found.tested.p);
    directions.push_back(found.tested.direction);
  }
  holm(p);
  for (std::size_t i = 0; i < family.size(); ++i) {
    family[i]->finding.p = p[i];
    judge(of, plan, *family[i], directions[i] > 0);
  }
  std::vector<Finding> findings;
  for (Pair& pair : pairs) findings.push_back(std::move(pair.finding));
  return findings;
}

Headline headline(const Observations& of, const Plan& plan, const std::vector<Finding>& findings) {
  const auto mean_of = [](const Group& group) {
    return group.summary ? group.summary->mean : summarise(group.values).mean;
  };
  std::set<std::string> losers;
  for (const Group& group : of.groups) {
    std::set<std::string> beaten;
    for (const Finding& each : findings) {
      if (each.verdict == Verdict::better && each.first == group.name) beaten.insert(each.second);
      if (each.verdict == Verdict::worse && each.second == group.name) beaten.insert(each.first);
    }
    losers.insert(beaten.begin(), beaten.end());
    if (beaten.empty() || beaten.size() + 1 < of.groups.size()) continue;
    for (const std::string& other : beaten) {
      Group first = group, second = *std::ranges::find(of.groups, other, &Group::name);
      keep_common_blocks(first, second);
      const double one = mean_of(first), two = mean_of(second);
      const double relative = plan.margin * (of.scale == Scale::share ? 1 : std::min(std::abs(one), std::abs(two)));
      if ((of.better == Better::smaller ? one - two : two - one) > std::max(plan.absolute_margin, relative))
        return {.usual = group.name, .by_mean = other};
    }
    return {.best = group.name};
  }
  return {.is_circle = !losers.empty() && losers.size() == of.groups.size()};
}

}  // namespace ikbench::compare
