#include "analysis/slim2023/published_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "analysis/claims/printed.hpp"
#include "analysis/inference/study_facts.hpp"
#include "results/published.hpp"

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;

namespace {

// Without rows where there is no such table.
CsvTable printed_table(std::string_view paper, std::string_view name) {
  const auto names = published::tables(paper);
  return std::ranges::find(names, name) == names.end() ? CsvTable() : published::table(paper, name);
}

std::optional<PrintedRow> row_of(const std::vector<PrintedRow>& rows, std::string_view algorithm) {
  for (const PrintedRow& row : rows) {
    if (row.algorithm == algorithm) return row;
  }
  return std::nullopt;
}

}  // namespace

const PaperNumbers& paper_numbers(Metric metric) {
  static const std::map<Metric, PaperNumbers> numbers{
      {Metric::position_error_cm, {4, 6, 10}}, {Metric::variation_deg, {5, 7, 11}}, {Metric::seconds, {6, 8, 12}}};
  return numbers.at(metric);
}

std::vector<PrintedRow> printed_table_3(std::string_view paper, Metric metric) {
  std::vector<PrintedRow> rows;
  const CsvTable table = printed_table(paper, "table-3");
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (table.rows[row][table.column("metric")] != name_of(metric)) continue;
    rows.push_back({.algorithm = table.rows[row][table.column("algorithm")],
                    .summary = {.mean = table.number(row, "mean"),
                                .std = table.number(row, "std"),
                                .n = static_cast<int>(table.number(row, "n"))},
                    .median = table.number(row, "median"),
                    .max = table.number(row, "max"),
                    .min = table.number(row, "min"),
                    .min_resolution = claims::half_unit(table.rows[row][table.column("min")])});
  }
  return rows;
}

std::vector<PrintedRow> printed_table_3(const StudyResults& study, Metric metric) {
  const std::string& path = study.facts.path.kind;
  return path == "circle" || path == "random" ? std::vector<PrintedRow>()
                                              : printed_table_3(study.facts.published, metric);
}

std::optional<PrintedRow> printed_row(std::string_view paper, std::string_view algorithm, Metric metric) {
  return row_of(printed_table_3(paper, metric), algorithm);
}

std::optional<PrintedRow> printed_row(const StudyResults& study, std::string_view algorithm, Metric metric) {
  return row_of(printed_table_3(study, metric), algorithm);
}

std::optional<AnovaTable> printed_anova(std::string_view paper, Metric metric) {
  if (std::ranges::find(paper_metrics, metric) == paper_metrics.end()) return std::nullopt;
  const std::string name = fmt::format("table-{}", paper_numbers(metric).anova_table);
  const CsvTable table = printed_table(paper, name);
  if (table.rows.empty()) return std::nullopt;
  constexpr std::size_t between = 0, within = 1, total = 2;
  AnovaTable printed;
  printed.ss_between = table.number(between, "ss");
  printed.ss_within = table.number(within, "ss");
  printed.ss_total = table.number(total, "ss");
  printed.df_between = static_cast<int>(table.number(between, "df"));
  printed.df_within = static_cast<int>(table.number(within, "df"));
  printed.ms_between = table.number(between, "ms");
  printed.ms_within = table.number(within, "ms");
  printed.F = table.number(between, "f");
  printed.p = table.number(between, "p");
  return printed;
}

std::vector<PrintedTime> printed_table_7(std::string_view paper) {
  std::vector<PrintedTime> rows;
  const CsvTable table = printed_table(paper, "table-7");
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    rows.push_back({.bats = static_cast<int>(table.number(row, "bats")),
                    .mean_ms = table.number(row, "mean_ms"),
                    .median_ms = table.number(row, "median_ms"),
                    .std_ms = table.number(row, "std_ms"),
                    .max_ms = table.number(row, "max_ms"),
                    .min_ms = table.number(row, "min_ms")});
  }
  return rows;
}

std::vector<PrintedPosture> printed_table_8(std::string_view paper) {
  std::vector<PrintedPosture> rows;
  const CsvTable table = printed_table(paper, "table-8");
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    rows.push_back({.point = static_cast<int>(table.number(row, "point")),
                    .angles_deg = {table.number(row, "theta1_deg"), table.number(row, "theta2_deg"),
                                   table.number(row, "theta3_deg"), table.number(row, "theta1_deg")},
                    .error_cm = table.number(row, "error_cm")});
  }
  return rows;
}

}  // namespace ikbench::slim2023
