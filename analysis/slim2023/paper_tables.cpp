#include "analysis/slim2023/paper_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "analysis/inference/comparable.hpp"
#include "analysis/slim2023/agreement.hpp"
#include "analysis/slim2023/circle.hpp"
#include "analysis/slim2023/published_numbers.hpp"
#include "analysis/slim2023/time_assessment.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;
using namespace report;

namespace {

Cell text(std::string_view words) { return std::string(words); }

Graded by_ratio(double ratio) {
  const Nearness nearness = nearness_of(ratio);
  return {nearness == Nearness::unknown ? "not defined" : nearness == Nearness::near ? "near" : "far", nearness};
}

double mean_of(const std::vector<Comparison>& rows, std::string_view solver, Metric metric) {
  for (const Comparison& row : rows) {
    if (row.solver == solver && row.metric == metric) return row.ours.mean;
  }
  return not_defined;
}

// The printed times are of another machine and language: only their ratio to IK-BA's can be compared.
void hold_against_printed_time(Comparison& row, double our_reference, const StudyResults& study) {
  const auto printed = printed_row(study, row.solver, Metric::seconds);
  const auto printed_reference = printed_row(study, time_reference, Metric::seconds);
  if (!printed || !printed_reference) return;
  row.paper_mean = printed->printed.mean;
  row.remark.words = times_not_judged;
  if (!times_are_comparable(study) || solvers_left_out(study, Metric::seconds).contains(row.solver)) return;
  row.ratio = (row.ours.mean / our_reference) / (row.paper_mean / printed_reference->printed.mean);
  if (!std::isfinite(our_reference)) {
    row.remark.words = fmt::format("no time of {} to compare with", time_reference);
    return;
  }
  const bool is_reference = row.solver == time_reference;
  row.remark = is_reference ? Graded{"the reference"} : by_ratio(row.ratio);
  row.remark.words = "relative only: " + row.remark.words;
}

// The printed cells beside the rows of an ANOVA, the last three of a table.
void add_printed_anova(Table& table, const std::optional<AnovaTable>& printed) {
  if (table.columns.back() == "p") {
    for (const char* name : {"SS", "df", "MS", "F", "p"}) table.columns.push_back(fmt::format("paper_{}", name));
  }
  auto row = table.rows.end() - anova_sources.size();
  for (std::size_t i = 0; i < anova_sources.size(); ++i, ++row) {
    const std::vector<Cell> cells = printed ? anova_cells(*printed)[i] : std::vector<Cell>();
    row->insert(row->end(), cells.begin(), cells.end());
    row->resize(table.columns.size());
  }
}

}  // namespace

std::vector<Comparison> compare(const StudyResults& study, std::span<const RepeatedSolver> repetitions) {
  std::vector<Comparison> rows;
  for (const Metric metric : paper_metrics) {
    for (const Sample& sample : samples(study, metric)) {
      rows.push_back({.solver = sample.solver, .metric = metric, .ours = describe(sample.values)});
    }
  }
  if (study.facts.published.empty()) return rows;
  const double our_reference = mean_of(rows, time_reference, Metric::seconds);
  for (Comparison& row : rows) {
    if (row.metric == Metric::seconds) {
      hold_against_printed_time(row, our_reference, study);
    } else if (const auto printed = printed_row(study, row.solver, row.metric)) {
      row.paper_mean = printed->printed.mean;
      row.ratio = row.ours.mean / row.paper_mean;
      row.remark = by_ratio(row.ratio);
    }
  }
  for (const Agreement& each : agreements(study, repetitions)) {
    const auto is_its = [&](const Comparison& row) {
      return each.statistic == "mean" && row.solver == each.solver && row.metric == each.metric;
    };
    const auto row = std::ranges::find_if(rows, is_its);
    if (row != rows.end()) row->remark = {words_of(each), nearness_of(each)};
  }
  return rows;
}

Table table_3(const StudyResults& study, std::span<const RepeatedSolver> repetitions) {
  Table table = results_table(study, paper_metrics);
  table.name = "table-3";
  table.number = 3;
  table.caption = "position error, angles variation and computing time";
  table.columns.insert(table.columns.end(), {"paper_mean", "ratio", "verdict"});
  const std::vector<Comparison> compared = compare(study, repetitions);  // row by row
  for (std::size_t i = 0; i < compared.size(); ++i) {
    const bool printed = std::isfinite(compared[i].paper_mean);
    table.rows[i].push_back(printed ? Cell(compared[i].paper_mean) : Cell());
    table.rows[i].push_back(printed ? Cell(compared[i].ratio) : Cell());
    table.rows[i].push_back(printed ? Cell(compared[i].remark) : Cell());
  }
  if (printed_table_3(study, Metric::position_error_cm).empty()) return table;
  std::string note = fmt::format(
      "Verdict: {} Computing times are compared relative to {}: our t / t_{} divided by the printed t / t_{}.",
      repetitions.empty()
          ? fmt::format(
                "near if our mean is less than {} times as much or as little as the printed one; otherwise far. "
                "(`ikbench reproduce` says which numbers repetitions of the study would give.)",
                near_ratio)
          : "whether the printed mean lies within the 95 % predictive range of our studies (table agreement).",
      time_reference, time_reference, time_reference);
  table.notes.push_back(std::move(note));
  if (!repetitions.empty()) {
    table.notes.emplace_back(
        "Table agreement has the same numbers, rounded, each beside the printed one. Here they have more digits, times are "
        "in seconds, and only means are compared.");
  }
  return table;
}

Table table_3_as_printed(std::string_view paper) {
  Table table{.name = "table-3-as-printed", .caption = "Table 3 as printed"};
  const CsvTable printed = claims::printed_table(paper, "table-3");
  table.columns = printed.header;
  for (const std::vector<std::string>& row : printed.rows) table.rows.emplace_back(row.begin(), row.end());
  return table;
}

Table printed_anova_table(const StudyResults& study, Metric metric) {
  const int number = paper_numbers(metric).anova_table;
  Table table = anova_table(study, metric);
  table.name = fmt::format("table-{}", number);
  table.number = number;
  table.caption = fmt::format("one-way ANOVA of the {}", quantity(metric));
  add_printed_anova(table, comparable_printed_anova(study, metric));
  return table;
}

Table anova_from_printed_table_3(std::string_view paper) {
  Table table{.name = "anova-from-printed-table-3",
              .caption = "Tables 4-6 recomputed from the means and standard deviations printed in Table 3",
              .columns = {"metric", "source", "SS", "df", "MS", "F", "p"}};
  for (const Metric metric : paper_metrics) {
    std::vector<GroupSummary> groups;
    for (const PrintedRow& row : claims::printed_rows(paper, "table-3", metric)) groups.push_back(row.summary());
    const auto printed = claims::printed_anova(paper, fmt::format("table-{}", paper_numbers(metric).anova_table));
    const auto cells = anova_cells(anova_from_summaries(groups));
    for (std::size_t i = 0; i < anova_sources.size(); ++i) {
      std::vector<Cell>& row =
          table.rows.emplace_back(std::vector<Cell>{text(name_of(metric)), text(anova_sources[i])});
      row.insert(row.end(), cells[i].begin(), cells[i].end());
    }
    add_printed_anova(table, printed);
    for (auto row = table.rows.end() - anova_sources.size(); row != table.rows.end(); ++row) row->emplace_back();
    if (printed) {
      const double p = f_upper_tail(printed->F, printed->df_between, printed->df_within);
      table.rows[table.rows.size() - anova_sources.size()].back() = PValue{p};
    }
  }
  table.columns.emplace_back("p_of_paper_F");
  table.notes.emplace_back(
      "This table uses printed numbers only and checks them against each other. The differences come from rounding in "
      "the printed numbers. p_of_paper_F is the upper tail of the F distribution at the printed F.");
  return table;
}

std::vector<Table> paper_tables(const StudyResults& study, std::span<const RepeatedSolver> repetitions) {
  const bool is_published = !printed_table_3(study, Metric::position_error_cm).empty();
  std::vector<Table> tables{table_3(study, repetitions)};
  if (std::optional<Table> table = agreement_table(study, repetitions)) tables.push_back(std::move(*table));
  if (is_published) tables.push_back(table_3_as_printed(study.facts.published));
  for (const Metric metric : paper_metrics) tables.push_back(printed_anova_table(study, metric));
  if (is_published) tables.push_back(anova_from_printed_table_3(study.facts.published));
  if (std::optional<Table> table = table_7(study)) tables.push_back(std::move(*table));
  if (std::optional<Table> table = table_8(study)) tables.push_back(std::move(*table));
  return tables;
}

}  // namespace ikbench::slim2023
