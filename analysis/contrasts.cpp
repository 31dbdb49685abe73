#include "analysis/contrasts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/statistics/effect_size.hpp"
#include "analysis/statistics/friedman.hpp"
#include "analysis/statistics/kruskal_wallis.hpp"
#include "analysis/statistics/multiple_comparisons.hpp"
#include "analysis/statistics/p_adjust.hpp"
#include "analysis/statistics/power.hpp"
#include "analysis/statistics/proportion.hpp"
#include "analysis/statistics/studentized_range.hpp"
#include "analysis/statistics/welch.hpp"

namespace ikbench {
namespace {

using Values = std::span<const std::vector<double>>;

Correction correction_of(Adjustment adjustment) { return static_cast<Correction>(adjustment); }

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
  const auto worth = [&](const GroupEvidence& group) {
    const double mean = evidence.better == Better::smaller ? group.described.mean : -group.described.mean;
    return std::isfinite(mean) ? mean : std::numeric_limits<double>::infinity();
  };
  return static_cast<std::size_t>(std::ranges::min_element(groups, {}, worth) - groups.begin());
}

// Of p-values of all pairs, in order, those of one group; corrected for the family that is compared: with a control its
// pairs alone, else all of them.
std::vector<double> corrected(const Evidence& evidence, const std::vector<Contrast>& all, std::vector<double> raw) {
  const Correction how = correction_of(evidence.plan.adjustment);
  if (evidence.plan.control.empty()) return adjusted(raw, how);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].first != *evidence.reference && all[i].second != *evidence.reference) raw[i] = not_defined;
  }
  return adjusted(raw, how);  // what is not defined does not count
}

std::vector<double> rank_tests(const Evidence& evidence, Values values, const std::vector<Contrast>& all) {
  std::vector<double> raw(all.size(), not_defined);
  if (values.empty()) return raw;
  const std::vector<RankComparison> pairs =
      evidence.blocks > 0 ? compare_average_ranks(friedman(smaller_is_better(evidence, values))) : dunn(values);
  for (std::size_t i = 0; i < std::min(pairs.size(), all.size()); ++i) raw[i] = pairs[i].p;
  return corrected(evidence, all, std::move(raw));
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

// Of the differences within blocks; p and interval hold for the whole family by Bonferroni.
void compare_in_blocks(const Evidence& evidence, Values values, Contrast& contrast) {
  const auto family = static_cast<double>(evidence.plan.control.empty() ? evidence.pairs : evidence.groups.size() - 1);
  const PairedTest test =
      paired_t(values[contrast.first], values[contrast.second], 1 - evidence.plan.significance / family);
  contrast.p_paired = std::min(1.0, family * test.p);
  if (std::isnan(test.p)) contrast.p_paired = not_defined;
  if (evidence.plan.test != DecidingTest::friedman) return;
  contrast.difference = {.value = test.difference, .low = test.low, .high = test.high};
  contrast.undefined.clear();  // the ranks of a block need no finite values
}

// The difference of means that matters: the planned share of the smaller of the two.
double margin_of(const Evidence& evidence, const Contrast& contrast) {
  return evidence.plan.margin * std::min(std::abs(evidence.groups[contrast.first].described.mean),
                                         std::abs(evidence.groups[contrast.second].described.mean));
}

void judge(const Evidence& evidence, Contrast& contrast) {
  const Description& first = evidence.groups[contrast.first].described;
  const Description& second = evidence.groups[contrast.second].described;
  const bool constant = !evidence.from_summaries && first.n > 1 && second.n > 1 && first.not_finite == 0 &&
                        second.not_finite == 0 && first.min == first.max && second.min == second.max;
  const double sign = evidence.better == Better::smaller ? 1 : -1;
  if (constant) {  // a fact, not a finding
    contrast.difference = {first.mean - second.mean, first.mean - second.mean, first.mean - second.mean};
    contrast.undefined.clear();
    contrast.within_margin = std::abs(contrast.difference.value) <= margin_of(evidence, contrast);
    contrast.relation = first.mean == second.mean              ? Relation::equivalent
                        : sign * contrast.difference.value < 0 ? Relation::first_better
                                                               : Relation::second_better;
    return;
  }
  if (!std::isfinite(contrast.p)) {
    if (contrast.undefined.empty())
      contrast.undefined = "a group has fewer than two values, or values that are not finite";
    return;
  }
  const double room = margin_of(evidence, contrast);
  contrast.within_margin = std::abs(contrast.difference.low) <= room && std::abs(contrast.difference.high) <= room;
  if (contrast.p >= evidence.plan.significance) {
    contrast.relation = contrast.within_margin ? Relation::equivalent : Relation::not_told_apart;
    return;
  }
  // Which is ahead is the deciding test's word: by ranks the chance of being better, else the mean.
  const bool by_ranks =
      evidence.plan.test == DecidingTest::kruskal_wallis || evidence.plan.test == DecidingTest::friedman;
  const GroupEvidence& one = evidence.groups[contrast.first];
  const GroupEvidence& other = evidence.groups[contrast.second];
  const bool first_ahead = evidence.plan.test == DecidingTest::friedman ? one.average_rank < other.average_rank
                           : by_ranks                                   ? contrast.superiority.value > 0.5
                                                                        : sign * (first.mean - second.mean) < 0;
  contrast.relation = first_ahead ? Relation::first_better : Relation::second_better;
}

double deciding_p(const Evidence& evidence, const Contrast& contrast) {
  switch (evidence.plan.test) {
    case DecidingTest::anova:
      return contrast.p_pooled;
    case DecidingTest::kruskal_wallis:
    case DecidingTest::friedman:
      return contrast.p_ranks;
    default:
      return contrast.p_unpooled;
  }
}

}  // namespace

void add_friedman(Evidence& evidence, Values values) {
  const Friedman test = friedman(smaller_is_better(evidence, values));
  for (std::size_t i = 0; i < test.average_ranks.size(); ++i) {
    evidence.groups[i].average_rank = test.average_ranks[i];
  }
  evidence.tests.push_back({.test = "Friedman's test",
                            .role = Role::sound,
                            .symbol = "chi^2",
                            .statistic = test.chi_squared,
                            .df = static_cast<double>(test.df),
                            .p = test.p,
                            .effect_symbol = "W",
                            .effect = test.kendall_w,
                            .undefined = test.undefined});
  evidence.tests.push_back({.test = "Iman and Davenport's form of it",
                            .role = Role::sound,
                            .symbol = "F",
                            .statistic = test.F,
                            .df = test.F_df_between,
                            .df_within = test.F_df_within,
                            .p = test.F_p,
                            .undefined = test.undefined});
  const auto k = static_cast<double>(evidence.groups.size());
  const double q =
      studentized_range_quantile(1 - evidence.plan.significance, k, std::numeric_limits<double>::infinity());
  evidence.critical_difference = critical_difference(q / std::sqrt(2.0), evidence.groups.size(), evidence.blocks);
}

void add_contrasts(Evidence& evidence, std::span<const GroupSummary> summaries, Values values) {
  const std::size_t k = evidence.groups.size();
  evidence.pairs = k * (k - 1) / 2;
  evidence.reference = reference_of(evidence);
  std::vector<Contrast> all;
  all.reserve(evidence.pairs);
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = i + 1; j < k; ++j) all.push_back({.first = i, .second = j});
  }
  const std::vector<double> p_ranks = rank_tests(evidence, values, all);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].p_ranks = p_ranks[i];
  if (evidence.reference) {
    std::erase_if(all,
                  [&](const Contrast& c) { return c.first != *evidence.reference && c.second != *evidence.reference; });
  }

  const double level = 1 - evidence.plan.significance;
  const PowerGoal goal{.power = evidence.plan.power, .alpha = evidence.plan.significance};
  const std::vector<MeanDifference> pooled = tukey(summaries, level, evidence.reference);
  const std::vector<MeanDifference> unpooled = games_howell(summaries, level, evidence.reference);
  const auto ahead = smaller_is_better(evidence, values);
  for (std::size_t i = 0; i < all.size(); ++i) {
    Contrast& contrast = all[i];
    const GroupSummary &first = summaries[contrast.first], &second = summaries[contrast.second];
    contrast.p_pooled = pooled[i].p;
    contrast.p_unpooled = unpooled[i].p;
    const MeanDifference& shown = evidence.plan.test == DecidingTest::anova ? pooled[i] : unpooled[i];
    contrast.difference = {.value = first.mean - second.mean, .low = shown.low, .high = shown.high};
    contrast.undefined = shown.undefined;
    const EffectSize g = hedges_g(first, second, level);
    contrast.g = {.value = g.value, .low = g.low, .high = g.high};
    if (evidence.blocks == 0) {
      contrast.runs_to_see_margin = runs_to_see(first, second, margin_of(evidence, contrast), goal).n;
    }
    if (!ahead.empty()) {
      contrast.superiority = superiority(evidence, ahead[contrast.first], ahead[contrast.second]);
      if (evidence.blocks > 0) compare_in_blocks(evidence, values, contrast);
    }
    contrast.p = deciding_p(evidence, contrast);
    judge(evidence, contrast);
  }
  evidence.contrasts = std::move(all);
}

}  // namespace ikbench
