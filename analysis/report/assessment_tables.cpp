#include "analysis/report/assessment_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/inference/judge.hpp"
#include "analysis/inference/method.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/words.hpp"
#include "analysis/statistics/effect_size.hpp"

namespace ikbench::report {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace fmt::literals;

namespace {

std::string table_name(const Evidence& evidence, std::string_view part) {
  return fmt::format("statistics-{}-{}", evidence.name, part);
}

Cell interval(const Estimate& estimate) {
  if (!std::isfinite(estimate.low) || !std::isfinite(estimate.high)) return {};
  return Range{estimate.low, estimate.high};
}

Cell or_nothing(double value) { return std::isfinite(value) ? Cell(value) : Cell(); }
Cell or_nothing(PValue p) { return std::isfinite(p.value) ? Cell(p) : Cell(); }

Cell unless_zero(int count) {
  if (count == 0) return {};
  return std::int64_t{count};
}

// Adds the notes of a table of groups: one observation, the intervals, the data.
Table with_notes(Table table, const Evidence& evidence, const std::string& intervals) {
  if (!evidence.replicate.empty())
    table.notes.push_back(fmt::format(words::observation, "what"_a = evidence.replicate));
  if (!intervals.empty()) table.notes.push_back(intervals);
  table.notes.insert(table.notes.end(), evidence.notes.begin(), evidence.notes.end());
  return table;
}

Table groups_table(const Evidence& evidence) {
  const std::string level = percent(1 - evidence.plan.significance);
  const bool of_logarithms = evidence.scale == ValueScale::log10;
  Table table{
      .name = table_name(evidence, "groups"),
      .caption = fmt::format("Observations: {}", evidence.quantity),
      .columns = {"group", "n", "not finite", of_logarithms ? "geometric mean" : "mean",
                  level + " interval of the mean", "bootstrap interval", of_logarithms ? "sd of log10" : "sd", "median",
                  level + " interval of the median", "q1", "q3", "min", "max", "Shapiro-Wilk p", "average rank"}};
  for (const GroupEvidence& group : evidence.groups) {
    const Description& of = group.described;
    const Cell not_finite = unless_zero(of.not_finite);
    if (evidence.from_summaries) {
      table.rows.push_back({group.name, std::int64_t{of.n}, not_finite, of.mean, interval(group.mean), Cell(),
                            of.n > 1 ? Cell(of.std) : Cell(), Cell(), Cell(), Cell(), Cell(), Cell(), Cell(), Cell(),
                            Cell()});
      continue;
    }
    table.rows.push_back({group.name, std::int64_t{of.n}, not_finite, of.mean, interval(group.mean),
                          interval(group.bootstrapped), of.n > 1 ? Cell(of.std) : Cell(), of.median,
                          interval(group.median), group.q1, group.q3, of.min, of.max,
                          or_nothing(PValue{group.normality}), or_nothing(group.average_rank)});
  }
  return with_notes(
      std::move(table), evidence,
      evidence.from_summaries ? "" : fmt::format(words::intervals_and_quartiles, "type"_a = evidence.plan.quartiles));
}

// Shares with intervals replace means where every observation is 0 or 1.
Table outcomes_table(const Evidence& evidence) {
  Table table{
      .name = table_name(evidence, "groups"),
      .caption = fmt::format("Observations of 0 and 1: {}", evidence.quantity),
      .columns = {"group", "n", "ones", "share", percent(1 - evidence.plan.significance) + " interval of the share"}};
  for (const GroupEvidence& group : evidence.groups) {
    table.rows.push_back({group.name, std::int64_t{group.described.n}, ones_of(group), group.mean.value,
                          Range{group.mean.low, group.mean.high}});
  }
  return with_notes(std::move(table), evidence, std::string(words::ones_interval));
}

Table tests_table(const Evidence& evidence) {
  Table table{.name = table_name(evidence, "tests"),
              .caption = fmt::format("Tests of all groups: {}", evidence.quantity),
              .columns = {"part", "test", "statistic", "value", "df", "df within", "p", "effect", "size", "verdict"}};
  for (const TestResult& test : evidence.tests) {
    const bool significant = test.p < evidence.plan.significance;
    const std::string_view finding = test.role == Role::assumption ? (significant ? "rejected" : "not rejected")
                                                                   : (significant ? "the groups differ" : "undecided");
    const bool defined = test.undefined.empty(), has_effect = std::isfinite(test.effect);
    table.rows.push_back(
        {std::string(role_words(test.role)),
         fmt::format("{}{}", test.test, test.without.empty() ? "" : fmt::format(" ({})", test.without)),
         defined ? Cell(test.symbol) : Cell(), or_nothing(test.statistic), defined ? or_nothing(test.df) : Cell(),
         defined ? or_nothing(test.df_within) : Cell(), or_nothing(PValue{test.p}),
         has_effect ? Cell(test.effect_symbol) : Cell(), or_nothing(test.effect),
         defined ? std::string(finding) : "not defined: " + test.undefined});
  }
  table.notes.push_back(fmt::format(words::significance, "level"_a = rounded_number(evidence.plan.significance, 3),
                                    "test"_a = deciding_words(evidence)));
  return table;
}

// Words the size of Cliff's delta, 2 A12 - 1 (Romano et al. 2006).
Cell size_words(const Finding& contrast) {
  if (!std::isfinite(contrast.superiority.value)) return {};
  return std::string(statistics::effect_words(2 * contrast.superiority.value - 1));
}

// Says how many pairs p-values and intervals are corrected for, and what follows if that leaves a pair undecided.
std::string family_note(const Evidence& evidence) {
  if (evidence.pairs == 1) return fmt::format(words::decides, "test"_a = deciding_words(evidence));
  const bool costs_one = std::ranges::any_of(evidence.contrasts, [&](const Finding& pair) {
    return pair.relation == Relation::undecided && pair.p_alone < evidence.plan.significance;
  });
  return fmt::format(words::decides_all, "test"_a = deciding_words(evidence), "pairs"_a = corrected_for(evidence),
                     "interval"_a = evidence.method->interval) +
         (costs_one ? fmt::format(words::undecided_in_family, "pairs"_a = corrected_for(evidence)) : "");
}

Table contrasts_table(const Evidence& evidence) {
  const std::string level = percent(1 - evidence.plan.significance);
  Table table{
      .name = table_name(evidence, "contrasts"),
      .caption = fmt::format("Pairwise comparisons: {}", evidence.quantity),
      .columns = {"first", "second", "verdict",
                  evidence.scale == ValueScale::log10 ? "ratio of geometric means" : "difference of means",
                  level + " interval", "p", "p alone", evidence.blocks > 0 ? "ahead in blocks" : "A12",
                  level + (evidence.blocks > 0 ? " interval of the share" : " interval of A12"), "size", "Hedges g"}};
  const bool has_ranks = evidence.method->compares == Compares::means && !evidence.from_summaries;
  if (has_ranks) table.columns.push_back(fmt::format("p, {}", rank_method(evidence).of_pair));
  table.columns.push_back(replicates_words(evidence) == evidence.block_noun ? "blocks to decide" : "runs to decide");
  for (const Finding& contrast : evidence.contrasts) {
    std::vector<Cell>& row = table.rows.emplace_back(std::vector<Cell>{
        evidence.groups[contrast.first].name, evidence.groups[contrast.second].name, verdict_words(evidence, contrast),
        contrast.estimate.value, interval(contrast.estimate), or_nothing(PValue{contrast.p}),
        or_nothing(PValue{contrast.p_alone}), or_nothing(contrast.superiority.value), interval(contrast.superiority),
        size_words(contrast), or_nothing(contrast.g)});
    if (has_ranks) row.push_back(or_nothing(PValue{contrast.p_ranks}));
    const Estimate& runs = contrast.runs_to_decide;  // the same range as in the sentence
    row.push_back(std::isfinite(runs.low)     ? Cell(range_words(runs.low, runs.high))
                  : std::isfinite(runs.value) ? Cell(fmt::format("at least {:.0f}", runs.value))
                                              : Cell());
  }
  table.notes.push_back(family_note(evidence));
  if (!evidence.from_summaries && !evidence.of_outcomes) {
    table.notes.emplace_back(evidence.blocks > 0 ? words::share_of_blocks : words::a12);
  }
  if (const std::string limit = rare_failures_words(evidence); !limit.empty()) table.notes.push_back(limit + '.');
  if (evidence.reference) {
    const std::string& name = evidence.groups[*evidence.reference].name;
    table.notes.push_back(evidence.plan.control.empty() ? fmt::format(words::pairs_with_best, "name"_a = name)
                                                        : fmt::format(words::pairs_with_control, "name"_a = name));
  }
  return table;
}

}  // namespace

std::vector<Table> tables_of(const Evidence& evidence) {
  std::vector<Table> tables{evidence.of_outcomes ? outcomes_table(evidence) : groups_table(evidence)};
  if (!evidence.tests.empty()) tables.push_back(tests_table(evidence));
  if (!evidence.contrasts.empty()) tables.push_back(contrasts_table(evidence));
  for (Table& table : tables) {
    if (!evidence.flaws.empty()) table.notes.push_back(fmt::format(words::flawed, "why"_a = words_of(evidence.flaws)));
  }
  return tables;
}

}  // namespace ikbench::report
