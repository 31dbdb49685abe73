#include "analysis/report/outcome_words.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "analysis/inference/judge.hpp"
#include "analysis/inference/method.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/words.hpp"

namespace ikbench::report {

using namespace inference;
using namespace fmt::literals;

namespace {

std::int64_t ones_of(const GroupEvidence& group) { return std::llround(group.mean.value * group.described.n); }

}  // namespace

Sentence shares_words(const Evidence& evidence) {
  std::vector<std::string> shares;
  for (std::size_t i = 0; i < evidence.groups.size(); ++i) {
    const GroupEvidence& group = evidence.groups[i];
    shares.push_back(fmt::format("{} {} of {} ({}, {:.0f} to {:.0f} %)", name_words(evidence, i), ones_of(group),
                                 group.described.n, percent(group.mean.value), 100 * group.mean.low,
                                 100 * group.mean.high));
  }
  return {fmt::format("Shares of {}", evidence.quantity), clauses(shares) + '.'};
}

Sentence outcome_methods_words(const Evidence& evidence) {
  const std::size_t pairs = corrected_for(evidence);
  const std::string family =
      pairs > 1 ? fmt::format(", corrected for {} pairs by {}", pairs, adjustment_words(evidence)) : "";
  return {"Methods", fmt::format(words::method_of_shares,
                                 "method"_a = fmt::format(words::method, "test"_a = deciding_words(evidence),
                                                          "level"_a = rounded_number(evidence.plan.significance, 3),
                                                          "family"_a = family, "margin"_a = margin_words(evidence)),
                                 "interval"_a = evidence.method->interval)};
}

Table outcomes_table(const Evidence& evidence) {
  Table table{
      .name = fmt::format("statistics-{}-groups", evidence.name),
      .caption = fmt::format("Observations of 0 and 1: {}", evidence.quantity),
      .columns = {"group", "n", "ones", "share", percent(1 - evidence.plan.significance) + " interval of the share"}};
  for (const GroupEvidence& group : evidence.groups) {
    table.rows.push_back({group.name, std::int64_t{group.described.n}, ones_of(group), group.mean.value,
                          Range{group.mean.low, group.mean.high}});
  }
  if (!evidence.replicate.empty()) table.notes.push_back(fmt::format("One observation is {}.", evidence.replicate));
  table.notes.emplace_back("Interval: Wilson's.");
  for (const std::string& note : evidence.notes) table.notes.push_back(note);
  if (!evidence.flaws.empty()) table.notes.push_back("Flawed: " + words_of(evidence.flaws));
  return table;
}

}  // namespace ikbench::report
