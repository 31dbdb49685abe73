#include "analysis/report/assessment_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/inference/judge.hpp"
#include "analysis/inference/method.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/outcome_words.hpp"
#include "analysis/statistics/effect_size.hpp"

namespace ikbench::report {

using namespace results;
using namespace statistics;
using namespace inference;

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
  if (!evidence.replicate.empty()) table.notes.push_back(fmt::format("One observation is {}.", evidence.replicate));
  if (!evidence.from_summaries) {
    table.notes.push_back(
        fmt::format("Intervals: Student's t and studentized bootstrap for the mean, order statistics for the median. "
                    "Quartiles: Hyndman-Fan type {}.",
                    evidence.plan.quartiles));
  }
  for (const std::string& note : evidence.notes) table.notes.push_back(note);
  if (!evidence.flaws.empty()) table.notes.push_back("Flawed: " + words_of(evidence.flaws));
  return table;
}

std::string role_words(Role role) {
  constexpr std::array<std::string_view, 3> words{"assumption", "classical", "robust"};
  return std::string(words[static_cast<std::size_t>(role)]);
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
        {role_words(test.role),
         fmt::format("{}{}", test.test, test.without.empty() ? "" : fmt::format(" ({})", test.without)),
         defined ? Cell(test.symbol) : Cell(), or_nothing(test.statistic), defined ? or_nothing(test.df) : Cell(),
         defined ? or_nothing(test.df_within) : Cell(), or_nothing(PValue{test.p}),
         has_effect ? Cell(test.effect_symbol) : Cell(), or_nothing(test.effect),
         defined ? std::string(finding) : "not defined: " + test.undefined});
  }
  table.notes.push_back(fmt::format("Significance {}. {} decides. The plan chooses the test, not the data.",
                                    rounded_number(evidence.plan.significance, 3), deciding_words(evidence)));
  if (!evidence.flaws.empty()) table.notes.push_back("Flawed: " + words_of(evidence.flaws));
  return table;
}

// Words the size of Cliff's delta, 2 A12 - 1 (Romano et al. 2006).
Cell size_words(const Contrast& contrast) {
  if (!std::isfinite(contrast.superiority.value)) return {};
  return std::string(statistics::effect_words(2 * contrast.superiority.value - 1));
}

// Says how many pairs p-values and intervals are corrected for.
std::string family_note(const Evidence& evidence) {
  if (evidence.pairs == 1) return fmt::format("{} decides.", deciding_words(evidence));
  return fmt::format("{} decides. p: adjusted for {} pairs. Interval of the difference: {}, adjusted for {} pairs.",
                     deciding_words(evidence), corrected_for(evidence), evidence.method->interval,
                     corrected_for(evidence));
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
  for (const Contrast& contrast : evidence.contrasts) {
    std::vector<Cell>& row = table.rows.emplace_back(std::vector<Cell>{
        evidence.groups[contrast.first].name, evidence.groups[contrast.second].name, verdict_words(evidence, contrast),
        contrast.difference.value, interval(contrast.difference), or_nothing(PValue{contrast.p}),
        or_nothing(PValue{contrast.p_alone}), or_nothing(contrast.superiority.value), interval(contrast.superiority),
        size_words(contrast), or_nothing(contrast.g)});
    if (has_ranks) row.push_back(or_nothing(PValue{contrast.p_ranks}));
    const double runs = contrast.runs_to_decide.value;
    row.push_back(std::isfinite(runs) ? Cell(static_cast<std::int64_t>(runs)) : Cell());
  }
  table.notes.push_back(family_note(evidence));
  if (!evidence.from_summaries && !evidence.of_outcomes) {
    table.notes.push_back(evidence.blocks > 0
                              ? "Ahead in blocks: the share of blocks in which the first is better; ties count half. "
                                "Its interval is not adjusted, and is not defined with ties."
                              : "A12: the probability that an observation of the first is better than one of the "
                                "second; ties count half. Its interval is not adjusted.");
  }
  if (const std::string limit = rare_failures_words(evidence); !limit.empty()) table.notes.push_back(limit + '.');
  if (evidence.reference) {
    table.notes.push_back(fmt::format(
        "The table shows the pairs with {}{}.", evidence.groups[*evidence.reference].name,
        evidence.plan.control.empty() ? ", the best; there are too many groups to show all pairs" : ", the control"));
  }
  if (!evidence.flaws.empty()) table.notes.push_back("Flawed: " + words_of(evidence.flaws));
  return table;
}

}  // namespace

std::vector<Table> tables_of(const Evidence& evidence) {
  std::vector<Table> tables{evidence.of_outcomes ? outcomes_table(evidence) : groups_table(evidence)};
  if (!evidence.tests.empty()) tables.push_back(tests_table(evidence));
  if (!evidence.contrasts.empty()) tables.push_back(contrasts_table(evidence));
  return tables;
}

}  // namespace ikbench::report
