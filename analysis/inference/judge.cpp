#include "analysis/inference/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/inference/method.hpp"

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
  // Contrasts have the smaller index first.
  if (one > other) return reversed(judge(evidence, second, first));
  Finding result{.quantity = evidence.quantity,
                 .first = std::string(first),
                 .second = std::string(second),
                 .is_ratio = evidence.scale == ValueScale::log10,
                 .method = std::string(pair_test_words(evidence))};
  for (const auto& [place, name] : {std::pair(one, first), std::pair(other, second)}) {
    if (place < evidence.groups.size()) continue;
    result.why = fmt::format("{} is left out of the comparison", name);
    return result;
  }
  const auto found = std::ranges::find_if(
      evidence.contrasts, [&](const Contrast& contrast) { return contrast.first == one && contrast.second == other; });
  if (!evidence.flaws.empty()) {
    result.why = words_of(evidence.flaws);
  } else if (found == evidence.contrasts.end()) {
    result.why = "the plan does not compare the two";
  } else {
    result.relation = found->relation;
    result.p = found->p;
    result.estimate = found->difference;
    result.is_fact = found->is_fact;
    result.why = found->undefined;
  }
  return result;
}

Finding judge(const GroupSummary& first, const GroupSummary& second, Better better, const AnalysisPlan& plan) {
  const Summaries two{.better = better, .groups = {{"first", first}, {"second", second}}};
  return judge(evidence(two, feasible(plan, two)), "first", "second");
}

bool is_significant(double p, const AnalysisPlan& plan) { return p < plan.significance; }

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
  const double rank = !evidence.ranks_decide()           ? not_defined
                      : evidence.decides_within_blocks() ? group.average_rank
                                                         : group.mean_rank;
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
