#include "analysis/report/assessment_disagreements.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "analysis/inference/judge.hpp"
#include "analysis/inference/method.hpp"
#include "analysis/report/assessment_words.hpp"

namespace ikbench::report {

using namespace inference;

namespace {

// Pairs that only the rank test separates, that only the deciding test separates, and that they decide in opposite
// directions.
struct Dispute {
  std::vector<std::string> only_ranks, only_means, opposite;
};

Dispute dispute(const Evidence& evidence) {
  Dispute result;
  for (const Finding& contrast : evidence.contrasts) {
    if (!std::isfinite(contrast.p_ranks) || !std::isfinite(contrast.p)) continue;
    const bool by_ranks = contrast.p_ranks < evidence.plan.significance, by_means = is_decided(contrast);
    const std::string words = fmt::format("{} ({}, deciding {})", pair_words(evidence, contrast),
                                          p_words(contrast.p_ranks), p_words(contrast.p));
    if (by_ranks && !by_means) result.only_ranks.push_back(words);
    if (!by_ranks && by_means) result.only_means.push_back(words);
    if (by_ranks && by_means && contrast.ahead_by_ranks == -contrast.ahead) result.opposite.push_back(words);
  }
  return result;
}

// "One-way ANOVA finds no difference of all groups (p = 0.98)", if a pair does differ.
std::string dispute_of_all(const Evidence& evidence) {
  const bool some_pair = std::ranges::any_of(evidence.contrasts, is_decided);
  std::vector<std::string> others;
  for (const TestResult& test : evidence.tests) {
    if (test.role == Role::assumption || !std::isfinite(test.p)) continue;
    if (evidence.blocks > 0 && test.role == Role::paper && !test.decides) continue;  // it does not use the blocks
    if ((test.p < evidence.plan.significance) != some_pair)
      others.push_back(fmt::format("{} ({})", test.test, p_words(test.p)));
  }
  if (others.empty() || evidence.reference) return "";
  return fmt::format("of all groups together {} {} {}", listed(others), others.size() == 1 ? "finds" : "find",
                     some_pair ? "no difference" : "a difference");
}

}  // namespace

Sentence disagreements(const Evidence& evidence) {
  const Dispute found = dispute(evidence);
  std::vector<std::string> parts;
  const auto add = [&](std::string_view finds, const std::vector<std::string>& pairs) {
    if (!pairs.empty()) parts.push_back(fmt::format("ranks {} {}", finds, clauses(pairs)));
  };
  add("also separate", found.only_ranks);
  add("do not separate", found.only_means);
  add("favour the other one in", found.opposite);
  const std::string ranks = parts.empty() ? "" : fmt::format(" Ranks: {}.", rank_method(evidence).of_pair);
  if (std::string all = dispute_of_all(evidence); !all.empty()) parts.push_back(std::move(all));
  if (parts.empty()) return {};
  return {"Where methods disagree", fmt::format("{}.{}", fmt::join(parts, "; "), ranks)};
}

}  // namespace ikbench::report
