#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/inference/judge.hpp"
#include "analysis/inference/margin.hpp"
#include "analysis/inference/outcomes.hpp"
#include "analysis/statistics/effect_size.hpp"
#include "analysis/statistics/mann_whitney.hpp"
#include "analysis/statistics/proportion.hpp"
#include "analysis/statistics/quantile.hpp"
#include "analysis/statistics/rounding.hpp"
#include "analysis/statistics/studentized_bootstrap.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

// The values of both groups of a pair, described.
std::pair<const Description&, const Description&> both_described(const Evidence& evidence, const Finding& pair) {
  return {evidence.groups[pair.first].described, evidence.groups[pair.second].described};
}

// The group whose pairs are shown if not all pairs are.
std::optional<std::size_t> reference_of(const Evidence& evidence) {
  const auto& groups = evidence.groups;
  if (!evidence.plan.control.empty()) {
    const auto control = std::ranges::find(groups, evidence.plan.control, &GroupEvidence::name);
    return static_cast<std::size_t>(control - groups.begin());
  }
  if (groups.size() <= most_groups_in_pairs) return std::nullopt;
  return best_group(evidence);
}

// Share of blocks in which the first is better; a tie counts half. The interval needs whole counts, so ties leave it
// undefined.
Estimate share_of_blocks(const std::vector<double>& first, const std::vector<double>& second, double level) {
  int wins = 0, ties = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    wins += first[i] < second[i] ? 1 : 0;
    ties += first[i] == second[i] ? 1 : 0;
  }
  if (ties > 0) return {.value = (wins + 0.5 * ties) / static_cast<double>(first.size())};
  return wilson({.successes = wins, .trials = static_cast<int>(first.size())}, level);
}

Estimate superiority(const Evidence& evidence, const std::vector<double>& first, const std::vector<double>& second) {
  const double level = 1 - evidence.plan.significance;
  if (first.empty() || second.empty()) return {};
  if (evidence.blocks > 0) return share_of_blocks(first, second, level);
  return vargha_delaney(second, first, level);  // the chance that second is larger, so first better
}

// Probability that `n` runs lie on one side of a known value, or that blocks differ in one direction: the sign test.
double chance_of_one_side(int n) { return 2 * std::exp2(-n); }

// Probability that all values of two equal groups agree by chance: within blocks, that no difference has the other
// sign; else by Fisher's exact test.
double chance_of_unanimity(const Evidence& evidence, int n, int m) {
  return evidence.blocks > 0 ? chance_of_one_side(n) : fisher_exact({.successes = n, .trials = n}, {.trials = m});
}

// Corrects a probability for all pairs of the family (Bonferroni).
double in_family(const Evidence& evidence, double chance) {
  return std::min(1.0, chance * static_cast<double>(evidence.family()));
}

double chance_of_unanimity(const Evidence& evidence, const Finding& contrast) {
  const auto& [first, second] = both_described(evidence, contrast);
  return chance_of_unanimity(evidence, first.n, second.n);
}

// Fewest observations whose chance shows a difference.
template <class Chance>
int fewest_to_show(const Evidence& evidence, double significance, const Chance& chance_of) {
  int n = 2;
  while (in_family(evidence, chance_of(n)) >= significance) ++n;
  return n;
}

// Fewest observations per group (or blocks) of which the order alone shows a difference.
int fewest_in_order(const Evidence& evidence, double significance) {
  return fewest_to_show(evidence, significance, [&](int n) { return chance_of_unanimity(evidence, n, n); });
}
int fewest_in_order(const Evidence& evidence) { return fewest_in_order(evidence, evidence.plan.significance); }

int ahead_by_means(const Evidence& evidence, double difference) {
  return evidence.better == Better::smaller ? -sign_of(difference) : sign_of(difference);
}

// Returns whether an exact test of order replaces the bootstrap, or any test that a known value leaves without p: the
// groups do not overlap, or differ in one direction in every block, and one group has a single value or the bootstrap
// has no spread to judge by.
bool has_order(const Evidence& evidence, const Finding& contrast) {
  const auto& [first, second] = both_described(evidence, contrast);
  if (!evidence.method->resamples && !(has_known(evidence, contrast) && std::isnan(contrast.p))) return false;
  if (!std::isfinite(first.mean) || !std::isfinite(second.mean)) return false;
  const double ahead = contrast.superiority.value;
  if (evidence.blocks > 0) return std::isnan(contrast.p) && (ahead == 0 || ahead == 1);
  const bool lacks_spread = std::isnan(contrast.p) || is_constant(first) != is_constant(second);
  return lacks_spread && (first.max < second.min || second.max < first.min);
}

}  // namespace

bool are_constants(const Evidence& evidence, const Finding& contrast) {
  const auto& [first, second] = both_described(evidence, contrast);
  return !evidence.from_summaries && !evidence.of_outcomes && is_constant(first) && is_constant(second);
}

bool has_known(const Evidence& evidence, const Finding& contrast) {
  return evidence.groups[contrast.first].copies + evidence.groups[contrast.second].copies > 0;
}

int fewest_to_differ(const Evidence& evidence) {
  const int n = fewest_in_order(evidence);
  return evidence.method->resamples ? std::min(n, fewest_blocks(evidence.family(), 1 - evidence.plan.significance)) : n;
}

namespace {

// Two-sided probability that two groups from one distribution do not overlap: by the sign test within blocks and
// against a known value, else by Mann and Whitney's exact test.
double chance_of_order(const Evidence& evidence, const Finding& contrast) {
  const auto& [first, second] = both_described(evidence, contrast);
  const int n = first.n, m = second.n;
  if (evidence.blocks > 0) return chance_of_unanimity(evidence, n, m);
  if (has_known(evidence, contrast)) return chance_of_one_side(std::max(n, m));
  double chance = 2;
  for (int i = 1; i <= n; ++i) chance *= static_cast<double>(i) / (m + i);
  return chance;
}

// Returns whether two equal constants may be shares: both 0 or both 1, where all groups are in the unit interval.
bool may_be_shares(const Evidence& evidence, double value) {
  const auto is_in_unit = [](const GroupEvidence& group) {
    return group.described.min >= 0 && group.described.max <= 1;
  };
  return evidence.scale != ValueScale::log10 && (value == 0 || value == 1) &&
         std::ranges::all_of(evidence.groups, is_in_unit);
}

// Returns whether every value of a group is the known value of the other.
bool equals_known(const Evidence& evidence, const Finding& contrast) {
  const auto& [first, second] = both_described(evidence, contrast);
  return has_known(evidence, contrast) && first.min == second.max && first.max == second.min;
}

Relation relation_by_p(const Evidence& evidence, const Finding& contrast) {
  return relation_of(contrast.ahead, contrast.p, evidence.plan.significance, contrast.is_within_margin());
}

// Judges two groups with one value each. To find no difference takes as many values as to find one, and of what may be
// shares as many as exclude failures beyond the margin.
void judge_constants(const Evidence& evidence, Finding& contrast) {
  const auto& [first, second] = both_described(evidence, contrast);
  const double difference = first.mean - second.mean;
  contrast.is_by_order = has_known(evidence, contrast);
  const double alone =
      contrast.is_by_order ? chance_of_order(evidence, contrast) : chance_of_unanimity(evidence, contrast);
  const double by_chance = in_family(evidence, alone);
  const bool are_shares = difference == 0 && may_be_shares(evidence, first.mean);
  contrast.p = difference == 0 ? 1 : by_chance;
  contrast.p_alone = difference == 0 ? 1 : std::min(1.0, alone);
  contrast.ahead = ahead_by_means(evidence, difference);
  contrast.why.clear();
  contrast.estimate = {.value = difference};
  contrast.relation = Relation::undecided;
  if (by_chance >= evidence.plan.significance) return;
  contrast.estimate = {difference, difference, difference};
  if (are_shares) {
    const auto unseen = [&](std::size_t group) {  // the largest share of failures that is not excluded
      const GroupEvidence& of = evidence.groups[group];
      return of.copies > 0 ? 0 : most_without_success(of.described.n, evidence.alpha());
    };
    contrast.estimate.low = -unseen(contrast.first);
    contrast.estimate.high = unseen(contrast.second);
  }
  measure_extent(evidence, contrast);
  contrast.relation = relation_by_p(evidence, contrast);
}

// Compares two known values, or two groups that are equal bit for bit.
void judge_facts(const Evidence& evidence, Finding& contrast) {
  const double worst = (evidence.better == Better::smaller ? 1 : -1) * std::numeric_limits<double>::infinity();
  const auto known = [&](std::size_t group) {
    const double value = evidence.groups[group].described.max;
    return std::isfinite(value) ? value : worst;
  };
  const double first = known(contrast.first), second = known(contrast.second);
  const double difference = first == second ? 0 : first - second;
  contrast.is_fact = true;
  contrast.p = contrast.p_alone = not_defined;
  contrast.why.clear();
  contrast.estimate = {difference, difference, difference};
  contrast.ahead = ahead_by_means(evidence, difference);
  if (std::isfinite(difference)) {
    measure_extent(evidence, contrast);
  } else {
    put_beyond_any_margin(contrast);
  }
  contrast.relation = first == second || contrast.is_within_margin() ? Relation::same
                      : contrast.ahead > 0                           ? Relation::better
                                                                     : Relation::worse;
  contrast.estimate = {.value = difference};
}

// Whether a test of order replaces the bootstrap must not depend on the level, so that is the usual one.
constexpr double usual_significance = 0.05;

void judge(const Evidence& evidence, Finding& contrast) {
  if (is_fact(evidence.groups[contrast.first], evidence.groups[contrast.second])) {
    judge_facts(evidence, contrast);
    return;
  }
  if (are_constants(evidence, contrast) || equals_known(evidence, contrast)) {
    judge_constants(evidence, contrast);
    return;
  }
  if (has_order(evidence, contrast)) {
    const double alone = chance_of_order(evidence, contrast);  // depends on the numbers of values only
    const double by_chance = in_family(evidence, alone);
    const bool is_against_known = has_known(evidence, contrast);  // which no other test judges
    if (by_chance < usual_significance || is_against_known) {
      contrast.p = by_chance;
      contrast.p_alone = std::min(1.0, alone);
      contrast.ahead = ahead_by_means(evidence, contrast.estimate.value);
      contrast.is_by_order = true;
      contrast.lacks_spread = false;
    }
  }
  if (!std::isfinite(contrast.p)) {
    if (contrast.lacks_spread) {
      contrast.relation = Relation::undecided;
      if (evidence.blocks > 0) {
        const int enough = fewest_in_order(evidence, std::min(evidence.plan.significance, usual_significance));
        contrast.why += fmt::format(" different ones, or {} {} that all favour one group", enough, evidence.block_noun);
      }
    } else if (const double ahead = contrast.superiority.value;
               has_known(evidence, contrast) && ahead != 0 && ahead != 1) {
      contrast.why = "the runs of the other are not all on one side of a known value";
    } else if (contrast.why.empty()) {
      contrast.why = "a group has fewer than two values, or values that are not finite";
    }
    return;
  }
  contrast.why.clear();
  measure_extent(evidence, contrast);
  contrast.relation = relation_by_p(evidence, contrast);
}

// Judges two groups with equal values in every block.
void judge_equal_blocks(const Evidence& evidence, Finding& contrast) {
  contrast.p = contrast.p_alone = 1;
  contrast.why.clear();
  if (in_family(evidence, chance_of_unanimity(evidence, contrast)) < evidence.plan.significance)
    contrast.estimate = {0, 0, 0};
}

// Typical ratio of two groups that ranks compare; its interval holds for the whole family (Bonferroni).
Estimate typical_ratio(const Evidence& evidence, const std::vector<double>& first, const std::vector<double>& second) {
  const bool is_log = evidence.scale == ValueScale::log10;
  const auto all = [&](auto is) { return std::ranges::all_of(first, is) && std::ranges::all_of(second, is); };
  if (!all([](double value) { return std::isfinite(value); })) return {};
  const bool are_negative = !is_log && all([](double value) { return value < 0; });
  if (!is_log && !are_negative && !all([](double value) { return value > 0; })) return {};
  const auto exponential = [](const Estimate& of) {
    return Estimate{.value = std::exp(of.value), .low = std::exp(of.low), .high = std::exp(of.high)};
  };
  const auto logarithms = [&](const std::vector<double>& values) {
    std::vector<double> result;
    for (const double value : values)
      result.push_back(is_log ? value * std::numbers::ln10 : are_negative ? -std::log(-value) : std::log(value));
    return result;
  };
  const std::vector<double> one = logarithms(first), other = logarithms(second);
  const double level = 1 - evidence.alpha();
  const auto varies = [](const std::vector<double>& values) {
    return std::ranges::any_of(values, [&](double value) { return value != values.front(); });
  };
  const Estimate of = hodges_lehmann(one, other, level);
  // Where most values are tied, an interval without width would hide those that differ.
  const bool has_differences = varies(one) || varies(other);
  return exponential(has_differences && of.low == of.high ? Estimate{.value = of.value} : of);
}

void add_effects(const Evidence& evidence, const Groups& groups, Finding& contrast) {
  if (evidence.of_outcomes) return;
  contrast.g = hedges_g(groups.summaries[contrast.first], groups.summaries[contrast.second]);
  if (groups.values.empty()) return;
  contrast.superiority = superiority(evidence, groups.ranked[contrast.first], groups.ranked[contrast.second]);
  if (evidence.ranks_decide()) {
    contrast.ratio = typical_ratio(evidence, groups.values[contrast.first], groups.values[contrast.second]);
  }
}

}  // namespace

void add_contrasts(Evidence& evidence, const Groups& groups) {
  const std::size_t k = evidence.groups.size();
  evidence.pairs = k * (k - 1) / 2;
  evidence.reference = reference_of(evidence);
  evidence.contrasts = unjudged_pairs(k, evidence.reference);
  if (evidence.method->compares != Compares::means || evidence.decides_within_blocks()) {
    evidence.fewest = fewest_to_differ(evidence);
  }
  std::vector<Finding> results = evidence.method->pairs(evidence, groups);
  for (std::size_t i = 0; i < results.size(); ++i) {
    Finding& contrast = evidence.contrasts[i];
    results[i].first = contrast.first;
    results[i].second = contrast.second;
    contrast = std::move(results[i]);
    if (std::isnan(contrast.estimate.value)) {
      contrast.estimate.value = groups.summaries[contrast.first].mean - groups.summaries[contrast.second].mean;
    }
    add_effects(evidence, groups, contrast);
    const bool is_paired = evidence.decides_within_blocks() && !evidence.of_outcomes;
    if (is_paired && groups.values[contrast.first] == groups.values[contrast.second]) {
      judge_equal_blocks(evidence, contrast);
    }
    judge(evidence, contrast);
  }
}

}  // namespace ikbench::inference
