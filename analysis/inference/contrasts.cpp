#include "analysis/inference/contrasts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/inference/deciding.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/margin.hpp"
#include "analysis/inference/pair_ranks.hpp"
#include "analysis/inference/tests_of_means.hpp"
#include "analysis/statistics/effect_size.hpp"
#include "analysis/statistics/friedman.hpp"
#include "analysis/statistics/hodges_lehmann.hpp"
#include "analysis/statistics/median_interval.hpp"
#include "analysis/statistics/multiple_comparisons.hpp"
#include "analysis/statistics/power.hpp"
#include "analysis/statistics/proportion.hpp"
#include "analysis/statistics/rounding.hpp"
#include "analysis/statistics/studentized_bootstrap.hpp"
#include "analysis/statistics/studentized_range.hpp"
#include "analysis/statistics/welch.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

using Values = std::span<const std::vector<double>>;

// The better one has the smaller value here.
std::vector<std::vector<double>> smaller_is_better(const Evidence& evidence, Values values) {
  std::vector<std::vector<double>> result(values.begin(), values.end());
  if (evidence.better == Better::smaller) return result;
  for (std::vector<double>& group : result) {
    for (double& value : group) value = -value;
  }
  return result;
}

// The group that pairs are shown with, where not all are.
std::optional<std::size_t> reference_of(const Evidence& evidence) {
  const auto& groups = evidence.groups;
  if (!evidence.plan.control.empty()) {
    const auto control = std::ranges::find(groups, evidence.plan.control, &GroupEvidence::name);
    return static_cast<std::size_t>(control - groups.begin());
  }
  if (groups.size() <= most_groups_in_pairs) return std::nullopt;
  return best_group(evidence);
}

// Where groups have blocks in common: the share of blocks in which the first is better. An interval needs whole blocks,
// so there is one where no two values of a block are equal.
Estimate share_of_blocks(const std::vector<double>& first, const std::vector<double>& second, double level) {
  int wins = 0, ties = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    wins += first[i] < second[i] ? 1 : 0;
    ties += first[i] == second[i] ? 1 : 0;
  }
  Estimate result{.value = (wins + 0.5 * ties) / static_cast<double>(first.size())};
  if (ties > 0) return result;
  const Proportion interval = wilson({.successes = wins, .trials = static_cast<int>(first.size())}, level);
  result.low = interval.low;
  result.high = interval.high;
  return result;
}

Estimate superiority(const Evidence& evidence, const std::vector<double>& first, const std::vector<double>& second) {
  const double level = 1 - evidence.plan.significance;
  if (first.empty() || second.empty()) return {};
  if (evidence.blocks > 0) return share_of_blocks(first, second, level);
  const EffectSize found = vargha_delaney(second, first, level);  // the chance that second is larger, so first better
  return {.value = found.value, .low = found.low, .high = found.high};
}

// Where every value says the same of a pair, which has it that one is ahead or that they are equal: what chance has it,
// were they alike? In blocks that no difference has the other sign, else by Fisher's exact test; for all pairs
// together.
double chance_of_unanimity(const Evidence& evidence, int n, int m) {
  const double chance =
      evidence.blocks > 0 ? 2 * std::exp2(-n) : fisher_exact({.successes = n, .trials = n}, {.trials = m}).p;
  return std::min(1.0, chance * static_cast<double>(evidence.family()));
}

double chance_of_unanimity(const Evidence& evidence, const Contrast& contrast) {
  return chance_of_unanimity(evidence, evidence.groups[contrast.first].described.n,
                             evidence.groups[contrast.second].described.n);
}

// How far apart two groups are that ranks compare; the interval holds for the whole family by Bonferroni.
Estimate ratio_of_ranked(const Evidence& evidence, const std::vector<double>& first,
                         const std::vector<double>& second) {
  const bool is_log = evidence.scale == ValueScale::log10;
  const auto all = [&](auto is) { return std::ranges::all_of(first, is) && std::ranges::all_of(second, is); };
  if (!all([](double value) { return std::isfinite(value); })) return {};
  const bool are_negative = !is_log && all([](double value) { return value < 0; });
  if (!is_log && !are_negative && !all([](double value) { return value > 0; })) return {};
  const auto logarithms = [&](const std::vector<double>& values) {
    std::vector<double> result;
    for (const double value : values)
      result.push_back(is_log ? value * std::numbers::ln10 : are_negative ? -std::log(-value) : std::log(value));
    return result;
  };
  const std::vector<double> one = logarithms(first), other = logarithms(second);
  const double level = 1 - evidence.plan.significance / static_cast<double>(evidence.family());
  if (evidence.blocks == 0) {
    const Shift shift = hodges_lehmann(one, other, level);
    return {.value = std::exp(shift.estimate), .low = std::exp(shift.low), .high = std::exp(shift.high)};
  }
  std::vector<double> differences;
  for (std::size_t i = 0; i < one.size(); ++i) differences.push_back(one[i] - other[i]);
  std::ranges::sort(differences);
  const MedianInterval interval = median_interval(differences, level);
  return {.value = std::exp(median(differences)), .low = std::exp(interval.low), .high = std::exp(interval.high)};
}

// Of the differences within blocks; p and interval hold for the whole family by Bonferroni.
void compare_in_blocks(const Evidence& evidence, Values values, Contrast& contrast) {
  const auto family = static_cast<double>(evidence.family());
  const PairedTest test =
      paired_t(values[contrast.first], values[contrast.second], 1 - evidence.plan.significance / family);
  contrast.p_paired = std::min(1.0, family * test.p);
  if (std::isnan(test.p)) contrast.p_paired = not_defined;
  const bool is_equal = values[contrast.first] == values[contrast.second];  // in every block
  if (is_equal) contrast.p_paired = 1;
  if (!evidence.decides_within_blocks()) return;
  if (evidence.ranks_decide()) contrast.difference = {.value = test.difference, .low = test.low, .high = test.high};
  if (!is_equal) return;
  (evidence.ranks_decide() ? contrast.p_ranks : contrast.p_bootstrap) = 1;  // no difference is above or below 0
  contrast.undefined.clear();
  if (chance_of_unanimity(evidence, contrast) < evidence.plan.significance) contrast.difference = {0, 0, 0};
}

int ahead_by_means(const Evidence& evidence, double difference) {
  return evidence.better == Better::smaller ? -sign_of(difference) : sign_of(difference);
}

// Of the bootstrap's pairs those that do not overlap, or differ alike in every block, where a group has one value
// alone, or there are so few that the bootstrap has no spread to judge by.
bool has_order(const Evidence& evidence, const Contrast& contrast) {
  const Description &first = evidence.groups[contrast.first].described,
                    &second = evidence.groups[contrast.second].described;
  if (evidence.plan.test != DecidingTest::bootstrap || evidence.of_outcomes) return false;
  if (!std::isfinite(first.mean) || !std::isfinite(second.mean)) return false;
  const double ahead = contrast.superiority.value;
  if (evidence.blocks > 0) return std::isnan(contrast.p_bootstrap) && (ahead == 0 || ahead == 1);
  const bool lacks_spread = std::isnan(contrast.p_bootstrap) || is_constant(first) != is_constant(second);
  return lacks_spread && (first.max < second.min || second.max < first.min);
}

}  // namespace

bool are_constants(const Evidence& evidence, const Contrast& contrast) {
  return !evidence.from_summaries && !evidence.of_outcomes && is_constant(evidence.groups[contrast.first].described) &&
         is_constant(evidence.groups[contrast.second].described);
}

int fewest_to_differ(const Evidence& evidence) {
  int n = 2;
  while (chance_of_unanimity(evidence, n, n) >= evidence.plan.significance) ++n;
  const bool by_bootstrap = evidence.plan.test == DecidingTest::bootstrap && !evidence.of_outcomes;
  return by_bootstrap ? std::min(n, fewest_blocks(evidence.family(), 1 - evidence.plan.significance)) : n;
}

Relation relation_of(const Evidence& evidence, const Contrast& contrast, double p) {
  const Tested tested{.p_better = contrast.ahead > 0 ? p : 1,
                      .p_worse = contrast.ahead > 0 ? 1 : p,
                      .within_margin = contrast.extent == Extent::within};
  return relation_of(tested, evidence.plan.significance);
}

namespace {

// Wherever the values of two groups that do not overlap were drawn from: how likely they are to lie apart, either way,
// if both were drawn from the same. Within blocks it is the sign test; else Mann and Whitney's exact test of such
// ranks.
double chance_of_order(const Evidence& evidence, const Contrast& contrast) {
  const int n = evidence.groups[contrast.first].described.n, m = evidence.groups[contrast.second].described.n;
  if (evidence.blocks > 0) return chance_of_unanimity(evidence, n, m);
  double chance = 2 * static_cast<double>(evidence.family());
  for (int i = 1; i <= n; ++i) chance *= static_cast<double>(i) / (m + i);
  return std::min(1.0, chance);
}

// Of what so many observations without a failure do not exclude. Where each is 0 or 1, it is the failures that differ.
double unseen_failures(const Evidence& evidence, int observations) {
  return most_without_success(observations, evidence.plan.significance / static_cast<double>(evidence.family()));
}

// Two groups of one value each. So many values are needed to find a difference, and as many to find that there is none.
void judge_constants(const Evidence& evidence, Contrast& contrast) {
  const Description& first = evidence.groups[contrast.first].described;
  const Description& second = evidence.groups[contrast.second].described;
  const double difference = first.mean - second.mean;
  const double by_chance = chance_of_unanimity(evidence, contrast);
  contrast.p = difference == 0 ? 1 : by_chance;
  contrast.ahead = ahead_by_means(evidence, difference);
  contrast.undefined.clear();
  contrast.difference = {.value = difference};
  contrast.relation = Relation::undecided;
  if (by_chance >= evidence.plan.significance) {
    contrast.runs_to_decide.value = fewest_to_differ(evidence);
    return;
  }
  contrast.difference = {difference, difference, difference};
  const bool are_shares = evidence.scale == ValueScale::plain && (first.mean == 0 || first.mean == 1);
  if (difference == 0 && are_shares) {
    contrast.difference.low = -unseen_failures(evidence, first.n);
    contrast.difference.high = unseen_failures(evidence, second.n);
    contrast.runs_to_decide.value = trials_to_exclude(
        evidence.plan.margin * first.mean, evidence.plan.significance / static_cast<double>(evidence.family()));
  }
  contrast.extent = extent_of(evidence, contrast);
  contrast.relation = relation_of(evidence, contrast, contrast.p);
  if (contrast.relation != Relation::undecided) contrast.runs_to_decide = {};
}

void judge(const Evidence& evidence, Contrast& contrast) {
  if (are_constants(evidence, contrast)) {
    judge_constants(evidence, contrast);
    return;
  }
  if (has_order(evidence, contrast)) {
    const double by_chance = chance_of_order(evidence, contrast);  // of so many values, whatever they are
    if (by_chance < evidence.plan.significance) {
      contrast.p = by_chance;
      contrast.ahead = ahead_by_means(evidence, contrast.difference.value);
      contrast.is_by_order = true;
    }
  }
  if (!std::isfinite(contrast.p)) {
    if (contrast.undefined.empty()) {
      contrast.undefined = "a group has fewer than two values, or values that are not finite";
    }
    return;
  }
  contrast.undefined.clear();
  contrast.extent = extent_of(evidence, contrast);
  contrast.relation = relation_of(evidence, contrast, contrast.p);
}

// What a difference of the margin takes where values spread as they seem to, and as they plausibly do. The difference
// that was seen has no say: it may be chance. Signs know no sizes: of them it is what the test needs at least.
Estimate runs_to_decide(const Evidence& evidence, const Contrast& contrast, std::span<const GroupSummary> summaries,
                        Values values) {
  if (evidence.plan.test == DecidingTest::friedman) return {.value = static_cast<double>(evidence.fewest)};
  const PowerGoal goal{.power = evidence.plan.power,
                       .alpha = evidence.plan.significance / static_cast<double>(evidence.family())};
  const double to_see = margin_of(evidence, contrast), outside = evidence.plan.significance / 2;
  const auto runs = [&](double probability) {
    GroupSummary first = summaries[contrast.first], second = summaries[contrast.second];
    if (evidence.decides_within_blocks()) {
      const double std =
          standard_deviation(differences_without_rounding(values[contrast.first], values[contrast.second]));
      return pairs_to_see(plausible_deviation(std, first.n, probability), to_see, goal).n;
    }
    first.std = plausible_deviation(first.std, first.n, probability);
    second.std = plausible_deviation(second.std, second.n, probability);
    return runs_to_see(first, second, to_see, goal).n;
  };
  const double fewest = evidence.fewest > 0 ? evidence.fewest : not_defined;
  const double low = std::fmax(runs(outside), fewest), high = runs(1 - outside);
  // More than the search goes to is no number: as many or more.
  return {.value = std::fmax(runs(0.5), fewest),
          .low = low,
          .high = std::isnan(high) ? std::numeric_limits<double>::infinity() : std::fmax(high, fewest)};
}

double deciding_p(const Evidence& evidence, const Contrast& contrast) {
  switch (evidence.plan.test) {
    case DecidingTest::anova:
      return contrast.p_pooled;
    case DecidingTest::kruskal_wallis:
    case DecidingTest::friedman:
      return contrast.p_ranks;
    case DecidingTest::tamhane:
      return contrast.p_tamhane;
    case DecidingTest::bootstrap:
      return contrast.p_bootstrap;
    default:
      return contrast.p_unpooled;
  }
}

}  // namespace

std::vector<PairMethod> pair_methods(const Evidence& evidence) {
  if (evidence.of_outcomes) return {};
  std::vector<PairMethod> methods{{"Tukey", "pooled variance", &Contrast::p_pooled},
                                  {"Games-Howell", "separate variances", &Contrast::p_unpooled},
                                  {"Tamhane", "separate variances, few values", &Contrast::p_tamhane}};
  if (evidence.from_summaries) return methods;
  if (evidence.plan.test == DecidingTest::bootstrap) {
    methods.push_back({"bootstrap", "studentized, skewed values", &Contrast::p_bootstrap});
  }
  if (evidence.blocks > 0) {
    for (PairMethod& method : methods) method.note = "without the blocks";
    methods.push_back({"paired t", "means within blocks", &Contrast::p_paired});
  }
  const bool in_blocks = evidence.ranks_within_blocks();
  if (in_blocks) {
    methods.push_back({"sign test", "ranks within blocks", &Contrast::p_ranks});
  } else {
    methods.push_back({"Mann-Whitney", "ranks", &Contrast::p_mann_whitney});
    methods.push_back({"Brunner-Munzel", "ranks, unequal spreads", &Contrast::p_brunner_munzel});
  }
  if (evidence.groups.size() == 2) return methods;
  methods.push_back({in_blocks ? "Friedman" : "Dunn", "mean ranks over all groups", &Contrast::p_mean_ranks});
  if (in_blocks) methods.push_back({"Nemenyi", "mean ranks over all groups", &Contrast::p_nemenyi});
  return methods;
}

void add_friedman(Evidence& evidence, Values values) {
  const Friedman test = friedman(smaller_is_better(evidence, values));
  for (std::size_t i = 0; i < test.average_ranks.size(); ++i) {
    evidence.groups[i].average_rank = test.average_ranks[i];
  }
  evidence.tests.push_back({.test = std::string(friedman_name),
                            .role = Role::robust,
                            .symbol = "chi^2",
                            .statistic = test.chi_squared,
                            .df = static_cast<double>(test.df),
                            .p = test.p,
                            .effect_symbol = "W",
                            .effect = test.kendall_w,
                            .undefined = test.undefined});
  evidence.tests.push_back({.test = std::string(iman_davenport_name),
                            .role = Role::robust,
                            .symbol = "F",
                            .statistic = test.F,
                            .df = test.F_df_between,
                            .df_within = test.F_df_within,
                            .p = test.F_p,
                            .undefined = test.undefined});
  if (!test.undefined.empty()) return;
  const auto k = static_cast<double>(evidence.groups.size());
  const double q =
      studentized_range_quantile(1 - evidence.plan.significance, k, std::numeric_limits<double>::infinity());
  evidence.critical_difference = critical_difference(q / std::sqrt(2.0), evidence.groups.size(), evidence.blocks);
}

std::vector<Contrast> shown_pairs(Evidence& evidence) {
  const std::size_t k = evidence.groups.size();
  evidence.pairs = k * (k - 1) / 2;
  evidence.reference = reference_of(evidence);
  std::vector<Contrast> all;
  all.reserve(evidence.pairs);
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = i + 1; j < k; ++j) all.push_back({.first = i, .second = j});
  }
  if (evidence.reference) {
    std::erase_if(all,
                  [&](const Contrast& c) { return c.first != *evidence.reference && c.second != *evidence.reference; });
  }
  return all;
}

void add_contrasts(Evidence& evidence, std::span<const GroupSummary> summaries, Values values) {
  std::vector<Contrast> all = shown_pairs(evidence);
  const auto ahead = smaller_is_better(evidence, values);
  add_rank_tests(evidence, ahead, all);

  if (evidence.ranks_decide() || evidence.decides_within_blocks()) evidence.fewest = fewest_to_differ(evidence);

  const double level = 1 - evidence.plan.significance;
  const TestsOfMeans tests = tests_of_means(evidence, summaries, values);
  for (std::size_t i = 0; i < all.size(); ++i) {
    Contrast& contrast = all[i];
    const GroupSummary &first = summaries[contrast.first], &second = summaries[contrast.second];
    contrast.p_pooled = tests.pooled[i].p;
    contrast.p_unpooled = tests.unpooled[i].p;
    contrast.p_tamhane = tests.by_tamhane[i].p;
    if (!tests.bootstrapped.empty()) contrast.p_bootstrap = tests.bootstrapped[i].p;
    const MeanDifference& shown = tests.deciding(evidence.plan.test, i);
    contrast.difference = {.value = first.mean - second.mean, .low = shown.low, .high = shown.high};
    if (!evidence.ranks_decide()) {
      contrast.ahead = ahead_by_means(evidence, shown.difference);
      contrast.undefined = shown.undefined;
    }
    contrast.g = hedges_g(first, second);
    if (evidence.ranks_decide() && !values.empty())
      contrast.ratio = ratio_of_ranked(evidence, values[contrast.first], values[contrast.second]);
    if (!ahead.empty()) {
      contrast.superiority = superiority(evidence, ahead[contrast.first], ahead[contrast.second]);
      if (evidence.blocks > 0) {
        compare_in_blocks(evidence, values, contrast);
      } else {
        const Shift shift = hodges_lehmann(values[contrast.first], values[contrast.second], level);
        contrast.shift = {.value = shift.estimate, .low = shift.low, .high = shift.high};
      }
    }
    contrast.p = deciding_p(evidence, contrast);
    judge(evidence, contrast);
    if (contrast.relation == Relation::undecided && std::isnan(contrast.runs_to_decide.value)) {
      contrast.runs_to_decide = runs_to_decide(evidence, contrast, summaries, values);
    }
  }
  evidence.contrasts = std::move(all);
}

}  // namespace ikbench::inference
