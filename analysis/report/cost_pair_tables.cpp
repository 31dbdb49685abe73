#include "analysis/report/cost_pair_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/anytime.hpp"
#include "analysis/inference/cost_comparison.hpp"
#include "analysis/inference/text.hpp"

namespace ikbench::report {

using namespace statistics;
using namespace inference;

namespace {

Cell range_of(const Interval& interval) {
  return std::isnan(interval.low) ? Cell() : Cell(Range{interval.low, interval.high});
}

std::string together_note(const Clusters& clusters, double significance) {
  if (!clusters.undefined().empty()) return fmt::format("There are no intervals: {}.", clusters.undefined());
  return fmt::format(
      "The {0} are drawn with all their solves, the same for all solvers, in {1} bootstrap samples. Intervals of "
      "differences and ratios hold together in their column at {2} (largest studentized deviation). An interval without "
      "width means that all {0} agree, not that it is certain.",
      clusters.noun(), clusters.replicates().size(), percent(1 - significance));
}

std::string_view word(Relation relation) {
  return relation == Relation::better ? "ahead" : relation == Relation::worse ? "behind" : "open";
}

// "at 10 %: A", "at 30 %: open between A and B".
std::string answer_at(const std::vector<AtBudget>& standings, const std::vector<std::string>& solvers) {
  std::string open;
  for (std::size_t i = 0; i < standings.size(); ++i) {
    if (standings[i].relation == Relation::better) return one_line(solvers[i]);
    if (standings[i].relation != Relation::undecided || std::isnan(standings[i].share)) continue;
    open += (open.empty() ? "" : ", ") + one_line(solvers[i]);
  }
  return "open between " + open;
}

}  // namespace

Table cost_pair_table(const StudyResults& study, Cost cost, const Clusters& clusters) {
  const bool in_seconds = cost == Cost::seconds;
  Table table{.name = in_seconds ? "statistics-cost-seconds-pairs" : "statistics-cost-pairs",
              .caption = fmt::format("Which of two solvers spends fewer {} until {}",
                                     in_seconds ? "seconds" : "evaluations", words(tolerance(study))),
              .columns = {{"first", Align::left},
                          {"second", Align::left},
                          {"spends less", Align::left},
                          {"ert ratio"},
                          {"ert ratio interval"},
                          {"restricted_mean ratio"},
                          {"restricted_mean ratio interval"},
                          {"probability of improvement"},
                          {"probability interval"}}};
  for (const CostPair& pair : compare_costs(study, cost, clusters)) {
    const std::string& first = study.solvers[pair.first];
    const std::string& second = study.solvers[pair.second];
    table.rows.push_back({first, second,
                          pair.relation == Relation::better  ? first
                          : pair.relation == Relation::worse ? second
                                                             : std::string("open"),
                          pair.expected.value, range_of(pair.expected.interval), pair.restricted.value,
                          range_of(pair.restricted.interval), pair.improvement.value,
                          range_of(pair.improvement.interval)});
  }
  table.notes = {
      "Ratios are first / second: below 1 the first spends less. The interval of the ert ratio decides, or without one "
      "that of the restricted_mean ratio; if the two contradict each other, or all runs of each solver are equal, the pair is open. probability of "
      "improvement: how often the first spends less than the second at the same target; ties count half, and solves "
      "that do not reach the tolerance tie.",
      together_note(clusters, study.plan.significance)};
  return table;
}

std::optional<Table> anytime_table(const StudyResults& study, const Clusters& clusters) {
  const std::optional<Anytime> found = anytime(study, clusters);
  if (!found) return std::nullopt;
  const Tolerance within = tolerance(study);
  Table table{.name = "statistics-cost-anytime",
              .caption = std::isfinite(within.cm)
                             ? fmt::format("Share of solves in which {} within a part of the budget", words(within))
                             : "Share of solves and target errors that are reached within a part of the budget",
              .columns = {{"part of budget"},
                          {"evaluations"},
                          {"solver", Align::left},
                          {"share"},
                          {"share interval"},
                          {"behind by"},
                          {"behind interval"},
                          {"position", Align::left}}};
  std::string answers;
  for (std::size_t k = 0; k < budget_parts.size(); ++k) {
    for (std::size_t i = 0; i < study.solvers.size(); ++i) {
      const AtBudget& standing = found->standings[k][i];
      table.rows.push_back({percent(budget_parts[k]), budget_parts[k] * found->budget, study.solvers[i], standing.share,
                            range_of(standing.share_interval), standing.behind, range_of(standing.behind_interval),
                            std::string(word(standing.relation))});
    }
    answers += fmt::format("{} at {}: {}", k == 0 ? "" : ";", percent(budget_parts[k]),
                           answer_at(found->standings[k], study.solvers));
  }
  table.notes = {fmt::format("Ahead{}.", answers),
                 fmt::format("The budget is {} evaluations, {}. behind by: the largest share at that budget, less this "
                             "one. ahead: above every other; behind: below the largest; open: neither is shown.",
                             rounded_number(found->budget, 6),
                             found->is_of_study ? "the study's limit" : "those of the longest solve"),
                 together_note(clusters, study.plan.significance)};
  return table;
}

}  // namespace ikbench::report
