#include "analysis/inference/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/inference/deciding.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench::inference {

using namespace results;
using namespace statistics;

namespace {

// Index of a group; the number of groups if it is missing.
std::size_t place_of(const Evidence& evidence, std::string_view group) {
  return static_cast<std::size_t>(std::ranges::find(evidence.groups, group, &GroupEvidence::name) -
                                  evidence.groups.begin());
}

// Swaps first and second.
Judgement turned(Judgement judgement, ValueScale scale) {
  judgement.relation = reversed(judgement.relation);
  const auto of = [scale](double difference) { return scale == ValueScale::log10 ? 1 / difference : -difference; };
  const Estimate before = judgement.difference;
  judgement.difference = {.value = of(before.value), .low = of(before.high), .high = of(before.low)};
  return judgement;
}

}  // namespace

Relation relation_of(const Tested& tested, double significance) {
  if (tested.p_worse < significance) return Relation::worse;
  if (tested.p_better < significance) return Relation::better;
  return tested.within_margin ? Relation::same : Relation::undecided;
}

Judgement judge(const Evidence& evidence, std::string_view first, std::string_view second) {
  const std::size_t one = place_of(evidence, first), other = place_of(evidence, second);
  Judgement result{.test = std::string(pair_test_words(evidence))};
  for (const auto& [place, name] : {std::pair(one, first), std::pair(other, second)}) {
    if (place < evidence.groups.size()) continue;
    result.undefined = fmt::format("{} is left out of the comparison", name);
    return result;
  }
  // Contrasts have the smaller index first.
  const auto found = std::ranges::find_if(evidence.contrasts, [&](const Contrast& contrast) {
    return contrast.first == std::min(one, other) && contrast.second == std::max(one, other);
  });
  if (!evidence.flaws.empty()) {
    result.undefined = words_of(evidence.flaws);
  } else if (found == evidence.contrasts.end()) {
    result.undefined = "the plan does not compare the two";
  } else {
    result.relation = found->relation;
    result.p = found->p;
    result.difference = found->difference;
    result.is_fact = found->is_fact;
    result.undefined = found->undefined;
    if (one > other) return turned(std::move(result), evidence.scale);
  }
  return result;
}

Judgement judge(const MeanPair& means, const AnalysisPlan& plan) {
  const Summaries two{.better = means.better, .groups = {{"first", means.first}, {"second", means.second}}};
  return judge(evidence(two, feasible(plan, two)), "first", "second");
}

Judgement judge(double value, double standard_error, const AnalysisPlan& plan) {
  const double p = normal_two_sided(value / standard_error);
  const double reach = normal_critical(1 - plan.significance) * standard_error;
  const Tested tested{.p_better = value > 0 ? p : 1, .p_worse = value > 0 ? 1 : p};
  return {.relation = std::isfinite(p) ? relation_of(tested, plan.significance) : Relation::undecided,
          .p = p,
          .difference = {.value = value, .low = value - reach, .high = value + reach},
          .test = "a normal approximation",
          .undefined = std::isfinite(p) ? "" : "the number or its standard error is not defined"};
}

bool is_significant(double p, const AnalysisPlan& plan) { return p < plan.significance; }

}  // namespace ikbench::inference
