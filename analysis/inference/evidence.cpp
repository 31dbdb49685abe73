#include "analysis/inference/evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "analysis/inference/contrasts.hpp"
#include "analysis/inference/margin.hpp"
#include "analysis/inference/outcomes.hpp"
#include "analysis/inference/test_results.hpp"
#include "analysis/inference/tests_of_means.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/statistics/anova.hpp"
#include "analysis/statistics/equal_variances.hpp"
#include "analysis/statistics/kruskal_wallis.hpp"
#include "analysis/statistics/median_interval.hpp"
#include "analysis/statistics/quantile.hpp"
#include "analysis/statistics/ranks.hpp"
#include "analysis/statistics/rounding.hpp"
#include "analysis/statistics/shapiro_wilk.hpp"
#include "analysis/statistics/studentized_bootstrap.hpp"
#include "analysis/statistics/welch.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

using Samples = std::vector<std::vector<double>>;

// The methods count groups from 1, "group 2 is constant"; a reader knows them by name.
std::string with_name(std::string reason, const std::vector<GroupEvidence>& groups) {
  constexpr std::string_view word = "group ";
  const std::size_t start = reason.find(word);
  if (start == std::string::npos) return reason;
  const char* const digits = reason.data() + start + word.size();
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(digits, reason.data() + reason.size(), number);
  if (error != std::errc{} || number < 1 || number > groups.size()) return reason;
  const std::size_t length = word.size() + static_cast<std::size_t>(end - digits);
  return reason.replace(start, length, row_label(groups[number - 1].name, longest_group_name));
}

void name_groups(Evidence& evidence) {
  for (TestResult& test : evidence.tests) test.undefined = with_name(std::move(test.undefined), evidence.groups);
  for (Contrast& contrast : evidence.contrasts) {
    contrast.undefined = with_name(std::move(contrast.undefined), evidence.groups);
  }
}

void check_control(const Evidence& evidence) {
  if (evidence.plan.control.empty()) return;
  const auto found = std::ranges::find(evidence.groups, evidence.plan.control, &GroupEvidence::name);
  if (found != evidence.groups.end()) return;
  std::vector<std::string> names;
  for (const GroupEvidence& group : evidence.groups) names.push_back(group.name);
  throw std::invalid_argument(
      fmt::format("no group '{}' for the control; expected one of: {}", evidence.plan.control, fmt::join(names, ", ")));
}

// Before the data are looked at: what by_design means for them, and what they do not have.
void settle_test(Evidence& evidence) {
  DecidingTest& test = evidence.plan.test;
  if (test == DecidingTest::by_design) {
    test = evidence.from_summaries ? DecidingTest::tamhane : DecidingTest::bootstrap;
  }
  if (test == DecidingTest::friedman && evidence.blocks == 0) {
    throw std::invalid_argument(
        "Friedman's test needs blocks, which all groups share; expected another test, or a block column");
  }
  if (evidence.from_summaries && (test == DecidingTest::kruskal_wallis || test == DecidingTest::bootstrap)) {
    throw std::invalid_argument(
        fmt::format("the {} needs single values; expected anova, welch or tamhane for summaries",
                    test == DecidingTest::bootstrap ? "bootstrap" : "Kruskal-Wallis test"));
  }
  if (test == DecidingTest::bootstrap && evidence.blocks == 0 && resamples_of(evidence) == 0) {
    test = DecidingTest::tamhane;
  }
}

// Greatest and least variance of those that are known.
void compare_variances(Evidence& evidence, std::span<const GroupSummary> summaries) {
  std::optional<std::size_t> most, least;
  for (std::size_t i = 0; i < summaries.size(); ++i) {
    if (summaries[i].n < 2 || !std::isfinite(summaries[i].std)) continue;
    if (!most || summaries[i].std > summaries[*most].std) most = i;
    if (!least || summaries[i].std < summaries[*least].std) least = i;
  }
  if (!most || most == least) return;
  evidence.most_variable = *most;
  evidence.least_variable = *least;
  const double ratio = summaries[*most].std / summaries[*least].std;
  evidence.variance_ratio = ratio * ratio;
}

// Of observations or summaries.
template <class Given>
Evidence begin(const Given& given, const AnalysisPlan& plan) {
  Evidence evidence;
  evidence.name = given.name;
  evidence.quantity = one_line(given.quantity);
  evidence.better = given.better;
  evidence.margin = std::max(given.margin, is_in_cm(evidence.quantity) ? plan.margin_cm : 0);
  evidence.plan = plan;
  return evidence;
}

Estimate interval_of(const GroupSummary& summary, double level) {
  const MeanInterval found = mean_interval(summary, level);
  return {.value = summary.mean, .low = found.low, .high = found.high};
}

// Not for so many values that the mean is normal anyway.
bool bootstraps_means(const Evidence& evidence) {
  constexpr int most_values = 2000;  // of all groups: about a second
  int all = 0;
  for (const GroupEvidence& group : evidence.groups) all += group.described.n;
  return all <= most_values && !evidence.of_outcomes;
}

// It follows the skewness of the values.
void bootstrap_means(Evidence& evidence, const Samples& values) {
  constexpr std::size_t fewest_values = 5;  // fewer have too few resamples that differ
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i].size() < fewest_values) continue;
    const MeanInterval found = studentized_interval(values[i], {.level = 1 - evidence.plan.significance});
    evidence.groups[i].bootstrapped = {
        .value = evidence.groups[i].described.mean, .low = found.low, .high = found.high};
  }
}

void add_mean_ranks(Evidence& evidence, const KruskalWallis& test) {
  double values = 0;
  for (const GroupEvidence& group : evidence.groups) values += group.described.n;
  for (std::size_t i = 0; i < test.mean_ranks.size(); ++i) {
    const double rank = test.mean_ranks[i];  // 1 is the smallest value
    evidence.groups[i].mean_rank = evidence.better == Better::smaller ? rank : values + 1 - rank;
  }
}

GroupEvidence describe_group(const Group& group, const AnalysisPlan& plan) {
  GroupEvidence result{.name = group.name, .described = describe(group.values)};
  const double level = 1 - plan.significance;
  const Description& of = result.described;
  result.mean = interval_of({.mean = of.mean, .std = of.std, .n = of.n}, level);
  const std::vector<double> ranked = ranked_values(group.values);
  const QuantileType type = quantile_type(plan.quartiles);
  const double q1 = quantile(ranked, 0.25, type), q3 = quantile(ranked, 0.75, type);
  result.q1 = q1;
  result.q3 = q3;
  const MedianInterval median = median_interval(ranked, level);
  result.median = {.value = of.median, .low = median.low, .high = median.high};
  return result;
}

// What rounding alone keeps apart is equal, also from group to group.
Observations exact(Observations observations) {
  Samples values;
  for (const Group& group : observations.groups) values.push_back(group.values);
  const std::vector<double> all = without_rounding(pooled(values));
  auto next = all.begin();
  for (Group& group : observations.groups) {
    for (double& value : group.values) value = *next++;
  }
  return observations;
}

// Values that rank: what is not a number is worse than every number. Where no blocks fix their order they are sorted,
// once for all that rank them.
Samples rankable(const Observations& observations) {
  const double worst = observations.better == Better::smaller ? worse_than_every_number : -worse_than_every_number;
  Samples values;
  for (const Group& group : observations.groups) {
    std::vector<double>& ranked = values.emplace_back(group.values);
    for (double& value : ranked) value = std::isnan(value) ? worst : value;
    if (observations.blocks.empty()) std::ranges::sort(ranked);
  }
  return values;
}

}  // namespace

std::string_view name_of(Relation relation) {
  constexpr std::array<std::string_view, 5> names{"first is better", "second is better", "same within the margin",
                                                  "undecided", "not defined"};
  return names[static_cast<std::size_t>(relation)];
}

std::string_view name_of(Extent extent) {
  constexpr std::array<std::string_view, 4> names{"unknown", "within the margin", "on both sides of the margin",
                                                  "beyond the margin"};
  return names[static_cast<std::size_t>(extent)];
}

const TestResult* Evidence::test(std::string_view test_name) const {
  const auto found = std::ranges::find(tests, test_name, &TestResult::test);
  return found == tests.end() ? nullptr : &*found;
}

Evidence evidence(const Summaries& summaries, const AnalysisPlan& plan) {
  Evidence result = begin(summaries, plan);
  result.from_summaries = true;
  result.notes = summaries.notes;
  std::vector<GroupSummary> numbers;
  for (const SummaryGroup& group : summaries.groups) {
    GroupSummary& summary = numbers.emplace_back(group.summary);
    summary.std = without_rounding(summary.std, std::abs(summary.mean));
    result.groups.push_back({.name = group.name,
                             .described = {.n = summary.n, .mean = summary.mean, .std = summary.std},
                             .mean = interval_of(summary, 1 - plan.significance)});
  }
  check_control(result);
  settle_test(result);
  if (result.groups.size() < 2) return result;
  compare_variances(result, numbers);
  result.tests = {of_bartlett(bartlett_from_summaries(numbers)), of_anova(anova_from_summaries(numbers)),
                  of_welch(result.groups, numbers)};
  add_contrasts(result, numbers, {});
  name_groups(result);
  return result;
}

AnalysisPlan feasible(AnalysisPlan plan, const Observations& observations) {
  if (plan.test == DecidingTest::friedman && observations.blocks.empty()) plan.test = DecidingTest::by_design;
  return plan;
}

AnalysisPlan feasible(AnalysisPlan plan, const Summaries&) {
  if (plan.test != DecidingTest::anova && plan.test != DecidingTest::welch) plan.test = DecidingTest::tamhane;
  plan.control.clear();
  return plan;
}

namespace {

Samples values_of(const Observations& observations) {
  Samples values;
  for (const Group& group : observations.groups) values.push_back(group.values);
  return values;
}

// Of exact observations.
Evidence describe_groups(const Observations& observations, const AnalysisPlan& plan) {
  Evidence result = begin(observations, plan);
  result.scale = observations.scale;
  result.replicate = observations.replicate;
  result.block = observations.block;
  result.block_noun = observations.block_noun;
  result.blocks = observations.blocks.size();
  result.notes = observations.notes;
  result.flaw = observations.flaw;
  result.of_outcomes = are_outcomes(observations);
  std::vector<GroupSummary> summaries;
  for (const Group& group : observations.groups) {
    GroupEvidence& described = result.groups.emplace_back(describe_group(group, plan));
    described.decades = std::isfinite(group.decades) ? group.decades : decades(group.values);
    summaries.push_back(summarise(group.values));
  }
  check_control(result);
  settle_test(result);
  const std::size_t k = result.groups.size();
  if (k < 2) return result;
  result.pairs = k * (k - 1) / 2;
  result.constant = !result.of_outcomes &&
                    std::ranges::all_of(result.groups, [](const GroupEvidence& g) { return is_constant(g.described); });
  if (!result.constant) compare_variances(result, summaries);
  return result;
}

void make_tests(Evidence& result, const Observations& observations) {
  const Samples values = values_of(observations);
  if (result.of_outcomes) return compare_outcomes(result, values);
  std::vector<GroupSummary> summaries;
  for (std::size_t i = 0; i < values.size(); ++i) {
    summaries.push_back(summarise(values[i]));
    const ShapiroWilk normal = shapiro_wilk(values[i]);
    result.groups[i].normality = normal.p;
    result.groups[i].normality_w = normal.W;
  }
  if (result.groups.size() < 2) return;
  const Samples ranks = rankable(observations);
  const KruskalWallis by_ranks = kruskal_wallis(ranks);
  add_mean_ranks(result, by_ranks);
  if (!result.constant) {
    result.tests = {of_brown_forsythe(brown_forsythe(values)), of_bartlett(bartlett(values)), of_anova(anova(values)),
                    of_welch(result.groups, summaries), of_kruskal_wallis(by_ranks)};
    if (ranks.size() == 2) result.tests.push_back(of_two(ranks[0], ranks[1], result));
  }
  if (result.blocks > 0 && !result.constant) add_friedman(result, ranks);
  add_contrasts(result, summaries, ranks);
  name_groups(result);
}

Estimate power_of_ten(const Estimate& of) {
  return {.value = std::pow(10, of.value), .low = std::pow(10, of.low), .high = std::pow(10, of.high)};
}

// What was found of logarithms, in the unit of the values.
Evidence told(Evidence found) {
  if (found.scale == ValueScale::plain) return found;
  for (GroupEvidence& group : found.groups) {
    Description& of = group.described;
    for (double* value : {&of.mean, &of.median, &of.min, &of.max, &group.q1, &group.q3}) *value = std::pow(10, *value);
    for (Estimate* each : {&group.mean, &group.median}) *each = power_of_ten(*each);
  }
  for (Contrast& contrast : found.contrasts) {
    for (Estimate* each : {&contrast.difference, &contrast.shift}) *each = power_of_ten(*each);
  }
  return found;
}

}  // namespace

Evidence evidence(const Observations& observations, const AnalysisPlan& plan) {
  return with_bootstrap(tested(observations, plan), observations);
}

Evidence tested(const Observations& given, const AnalysisPlan& plan) {
  const Observations observations = exact(given);
  Evidence result = describe_groups(observations, plan);
  make_tests(result, observations);
  return told(std::move(result));
}

Evidence with_bootstrap(Evidence evidence, const Observations& observations) {
  if (!bootstraps_means(evidence)) return evidence;
  bootstrap_means(evidence, values_of(exact(observations)));
  if (evidence.scale == ValueScale::log10) {
    for (GroupEvidence& group : evidence.groups) group.bootstrapped = power_of_ten(group.bootstrapped);
  }
  return evidence;
}

Evidence described(const Observations& observations, const AnalysisPlan& plan) {
  return told(describe_groups(exact(observations), plan));
}

}  // namespace ikbench::inference
