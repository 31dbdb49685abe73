#include "analysis/report/assessment_disagreements.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/inference/contrasts.hpp"
#include "analysis/inference/deciding.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"

namespace ikbench::report {

using namespace inference;

namespace {

// Pairs that a method separates and the deciding one does not, and the reverse.
struct Dispute {
  bool made = false;  // some pair has both p-values
  std::vector<const Contrast*> only_here, only_there;
};

Dispute dispute(const Evidence& evidence, const PairMethod& method) {
  Dispute result;
  for (const Contrast& contrast : evidence.contrasts) {
    const double p = contrast.*method.p;
    if (!std::isfinite(p) || !std::isfinite(contrast.p)) continue;
    result.made = true;
    if (is_significant(p, evidence.plan) == is_significant(contrast.p, evidence.plan)) continue;
    (is_significant(p, evidence.plan) ? result.only_here : result.only_there).push_back(&contrast);
  }
  return result;
}

// With both p-values, unless there are so many that the table tells them better.
std::string disputed_words(const Evidence& evidence, const PairMethod& method,
                           const std::vector<const Contrast*>& pairs) {
  constexpr std::size_t most_with_p = 3;
  std::vector<std::string> names;
  for (const Contrast* pair : pairs) {
    names.push_back(pair_words(evidence, *pair));
    if (pairs.size() > most_with_p) continue;
    names.back() += fmt::format(" ({}, deciding {})", p_words(pair->*method.p), p_words(pair->p));
  }
  return clauses(names);
}

void add_dispute(std::vector<std::string>& parts, const Evidence& evidence, const PairMethod& method,
                 const Dispute& found) {
  const std::string name = fmt::format("{} ({})", method.name, method.note);
  if (!found.only_here.empty()) {
    parts.push_back(fmt::format("{} also separates {}", name, disputed_words(evidence, method, found.only_here)));
  }
  if (!found.only_there.empty()) {
    parts.push_back(fmt::format("{} does not separate {}", name, disputed_words(evidence, method, found.only_there)));
  }
}

// The tests of all groups against the one that goes with the pairs, and that one against the pairs, where all are
// there.
void add_tests_of_all(const Evidence& evidence, std::vector<std::string>& parts) {
  const TestResult* together = deciding_test(evidence);
  if (together == nullptr || !std::isfinite(together->p)) return;
  const bool all_differ = is_significant(together->p, evidence.plan);
  std::vector<std::string> others;
  for (const TestResult& test : evidence.tests) {
    if (test.role == Role::assumption || !std::isfinite(test.p)) continue;
    if (is_significant(test.p, evidence.plan) == all_differ) continue;
    others.push_back(fmt::format("{} ({})", test.test, p_words(test.p)));
  }
  if (!others.empty()) {
    parts.push_back(fmt::format("Of all groups together, {} {} a difference ({}), but {} {}", together->test,
                                all_differ ? "finds" : "does not find", p_words(together->p), listed(others),
                                !all_differ          ? (others.size() == 1 ? "does" : "do")
                                : others.size() == 1 ? "does not"
                                                     : "do not"));
  }
  if (evidence.reference || evidence.pairs == 1) return;
  const bool some_pair = std::ranges::any_of(evidence.contrasts, is_decided);
  if (all_differ == some_pair) return;
  parts.push_back(
      all_differ
          ? fmt::format("The test of all groups finds a difference ({}), but no pair differs on its own",
                        p_words(together->p))
          : fmt::format("Pairs differ, but the test of all groups finds no difference ({})", p_words(together->p)));
}

}  // namespace

std::string disagreements(const Evidence& evidence) {
  std::vector<std::string> parts;
  bool comparable = false, pooling_disagrees = false;
  for (const PairMethod& method : pair_methods(evidence)) {
    const Dispute found = dispute(evidence, method);
    add_dispute(parts, evidence, method, found);
    const bool differs = !found.only_here.empty() || !found.only_there.empty();
    pooling_disagrees = pooling_disagrees || (differs && method.p == &Contrast::p_pooled && evidence.blocks == 0);
    comparable = comparable || found.made;
  }
  if (!comparable) return "";
  add_tests_of_all(evidence, parts);
  if (parts.empty()) return "Where methods disagree: nowhere; all methods give the same verdicts.";
  std::string text = fmt::format("Where methods disagree: {}.", fmt::join(parts, ". "));
  if (pooling_disagrees && pooling_misleads(evidence)) {
    const std::string least = name_words(evidence, evidence.least_variable);
    text += fmt::format(
        " {} dominates Tukey's pooled variance: {}. With variances this unequal, do not trust Tukey's test.",
        name_words(evidence, evidence.most_variable),
        std::isfinite(evidence.variance_ratio)
            ? fmt::format("its variance is {} times that of {}", rounded_number(evidence.variance_ratio, 3), least)
            : fmt::format("{} has no variance", least));
  }
  return text;
}

}  // namespace ikbench::report
