#include "analysis/report/assessment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

#include "analysis/figures/box_figure.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/figures/row_figures.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/method.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/assessment_words.hpp"
#include "analysis/report/json.hpp"
#include "analysis/report/words.hpp"

namespace ikbench::report {

using namespace fmt::literals;
using namespace results;
using namespace statistics;
using namespace inference;
using namespace figures;

namespace {

std::string figure_name(const Evidence& evidence, std::string_view part) {
  return fmt::format("statistics-{}-{}", evidence.name, part);
}

// Most contrasts that fit into a figure.
constexpr std::size_t most_rows = 45;

// Solvers that figures show, in their order; empty: all.
using Drawn = std::vector<std::string>;

bool is_drawn(const Drawn& drawn, const std::string& solver) {
  return drawn.empty() || std::ranges::find(drawn, solver) != drawn.end();
}

void add_differences(const Evidence& evidence, const Drawn& drawn, std::vector<Figure>& figures) {
  std::vector<DifferenceRow> rows;
  const bool of_logarithms = evidence.scale == ValueScale::log10;
  for (const Finding& contrast : evidence.contrasts) {
    const std::string &first = evidence.groups[contrast.first].name, &second = evidence.groups[contrast.second].name;
    if (!is_drawn(drawn, first) || !is_drawn(drawn, second)) continue;
    rows.push_back({.first = first,
                    .second = second,
                    .difference = contrast.estimate.value,
                    .low = contrast.estimate.low,
                    .high = contrast.estimate.high});
  }
  if (rows.empty() || rows.size() > most_rows) return;
  NameWithUnit quantity = split_unit(evidence.quantity);
  quantity.name = (of_logarithms ? "ratio: " : "difference: ") + quantity.name;
  if (of_logarithms) quantity.unit.clear();
  figures.push_back(differences_figure(rows, {.name = figure_name(evidence, "differences"),
                                              .quantity = quantity,
                                              .level = 1 - evidence.plan.significance,
                                              .method = std::string(evidence.method->interval),
                                              .are_ratios = of_logarithms,
                                              .larger_is_better = evidence.better == Better::larger}));
}

// Returns whether at least two groups have different values; otherwise tables are enough.
bool is_worth_drawing(const Evidence& evidence) {
  if (evidence.from_summaries) return true;
  return std::ranges::count_if(evidence.groups, [](const GroupEvidence& group) {
           return group.described.min != group.described.max;
         }) > 1;
}

Assessment assessment_of(const Evidence& evidence, const Drawn& drawn) {
  Assessment result{.name = evidence.name,
                    .quantity = evidence.quantity,
                    .unit = evidence.unit,
                    .sentences = sentences_of(evidence),
                    .answer = answer(evidence),
                    .flaws = evidence.flaws,
                    .findings = findings_of(evidence),
                    .tables = tables_of(evidence),
                    .json = json_of(evidence)};
  if (!is_worth_drawing(evidence)) return result;
  add_differences(evidence, drawn, result.figures);
  if (evidence.flaws.empty()) return result;
  for (Figure& figure : result.figures) figure.caption += fmt::format(" Flawed: {}", words_of(evidence.flaws));
  return result;
}

// Converts logarithms to the unit of the values.
Observations in_unit(Observations observations) {
  if (observations.scale != ValueScale::log10) return observations;
  for (Group& group : observations.groups) {
    for (double& value : group.values) value = std::pow(10, value);
  }
  return observations;
}

// The groups that are drawn, in the order of the figures.
Observations drawn_part(Observations observations, const Drawn& drawn) {
  if (drawn.empty()) return observations;
  const auto place = [&](const Group& group) { return std::ranges::find(drawn, group.name) - drawn.begin(); };
  std::erase_if(observations.groups, [&](const Group& group) { return !is_drawn(drawn, group.name); });
  std::ranges::stable_sort(observations.groups, {}, place);
  return observations;
}

Assessment with_observations(const Evidence& found, const Observations& observations, const Drawn& drawn) {
  Assessment result = assessment_of(found, drawn);
  if (is_worth_drawing(found) && !found.of_outcomes && !found.from_summaries) {
    result.figures.insert(result.figures.begin(),
                          box_figure(drawn_part(in_unit(observations), drawn), QuantileType{found.plan.quartiles},
                                     figure_name(found, "observations")));
  }
  return result;
}

Json estimate(const Estimate& of) {
  return {{"value", json_number(of.value)}, {"low", json_number(of.low)}, {"high", json_number(of.high)}};
}

std::string_view extent_of(const Finding& contrast) {
  return contrast.is_within_margin()   ? "within the margin"
         : contrast.is_beyond_margin() ? "beyond the margin"
         : contrast.is_across_margin() ? "on both sides of the margin"
                                       : "unknown";
}

void add_reason(Json& object, const std::string& undefined) {
  if (!undefined.empty()) object["undefined"] = undefined;
}

Json group_json(const GroupEvidence& group) {
  const Description& of = group.described;
  return {{"name", group.name},
          {"n", of.n},
          {"not_finite", of.not_finite},
          {"mean", estimate(group.mean)},
          {"sd", json_number(of.std)},
          {"median", estimate(group.median)},
          {"q1", json_number(group.q1)},
          {"q3", json_number(group.q3)},
          {"min", json_number(of.min)},
          {"max", json_number(of.max)},
          {"mean_rank", json_number(group.mean_rank)},
          {"decades", json_number(group.decades)}};
}

Json test_json(const TestResult& test) {
  Json object{{"test", test.test},
              {"role", role_words(test.role)},
              {"without", test.without},
              {"symbol", test.symbol},
              {"statistic", json_number(test.statistic)},
              {"df", json_number(test.df)},
              {"df_within", json_number(test.df_within)},
              {"p", json_number(test.p)}};
  if (!test.effect_symbol.empty())
    object["effect"] = {{"symbol", test.effect_symbol}, {"value", json_number(test.effect)}};
  add_reason(object, test.undefined);
  return object;
}

Json contrast_json(const Evidence& evidence, const Finding& contrast) {
  Json object{{"first", evidence.groups[contrast.first].name},
              {"second", evidence.groups[contrast.second].name},
              {"difference", estimate(contrast.estimate)},
              {"p", json_number(contrast.p)},
              {"p_alone", json_number(contrast.p_alone)},
              {evidence.blocks > 0 ? "share_of_blocks_ahead" : "a12", estimate(contrast.superiority)},
              {"typical_ratio", estimate(contrast.ratio)},
              {"hedges_g", json_number(contrast.g)},
              {"relation", name_of(contrast.relation)},
              {"extent", extent_of(contrast)},
              {"verdict", verdict_words(evidence, contrast)}};
  add_reason(object, contrast.why);
  return object;
}

}  // namespace

Findings findings_of(const Evidence& evidence) {
  Findings found{.pairs = {.name = "findings",
                           .caption = "How the first relates to the second",
                           .columns = {"first", "second", "relation", "estimate", "low", "high", "is_ratio", "p"}}};
  if (evidence.groups.empty()) return found;
  const std::size_t best = evidence.reference.value_or(best_group(evidence));
  constexpr std::array weight{Relation::undefined, Relation::same, Relation::worse, Relation::better,
                              Relation::undecided};  // the last that occurs counts
  const auto weight_of = [&](Relation relation) { return std::ranges::find(weight, relation); };
  for (const Finding& pair : evidence.contrasts) {
    const Estimate& estimate = evidence.ranks_decide() ? pair.ratio : pair.estimate;
    found.pairs.rows.push_back({evidence.groups[pair.first].name, evidence.groups[pair.second].name,
                                std::string(name_of(pair.relation)), estimate.value, estimate.low, estimate.high,
                                std::int64_t{pair.is_ratio || evidence.ranks_decide()}, PValue{pair.p}});
    if (pair.first != best && pair.second != best) continue;
    const Relation relation = pair.first == best ? pair.relation : reversed(pair.relation);
    if (weight_of(relation) > weight_of(found.lead)) found.lead = relation;
  }
  return found;
}

std::string json_of(const Evidence& evidence) {
  constexpr std::array scales{"plain", "log10", "share"};
  const AnalysisPlan& plan = evidence.plan;
  Json object{{"quantity", evidence.quantity},
              {"unit", evidence.unit},
              {"better", evidence.better == Better::smaller ? "smaller" : "larger"},
              {"scale", scales[static_cast<std::size_t>(evidence.scale)]},
              {"replicate", evidence.replicate},
              {"block", evidence.block},
              {"blocks", evidence.blocks},
              {"method", evidence.method == nullptr ? "" : evidence.method->title},
              {"from_summaries", evidence.from_summaries},
              {"of_outcomes", evidence.of_outcomes},
              {"plan",
               {{"test", plan.test},
                {"control", plan.control},
                {"significance", plan.significance},
                {"margin", plan.margin},
                {"margin_cm", plan.margin_cm},
                {"margin_absolute", evidence.margin},
                {"quartiles", plan.quartiles}}},
              {"notes", evidence.notes},
              {"flaw", words_of(evidence.flaws)},
              {"pairs", evidence.pairs}};
  Json groups = Json::array(), tests = Json::array(), contrasts = Json::array();
  for (const GroupEvidence& group : evidence.groups) groups.push_back(group_json(group));
  for (const TestResult& test : evidence.tests) tests.push_back(test_json(test));
  for (const Finding& contrast : evidence.contrasts) contrasts.push_back(contrast_json(evidence, contrast));
  object["groups"] = groups;
  object["tests"] = tests;
  object["contrasts"] = contrasts;
  object["sentences"] = words_of(sentences_of(evidence));
  return numerics::text_of(object, 2);  // names may be anything
}

std::string heading_of(const Assessment& assessment) {
  return "Statistics: " + quantity_words(assessment.quantity, assessment.unit);
}

Assessment assess(const Observations& observations, const AnalysisPlan& plan, const Drawn& drawn) {
  return with_observations(evidence(observations, plan), observations, drawn);
}

Assessment assess(const JudgedStudy& study, Metric metric, Estimand estimand) {
  return with_observations(study.evidence(metric, estimand), observations(study, metric, estimand),
                           study.drawn_solvers);
}

namespace {

std::string table_name(const Evidence& evidence, std::string_view part) {
  return fmt::format("statistics-{}-{}", evidence.name, part);
}

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
  Table table{.name = table_name(evidence, "groups"),
              .caption = fmt::format("Observations: {}", quantity_words(evidence.quantity, evidence.unit)),
              .columns = {"group", "n", "not finite", of_logarithms ? "geometric mean" : "mean",
                          level + " interval of the mean", of_logarithms ? "sd of log10" : "sd", "median",
                          level + " interval of the median", "q1", "q3", "min", "max"}};
  if (evidence.unit == "s") {
    table.times = {"mean",
                   "geometric mean",
                   level + " interval of the mean",
                   "median",
                   level + " interval of the median",
                   "q1",
                   "q3",
                   "min",
                   "max"};
    if (!of_logarithms) table.times.emplace_back("sd");
  }
  for (const GroupEvidence& group : evidence.groups) {
    const Description& of = group.described;
    const Cell not_finite = unless_zero(of.not_finite);
    table.rows.push_back({group.name, std::int64_t{of.n}, not_finite, of.mean, range_of(group.mean),
                          of.n > 1 ? Cell(of.std) : Cell(), or_nothing(of.median), range_of(group.median),
                          or_nothing(group.q1), or_nothing(group.q3), or_nothing(of.min), or_nothing(of.max)});
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
  return with_notes(std::move(table), evidence, std::string(words::wilson));
}

Table tests_table(const Evidence& evidence) {
  Table table{.name = table_name(evidence, "tests"),
              .caption = fmt::format("Tests of all groups: {}", quantity_words(evidence.quantity, evidence.unit)),
              .columns = {"part", "test", "statistic", "value", "df", "df within", "p", "effect", "size", "verdict"}};
  for (const TestResult& test : evidence.tests) {
    const bool significant = test.p < evidence.plan.significance;
    const std::string_view finding = significant ? "the groups differ" : "undecided";
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
  Table table{.name = table_name(evidence, "contrasts"),
              .caption = fmt::format("Pairwise comparisons: {}", quantity_words(evidence.quantity, evidence.unit)),
              .columns = {"first", "second", "verdict",
                          evidence.scale == ValueScale::log10 ? "ratio of geometric means" : "difference of means",
                          level + " interval", "p", "p alone", evidence.blocks > 0 ? "ahead in blocks" : "A12",
                          level + (evidence.blocks > 0 ? " interval of the share" : " interval of A12"), "Hedges g"}};
  if (evidence.unit == "s" && evidence.scale == ValueScale::plain)
    table.times = {"difference of means", level + " interval"};
  for (const Finding& contrast : evidence.contrasts) {
    table.rows.push_back({evidence.groups[contrast.first].name, evidence.groups[contrast.second].name,
                          verdict_words(evidence, contrast), contrast.estimate.value, range_of(contrast.estimate),
                          or_nothing(PValue{contrast.p}), or_nothing(PValue{contrast.p_alone}),
                          or_nothing(contrast.superiority.value), range_of(contrast.superiority),
                          or_nothing(contrast.g)});
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
