#include "analysis/report/cost_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "analysis/inference/clusters.hpp"
#include "analysis/inference/comparable.hpp"
#include "analysis/inference/costs.hpp"
#include "analysis/inference/estimand.hpp"
#include "analysis/inference/text.hpp"
#include "analysis/inference/times.hpp"
#include "analysis/report/words.hpp"

namespace ikbench::report {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace fmt::literals;

namespace {

// A number that may be infinite.
Cell number_of(double value) { return std::isinf(value) ? Cell("inf") : Cell(value); }

Cell count_of(double count) { return std::llround(count); }

std::string name_of_table(Metric cost, std::string_view part) {
  return fmt::format("statistics-cost{}{}", cost == Metric::seconds ? "-seconds" : "", part);
}

// Says what the intervals are from, and what they mean.
std::string interval_note(const Clusters& clusters, std::string_view meaning) {
  if (!clusters.undefined().empty()) return fmt::format(words::no_intervals, "why"_a = clusters.undefined());
  return fmt::format(words::cluster_intervals, "level"_a = percent(clusters.level()),
                     "samples"_a = clusters.replicates().size(), "clusters"_a = clusters.noun(), "meaning"_a = meaning);
}

Table cost_table(const StudyResults& study, Metric cost, const Clusters& clusters) {
  Table table{.name = name_of_table(cost, ""),
              .caption = fmt::format(words::cost_caption, "cost"_a = info_of(cost).name,
                                     "within"_a = within_words(study, Metric::position_error_cm)),
              .columns = {"solver", "solves", "solved", "ert", "ert interval"}};
  if (cost == Metric::seconds) table.times = {"ert", "ert interval"};
  std::vector<std::string> undefined;
  const std::vector<SolverCost> costs = costs_of(study, cost, clusters);
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const RunningTime& time = costs[i].time;
    const Estimate ert = costs[i].expected(clusters);
    table.rows.push_back({study.solvers[i], count_of(time.trials), count_of(time.successes), number_of(time.expected()),
                          time.successes > 0 ? Range{ert.low, ert.high} : Range{}});
    if (!costs[i].undefined.empty()) undefined.push_back(fmt::format("{}: {}", study.solvers[i], costs[i].undefined));
  }
  table.notes = {std::string(words::running_time), interval_note(clusters, words::infinite_end)};
  if (cost == Metric::seconds) table.notes.push_back(speed_note(study));
  for (const std::string& reason : undefined)
    table.notes.push_back(fmt::format(words::not_defined_for, "reason"_a = reason));
  for (std::string& note : status_notes(study)) table.notes.push_back(std::move(note));
  return table;
}

Table cost_pair_table(const StudyResults& study, Metric cost, const Clusters& clusters) {
  Table table{.name = name_of_table(cost, "-pairs"),
              .caption = fmt::format(words::cost_pairs_caption, "cost"_a = info_of(cost).name,
                                     "within"_a = within_words(study, Metric::position_error_cm)),
              .columns = {"first", "second", "spends less", "ert ratio", "ert ratio interval", "remark"}};
  for (const Finding& finding : compare_costs(study, cost, clusters)) {
    const auto& [value, low, high] = finding.estimate;
    const std::string &first = study.solvers[finding.first], &second = study.solvers[finding.second];
    const std::string less = finding.relation == Relation::better  ? first
                             : finding.relation == Relation::worse ? second
                                                                   : std::string(name_of(finding.relation));
    table.rows.push_back({first, second, less, number_of(value), Range{low, high},
                          finding.why.empty() ? Cell() : Cell(std::string(finding.why))});
  }
  table.notes = {std::string(words::cost_ratios), interval_note(clusters, words::hold_for_pairs)};
  return table;
}

std::string_view word(Relation relation) {
  return relation == Relation::better ? "ahead" : relation == Relation::worse ? "behind" : name_of(relation);
}

// "A", "undecided between A, B".
std::string leaders_at(const std::vector<AtBudget>& standings, const std::vector<std::string>& solvers) {
  std::string undecided;
  for (std::size_t i = 0; i < standings.size(); ++i) {
    if (standings[i].relation == Relation::better) return one_line(solvers[i]);
    if (standings[i].relation == Relation::worse || std::isnan(standings[i].share.value)) continue;
    undecided += (undecided.empty() ? "" : ", ") + one_line(solvers[i]);
  }
  return "undecided between " + undecided;
}

std::optional<Table> anytime_table(const StudyResults& study, const Clusters& clusters) {
  const std::optional<Anytime> found = anytime(study, clusters);
  if (!found) return std::nullopt;
  Table table{
      .name = "statistics-cost-anytime",
      .caption = std::isfinite(tolerance_cm(study))
                     ? fmt::format(words::anytime_caption, "within"_a = within_words(study, Metric::position_error_cm))
                     : std::string(words::anytime_targets_caption),
      .columns = {"part of budget", "evaluations", "solver", "share", "share interval", "behind by", "behind interval",
                  "position"}};
  std::string leaders;
  for (std::size_t k = 0; k < budget_parts.size(); ++k) {
    for (std::size_t i = 0; i < study.solvers.size(); ++i) {
      const auto& [share, leader, relation] = found->standings[k][i];
      const Estimate behind = leader ? leader->estimate : Estimate{};
      table.rows.push_back({percent(budget_parts[k]), budget_parts[k] * found->budget, study.solvers[i], share.value,
                            Range{share.low, share.high}, leader ? Cell(behind.value) : Cell(),
                            Range{behind.low, behind.high}, std::string(word(relation))});
    }
    leaders += fmt::format("{} at {}: {}", k == 0 ? "" : ";", percent(budget_parts[k]),
                           leaders_at(found->standings[k], study.solvers));
  }
  table.notes = {fmt::format(words::anytime_leaders, "leaders"_a = leaders),
                 fmt::format(words::anytime_columns, "budget"_a = rounded_number(found->budget, 6),
                             "source"_a = found->is_of_study ? "the study's limit" : "those of the longest solve"),
                 interval_note(clusters, words::hold_for_budgets)};
  return table;
}

}  // namespace

std::vector<Table> cost_tables(const StudyResults& measured) {
  if (measured.solves.empty()) return {};
  struct CostOfStudy {
    Metric cost;
    StudyResults study;
    std::optional<Clusters> clusters = {};
  };
  const StudyResults study = at_median_speed(measured);
  CostOfStudy evaluations{Metric::evaluations, compared_in(study, Metric::evaluations)},
      seconds{Metric::seconds, compared_in(study, Metric::seconds)};
  seconds.clusters.emplace(seconds.study);
  evaluations.clusters.emplace(evaluations.study, &*seconds.clusters);
  std::vector<const CostOfStudy*> costs;
  if (std::isfinite(tolerance_cm(study))) {
    if (!evaluations.study.solves.empty()) costs.push_back(&evaluations);
    if (times_are_comparable(study)) costs.push_back(&seconds);
  }
  std::vector<Table> tables;
  const auto add = [&](Table table, const CostOfStudy& of) {
    std::ranges::move(list_of(left_out(study, of.cost)), std::back_inserter(table.notes));
    tables.push_back(std::move(table));
  };
  for (const CostOfStudy* of : costs) add(cost_table(of->study, of->cost, *of->clusters), *of);
  for (const CostOfStudy* of : costs) {
    if (of->study.solvers.size() > 1) add(cost_pair_table(of->study, of->cost, *of->clusters), *of);
  }
  if (std::optional<Table> table = anytime_table(evaluations.study, *evaluations.clusters)) {
    add(std::move(*table), evaluations);
  }
  return tables;
}

}  // namespace ikbench::report
