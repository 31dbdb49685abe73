#include "analysis/inference/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

// Index of a group; the number of groups if it is missing.
std::size_t place_of(const Evidence& evidence, std::string_view group) {
  return static_cast<std::size_t>(std::ranges::find(evidence.groups, group, &GroupEvidence::name) -
                                  evidence.groups.begin());
}

}  // namespace

Relation relation_of(int ahead, double p, double significance, bool is_within_margin) {
  if (p < significance) return ahead > 0 ? Relation::better : Relation::worse;
  return is_within_margin ? Relation::same : Relation::undecided;
}

Finding judge(const Evidence& evidence, std::string_view first, std::string_view second) {
  const std::size_t one = place_of(evidence, first), other = place_of(evidence, second);
  const auto not_judged = [&](std::string why) {
    return Finding{.first = one, .second = other, .why = std::move(why)};
  };
  for (const auto& [place, name] : {std::pair(one, first), std::pair(other, second)}) {
    if (place == evidence.groups.size()) return not_judged(fmt::format("{} is left out of the comparison", name));
  }
  if (!evidence.flaws.empty()) return not_judged(words_of(evidence.flaws));
  return finding_of(evidence.contrasts, one, other).value_or(not_judged("the plan does not compare the two"));
}

Finding judge(const GroupSummary& first, const GroupSummary& second, Better better, const AnalysisPlan& plan) {
  const Observations two{.better = better,
                         .groups = {{.name = "first", .summary = first}, {.name = "second", .summary = second}}};
  return judge(evidence(two, feasible(plan, two)), "first", "second");
}

std::string_view deciding_words(const Evidence& evidence) {
  const bool is_pair = evidence.groups.size() == 2 && evidence.method->compares != Compares::means;
  return is_pair ? evidence.method->of_two : evidence.method->title;
}

std::string_view pair_test_words(const Evidence& evidence) {
  return evidence.groups.size() == 2 ? evidence.method->of_two : evidence.method->of_pair;
}

std::string_view test_of_constants_words(const Evidence& evidence) {
  return evidence.blocks > 0 ? "the sign test within blocks" : "Fisher's exact test";
}

const TestResult* deciding_test(const Evidence& evidence) {
  const auto found = std::ranges::find(evidence.tests, true, &TestResult::decides);
  return found == evidence.tests.end() ? nullptr : &*found;
}

double group_score(const Evidence& evidence, const GroupEvidence& group) {
  const double rank = evidence.ranks_decide() ? group.mean_rank : not_defined;
  if (std::isfinite(rank)) return rank;
  const double mean = evidence.better == Better::smaller ? group.described.mean : -group.described.mean;
  return std::isfinite(mean) ? mean : std::numeric_limits<double>::infinity();
}

std::size_t best_group(const Evidence& evidence) {
  const auto& groups = evidence.groups;
  if (evidence.contrasts.size() == 1 && evidence.contrasts[0].ahead != 0) {
    return evidence.contrasts[0].ahead > 0 ? evidence.contrasts[0].first : evidence.contrasts[0].second;
  }
  const auto worth = [&](const GroupEvidence& group) { return group_score(evidence, group); };
  return static_cast<std::size_t>(std::ranges::min_element(groups, {}, worth) - groups.begin());
}

}  // namespace ikbench::inference
