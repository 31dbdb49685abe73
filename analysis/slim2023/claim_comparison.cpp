#include "analysis/slim2023/claim_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/inference/text.hpp"
#include "analysis/slim2023/published_numbers.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

std::vector<Pair> pairs(const StudyResults& study, const std::vector<Comparison>& rows, Metric metric) {
  std::vector<Pair> result;
  for (const Comparison& row : rows) {
    const std::optional<PrintedRow> printed = printed_row(study, row.solver, metric);
    if (row.metric != metric || !printed || row.ours.n == 0) continue;
    result.push_back({row.solver, row.ours, printed->summary});
  }
  std::ranges::stable_sort(result, {}, [](const Pair& pair) { return pair.printed.mean; });
  return result;
}

std::optional<Description> description(const StudyResults& study, std::string_view solver, Metric metric) {
  for (const Sample& sample : samples(study, metric)) {
    if (sample.solver == solver && !sample.values.empty()) return describe(sample.values);
  }
  return std::nullopt;
}

Smaller smaller(const Judgement& found) {
  return {found.answer == Answer::better  ? Verdict::holds
          : found.answer == Answer::worse ? Verdict::fails
                                          : Verdict::undecided,
          found.p};
}

Evidence printed_evidence(const std::vector<Pair>& pairs, const AnalysisPlan& plan) {
  Summaries printed;
  for (const Pair& pair : pairs) printed.groups.push_back({pair.solver, pair.printed});
  return evidence(printed, feasible(plan, printed));
}

void weaken(Smaller& claim, const Smaller& by) {
  claim.verdict = std::max(claim.verdict, by.verdict);
  if (std::isfinite(by.p)) claim.p = std::isfinite(claim.p) ? std::max(claim.p, by.p) : by.p;
}

std::string in_brackets(double p) { return std::isfinite(p) ? fmt::format(" (p = {})", rounded_number(p, 3)) : ""; }

std::string at_most(double p) {
  return std::isfinite(p) ? fmt::format(" (p at most {} against each other solver)", rounded_number(p, 2)) : "";
}

std::string how_tested(const Evidence& here, const Evidence& printed) {
  const std::string_view test = pair_test_words(here), other = pair_test_words(printed);
  if (here.plan.unit == Unit::point)
    return fmt::format(" No test here, because points of one run depend on each other; printed p-values: {}.", other);
  const std::string of_printed = test == other ? "" : fmt::format("; printed: {}", other);
  return fmt::format(" p-values: {} on run means, adjusted for all pairs{}.", test, of_printed);
}

}  // namespace ikbench::slim2023
