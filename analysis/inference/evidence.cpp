#include "analysis/inference/evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "analysis/inference/judge.hpp"
#include "analysis/inference/method.hpp"
#include "analysis/inference/not_finite.hpp"
#include "analysis/inference/outcomes.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/anova.hpp"
#include "analysis/statistics/effect_size.hpp"
#include "analysis/statistics/quantile.hpp"
#include "analysis/statistics/ranks.hpp"
#include "analysis/statistics/rounding.hpp"
#include "analysis/statistics/welch.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

using Samples = std::vector<std::vector<double>>;

void name_group(Reason& reason, const std::vector<GroupEvidence>& groups) {
  if (reason.group) reason = named(reason, row_label(groups.at(*reason.group).name, 60));
}

void name_groups(Evidence& evidence) {
  for (TestResult& test : evidence.tests) name_group(test.undefined, evidence.groups);
  for (Finding& contrast : evidence.contrasts) name_group(contrast.why, evidence.groups);
}

void check_control(const Evidence& evidence) {
  if (evidence.plan.control.empty() || group_named(evidence.groups, evidence.plan.control) != nullptr) return;
  std::vector<std::string> names;
  for (const GroupEvidence& group : evidence.groups) names.push_back(group.name);
  throw std::invalid_argument(
      fmt::format("no group '{}' for the control; expected one of: {}", evidence.plan.control, fmt::join(names, ", ")));
}

// Chooses the method before any results are seen.
void choose_method(Evidence& evidence) {
  evidence.method = &method_for(evidence);
  if (!evidence.of_outcomes || evidence.plan.test == by_design) evidence.plan.test = evidence.method->name;
}

// Adds ranks; 1 is the best.
void set_ranks(Evidence& evidence, const RankTest& test) {
  for (std::size_t i = 0; i < test.mean_ranks.size(); ++i) evidence.groups[i].mean_rank = test.mean_ranks[i];
}

TestResult anova_of_all(const Groups& groups) {
  const AnovaTable table = groups.values.empty() ? anova_from_summaries(groups.summaries) : anova(groups.values);
  return {table, std::string(anova_name), "F", Role::paper, "omega^2", omega_squared(table)};
}

// Adds the tests of all groups: the paper's analysis, the one of the deciding method, and the rank test.
void add_tests(Evidence& evidence, const Groups& groups) {
  evidence.tests = {anova_of_all(groups)};
  std::vector<const Method*> shown{evidence.method};
  const bool has_rank_test = !groups.values.empty() && evidence.groups.size() > 2 && evidence.blocks == 0;
  if (has_rank_test && evidence.method != &kruskal_wallis_method) shown.push_back(&kruskal_wallis_method);
  for (const Method* method : shown) {
    if (method->all == nullptr) continue;
    std::optional<TestResult> result = method->all(evidence, groups);
    if (!result) continue;
    result->decides = method == evidence.method;
    evidence.tests.push_back(std::move(*result));
  }
}

GroupEvidence describe_group(const Group& group, const AnalysisPlan& plan, bool of_outcomes) {
  GroupEvidence result{
      .name = group.name, .described = describe(group.values), .copies = group.copies, .bits = group.bits};
  if (group.summary) result.described = {.n = group.summary->n, .mean = group.summary->mean, .std = group.summary->std};
  const double level = 1 - plan.significance;
  const Description& of = result.described;
  result.mean = mean_interval({.mean = of.mean, .std = of.std, .n = of.n}, level);
  result.decades = std::isfinite(group.decades) ? group.decades : decades(group.values);
  const std::vector<double> ranked = ranked_values(group.values);
  const QuantileType type{plan.quartiles};
  result.q1 = quantile(ranked, 0.25, type);
  result.q3 = quantile(ranked, 0.75, type);
  if (of_outcomes) {
    result.mean = wilson(successes_of(group.values), level);
  } else {
    result.median = median_interval(ranked, level);
  }
  return result;
}

std::vector<GroupSummary> summaries_of(const Observations& observations) {
  std::vector<GroupSummary> summaries;
  for (const Group& group : observations.groups) summaries.push_back(group.summary.value_or(summarise(group.values)));
  return summaries;
}

Samples values_of(const Observations& observations) {
  Samples values;
  for (const Group& group : observations.groups) values.push_back(group.values);
  return values;
}

// Makes values equal that only rounding keeps apart, across groups too. The rounding of a logarithm is that of its
// number, also near 1.
Observations exact(Observations observations) {
  std::vector<double> all = pooled(values_of(observations));
  if (observations.scale == ValueScale::log10) {
    std::vector<double> sizes;
    for (const double value : all) sizes.push_back(std::abs(value) + 1);
    all = without_rounding(all, sizes);
  } else {
    all = without_rounding(all);
  }
  auto next = all.begin();
  for (Group& group : observations.groups) {
    for (double& value : group.values) value = *next++;
    if (group.summary) group.summary->std = without_rounding(group.summary->std, std::abs(group.summary->mean));
  }
  return observations;
}

// Prepares values for ranking: NaN becomes worse than every number. Without blocks, sorts them once for all rank
// methods.
Samples rankable(const Observations& observations) {
  const double worst = observations.better == Better::smaller ? worse_than_every_number : -worse_than_every_number;
  Samples values = values_of(observations);
  for (std::vector<double>& ranked : values) {
    for (double& value : ranked) value = std::isnan(value) ? worst : value;
    if (observations.blocks.empty()) std::ranges::sort(ranked);
  }
  return values;
}

}  // namespace

bool Evidence::ranks_decide() const { return method != nullptr && method->compares == Compares::ranks; }

bool Evidence::decides_within_blocks() const { return blocks > 0 && method != nullptr && method->within_blocks; }

const TestResult* Evidence::test(std::string_view test_name) const {
  const auto found = std::ranges::find(tests, test_name, &TestResult::test);
  return found == tests.end() ? nullptr : &*found;
}

AnalysisPlan feasible(AnalysisPlan plan, const Observations& observations) {
  if (group_named(observations.groups, plan.control) == nullptr) plan.control.clear();
  if (!observations.are_summaries()) return plan;
  if (plan.test != by_design && results::deciding_test(plan.test).needs != Needs::summaries) plan.test = by_design;
  plan.control.clear();
  return plan;
}

namespace {

// Describes the groups of exact() observations.
Evidence describe_groups(const Observations& observations, const AnalysisPlan& plan) {
  Evidence result;
  result.name = observations.name;
  result.quantity = one_line(observations.quantity);
  result.unit = observations.unit;
  result.better = observations.better;
  result.from_summaries = observations.are_summaries();
  result.margin = std::max(observations.margin, result.unit == "cm" ? plan.margin_cm : 0);
  result.plan = plan;
  result.scale = observations.scale;
  result.replicate = observations.replicate;
  result.block = observations.block;
  result.block_noun = observations.block_noun;
  result.blocks = observations.blocks.size();
  result.notes = observations.counting;
  std::ranges::copy(observations.notes, std::back_inserter(result.notes));
  result.flaws = observations.flaws;
  result.of_outcomes = are_outcomes(observations) &&
                       std::ranges::all_of(observations.groups, [](const Group& group) { return group.copies == 0; });
  if (result.of_outcomes) result.scale = ValueScale::share;
  for (const Group& group : observations.groups)
    result.groups.push_back(describe_group(group, plan, result.of_outcomes));
  check_control(result);
  choose_method(result);
  const std::size_t k = result.groups.size();
  if (k < 2) return result;
  result.pairs = k * (k - 1) / 2;
  result.constant = !result.of_outcomes &&
                    std::ranges::all_of(result.groups, [](const GroupEvidence& g) { return is_constant(g.described); });
  return result;
}

void make_tests(Evidence& result, const Observations& observations) {
  if (result.groups.size() < 2) return;
  const std::vector<GroupSummary> summaries = summaries_of(observations);
  const Samples comparable = rankable(observations);
  Samples ranked = comparable;
  if (result.better == Better::larger) {
    for (std::vector<double>& group : ranked) std::ranges::transform(group, group.begin(), std::negate());
  }
  Groups groups{.summaries = summaries, .values = comparable, .ranked = ranked};
  if (result.from_summaries) groups.values = groups.ranked = {};
  if (!result.of_outcomes && !result.from_summaries) set_ranks(result, kruskal_wallis(ranked));
  if (!result.of_outcomes && !result.constant) add_tests(result, groups);
  add_contrasts(result, groups);
  name_groups(result);
}

Estimate power_of_ten(const Estimate& of) {
  return {.value = std::pow(10, of.value), .low = std::pow(10, of.low), .high = std::pow(10, of.high)};
}

// Converts results for logarithms to the unit of the values.
Evidence in_unit_of_values(Evidence found) {
  if (found.scale != ValueScale::log10) return found;
  for (GroupEvidence& group : found.groups) {
    Description& of = group.described;
    for (double* value : {&of.mean, &of.median, &of.min, &of.max, &group.q1, &group.q3}) *value = std::pow(10, *value);
    for (Estimate* each : {&group.mean, &group.median}) *each = power_of_ten(*each);
  }
  for (Finding& contrast : found.contrasts) {
    contrast.is_ratio = true;
    contrast.estimate = power_of_ten(contrast.estimate);
  }
  return found;
}

// Judges pairs with values that are not finite, which have no mean.
void judge_not_finite(Evidence& evidence, const Observations& observations) {
  if (evidence.method->compares != Compares::means) return;
  const auto family = static_cast<double>(evidence.family());
  AnalysisPlan plan = evidence.plan;
  plan.control.clear();
  plan.significance /= family;
  for (Finding& contrast : evidence.contrasts) {
    const Group &first = observations.groups[contrast.first], &second = observations.groups[contrast.second];
    if (contrast.is_fact || first.copies + second.copies > 0 || count_not_finite(first) + count_not_finite(second) == 0)
      continue;
    Observations pair = observations;
    pair.groups = {first, second};
    const Finding found = contrast_with_not_finite(pair, plan);
    contrast.p = std::min(1.0, family * found.p);
    contrast.p_alone = found.p;
    contrast.ahead = found.ahead;
    contrast.estimate = found.estimate;
    contrast.relation = found.relation;
    contrast.size = found.size;
    contrast.margin = found.margin;
    contrast.why = found.why;
  }
}

}  // namespace

Evidence evidence(const Observations& given, const AnalysisPlan& plan) {
  const Observations observations = exact(given);
  Evidence result = describe_groups(observations, plan);
  make_tests(result, observations);
  result = in_unit_of_values(std::move(result));
  if (!result.contrasts.empty()) judge_not_finite(result, observations);
  return result;
}

Evidence described(const Observations& observations, const AnalysisPlan& plan) {
  return in_unit_of_values(describe_groups(exact(observations), plan));
}

}  // namespace ikbench::inference
