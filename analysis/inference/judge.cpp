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

Finding judge(double value, double standard_error, const AnalysisPlan& plan) {
  const double p = normal_two_sided(value / standard_error);
  const double reach = normal_critical(1 - plan.significance) * standard_error;
  return {.estimate = {.value = value, .low = value - reach, .high = value + reach},
          .p = p,
          .method = "a normal approximation",
          .relation = relation_of(value > 0 ? 1 : -1, p, plan.significance),
          .why = std::isfinite(p) ? "" : "the number or its standard error is not defined"};
}

bool is_significant(double p, const AnalysisPlan& plan) { return p < plan.significance; }

}  // namespace ikbench::inference
