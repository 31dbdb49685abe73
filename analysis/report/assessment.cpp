#include "analysis/report/assessment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/figures/box_figure.hpp"
#include "analysis/figures/critical_difference_figure.hpp"
#include "analysis/figures/figure_parts.hpp"
#include "analysis/figures/row_figures.hpp"
#include "analysis/inference/design.hpp"
#include "analysis/inference/judge.hpp"
#include "analysis/inference/method.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/report/answer.hpp"
#include "analysis/report/assessment_json.hpp"
#include "analysis/report/assessment_sentences.hpp"
#include "analysis/report/assessment_tables.hpp"
#include "analysis/report/assessment_words.hpp"

namespace ikbench::report {

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

void add_differences(const Evidence& evidence, std::vector<Figure>& figures) {
  std::vector<DifferenceRow> rows;
  const bool of_logarithms = evidence.scale == ValueScale::log10;
  const auto name_of = [&](std::size_t group) { return row_label(evidence.groups[group].name, longest_label); };
  for (const Finding& contrast : evidence.contrasts) {
    rows.push_back(
        {.label = fmt::format("{} {} {}", name_of(contrast.first), of_logarithms ? "/" : "-", name_of(contrast.second)),
         .difference = contrast.estimate.value,
         .low = contrast.estimate.low,
         .high = contrast.estimate.high});
  }
  if (rows.empty() || rows.size() > most_rows) return;
  figures.push_back(differences_figure(rows, {.name = figure_name(evidence, "differences"),
                                              .quantity = of_logarithms ? "ratio: " + split_unit(evidence.quantity).name
                                                                        : "difference: " + evidence.quantity,
                                              .level = 1 - evidence.plan.significance,
                                              .method = std::string(evidence.method->interval),
                                              .are_ratios = of_logarithms}));
}

void add_ranks(const Evidence& evidence, std::vector<Figure>& figures) {
  if (evidence.blocks == 0 || !std::isfinite(evidence.critical_difference)) return;
  CriticalDifference ranks{.name = figure_name(evidence, "ranks"),
                           .critical_difference = evidence.critical_difference,
                           .significance = evidence.plan.significance,
                           .method = fmt::format("Nemenyi, all pairs, {} blocks", evidence.blocks),
                           .decides = std::string(pair_test_words(evidence))};
  for (const GroupEvidence& group : evidence.groups) {
    ranks.labels.push_back(group.name);
    ranks.average_ranks.push_back(group.average_rank);
  }
  if (ranks.labels.size() <= most_groups_in_pairs) figures.push_back(critical_difference_figure(ranks));
}

// Returns whether at least two groups have different values; otherwise tables are enough.
bool is_worth_drawing(const Evidence& evidence) {
  if (evidence.from_summaries) return true;
  return std::ranges::count_if(evidence.groups, [](const GroupEvidence& group) {
           return group.described.min != group.described.max;
         }) > 1;
}

Assessment assessment_of(const Evidence& evidence) {
  Assessment result{.name = evidence.name,
                    .quantity = evidence.quantity,
                    .unit = evidence.unit,
                    .sentences = sentences_of(evidence),
                    .answer = answer(evidence),
                    .flaws = evidence.flaws,
                    .tables = tables_of(evidence),
                    .json = json_of(evidence)};
  if (!is_worth_drawing(evidence)) return result;
  add_differences(evidence, result.figures);
  add_ranks(evidence, result.figures);
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

Assessment with_observations(const Evidence& evidence, const Observations& observations) {
  const Evidence found = with_bootstrap(evidence, observations);
  Assessment result = assessment_of(found);
  if (is_worth_drawing(found) && !found.of_outcomes) {
    result.figures.insert(result.figures.begin(), box_figure(in_unit(observations), quantile_type(found.plan.quartiles),
                                                             figure_name(found, "observations")));
  }
  return result;
}

}  // namespace

std::string heading_of(const Assessment& assessment) { return "Statistics: " + assessment.quantity; }

Assessment assess(const Observations& observations, const AnalysisPlan& plan) {
  return with_observations(tested(observations, plan), observations);
}

Assessment assess(const Summaries& summaries, const AnalysisPlan& plan) {
  return assessment_of(evidence(summaries, plan));
}

Assessment assess(const JudgedStudy& study, Metric metric, Estimand estimand) {
  return with_observations(study.evidence(metric, estimand), observations(study, metric, estimand));
}

}  // namespace ikbench::report
