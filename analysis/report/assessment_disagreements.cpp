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

// For whom of a pair a method is, as Contrast::ahead.
int favoured(const Evidence& evidence, const Contrast& contrast, double Contrast::*p) {
  const GroupEvidence &first = evidence.groups[contrast.first], &second = evidence.groups[contrast.second];
  if (p == &Contrast::p_ranks || p == &Contrast::p_mann_whitney || p == &Contrast::p_brunner_munzel) {
    return contrast.ahead_by_ranks;
  }
  if (p == &Contrast::p_nemenyi || (p == &Contrast::p_mean_ranks && evidence.ranks_within_blocks())) {
    return statistics::sign_of(second.average_rank - first.average_rank);
  }
  if (p == &Contrast::p_mean_ranks) return statistics::sign_of(second.mean_rank - first.mean_rank);
  const int of_smaller = statistics::sign_of(second.described.mean - first.described.mean);
  return evidence.better == Better::smaller ? of_smaller : -of_smaller;
}

// Pairs that a method separates and the deciding one does not, the reverse, and those of which each finds another
// better.
struct Dispute {
  bool made = false;  // some pair has both p-values
  std::vector<const Contrast*> only_here, only_there, opposite;
};

Dispute dispute(const Evidence& evidence, const PairMethod& method) {
  Dispute result;
  for (const Contrast& contrast : evidence.contrasts) {
    const double p = contrast.*method.p;
    if (!std::isfinite(p) || !std::isfinite(contrast.p)) continue;
    result.made = true;
    const bool here = is_significant(p, evidence.plan), there = is_significant(contrast.p, evidence.plan);
    if (here && !there) result.only_here.push_back(&contrast);
    if (!here && there) result.only_there.push_back(&contrast);
    if (here && there && favoured(evidence, contrast, method.p) == -contrast.ahead && contrast.ahead != 0) {
      result.opposite.push_back(&contrast);
    }
  }
  return result;
}

// Whether there was any.
bool add_dispute(std::vector<std::string>& parts, const Evidence& evidence, const PairMethod& method,
                 const Dispute& found) {
  const auto add = [&](std::string_view finds, const std::vector<const Contrast*>& pairs) {
    std::vector<std::string> names;
    for (const Contrast* pair : pairs) {
      names.push_back(
          fmt::format("{} ({}, deciding {})", pair_words(evidence, *pair), p_words(pair->*method.p), p_words(pair->p)));
    }
    if (!names.empty()) parts.push_back(fmt::format("{} ({}) {} {}", method.name, method.note, finds, clauses(names)));
    return !names.empty();
  };
  const bool more = add("also separates", found.only_here), fewer = add("does not separate", found.only_there),
             other = add("finds the other one better of", found.opposite);
  return more || fewer || other;
}

// "Welch's ANOVA (p = 0.98) and Kruskal-Wallis test (p = 0.92) find none"
std::string find_words(const std::vector<std::string>& tests, bool is_difference) {
  return fmt::format("{} {} {}", listed(tests), tests.size() == 1 ? "finds" : "find",
                     is_difference ? "a difference" : "none");
}

// The tests of all groups against the one that goes with the pairs, and that one against the pairs, where all are
// there. Where none goes with them, all tests against the pairs.
void add_tests_of_all(const Evidence& evidence, std::vector<std::string>& parts) {
  const TestResult* together = deciding_test(evidence);
  const bool is_there = together != nullptr && std::isfinite(together->p);
  const bool some_pair = std::ranges::any_of(evidence.contrasts, is_decided);
  const bool all_differ = is_there ? is_significant(together->p, evidence.plan) : some_pair;
  const bool has_all_pairs = !evidence.reference && evidence.pairs > 1 &&
                             std::ranges::any_of(evidence.contrasts, [](const Contrast& contrast) {
                               return contrast.relation != Relation::undefined;
                             });
  std::vector<std::string> others;
  for (const TestResult& test : evidence.tests) {
    if (test.role == Role::assumption || !std::isfinite(test.p)) continue;
    if (is_significant(test.p, evidence.plan) == all_differ) continue;
    others.push_back(fmt::format("{} ({})", test.test, p_words(test.p)));
  }
  if (!others.empty() && is_there) {
    parts.push_back(fmt::format("Of all groups together, {} {} a difference ({}), but {}", together->test,
                                all_differ ? "finds" : "does not find", p_words(together->p),
                                find_words(others, !all_differ)));
  } else if (!others.empty() && has_all_pairs) {
    parts.push_back(fmt::format("{}, but of all groups together {}",
                                some_pair ? "Pairs differ" : "No pair differs on its own",
                                find_words(others, !all_differ)));
  }
  if (!is_there || !has_all_pairs || all_differ == some_pair) return;
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
    const bool differs = add_dispute(parts, evidence, method, found);
    pooling_disagrees = pooling_disagrees || (differs && method.p == &Contrast::p_pooled && evidence.blocks == 0);
    comparable = comparable || found.made;
  }
  add_tests_of_all(evidence, parts);
  if (!comparable && parts.empty()) return "";
  if (parts.empty()) return "Where methods disagree: nowhere; all methods give the same verdicts.";
  std::string text = fmt::format("Where methods disagree: {}.", fmt::join(parts, ". "));
  if (pooling_disagrees && pooling_misleads(evidence)) {
    const std::string least = name_words(evidence, evidence.least_variable);
    text += fmt::format(
        " {} dominates Tukey's pooled variance: {}. With variances this unequal, do not trust Tukey's test.",
        name_words(evidence, evidence.most_variable),
        evidence.groups[evidence.least_variable].described.std == 0
            ? fmt::format("{} has no variance", least)
            : fmt::format("its variance is {} times that of {}",
                          std::isfinite(evidence.variance_ratio) ? rounded_number(evidence.variance_ratio, 3)
                                                                 : "more than 1e308",
                          least));
  }
  return text;
}

}  // namespace ikbench::report
