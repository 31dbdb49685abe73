#include "analysis/slim2023/published_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace ikbench::slim2023 {

using namespace results;
using namespace statistics;
using namespace inference;

const PaperNumbers& paper_numbers(Metric metric) {
  static const std::map<Metric, PaperNumbers> numbers{
      {Metric::position_error_cm, {4, 6, 10}}, {Metric::variation_deg, {5, 7, 11}}, {Metric::seconds, {6, 8, 12}}};
  return numbers.at(metric);
}

std::vector<PrintedRow> printed_table_3(const StudyResults& study, Metric metric) {
  const std::string& path = study.facts.path;
  return path == "circle" || path == "random" ? std::vector<PrintedRow>()
                                              : claims::printed_rows(study.facts.published, "table-3", metric);
}

std::optional<PrintedRow> printed_row(const StudyResults& study, std::string_view algorithm, Metric metric) {
  const std::vector<PrintedRow> rows = printed_table_3(study, metric);
  const auto row = std::ranges::find(rows, algorithm, &PrintedRow::algorithm);
  return row == rows.end() ? std::nullopt : std::optional(*row);
}

std::optional<AnovaTable> comparable_printed_anova(const StudyResults& study, Metric metric) {
  if (std::ranges::count(paper_metrics, metric) == 0) return std::nullopt;
  return claims::comparable_anova(study, printed_table_3(study, metric),
                                  fmt::format("table-{}", paper_numbers(metric).anova_table));
}

std::vector<PrintedTime> printed_table_7(std::string_view paper) {
  return claims::printed_times(paper, "table-7", "{bats} bats");
}

std::vector<PrintedPosture> printed_table_8(std::string_view paper) {
  std::vector<PrintedPosture> rows;
  const CsvTable table = claims::printed_table(paper, "table-8");
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    rows.push_back({.point = static_cast<int>(table.number(row, "point")),
                    .angles_deg = {table.number(row, "theta1_deg"), table.number(row, "theta2_deg"),
                                   table.number(row, "theta3_deg"), table.number(row, "theta1_deg")},
                    .error_cm = table.number(row, "error_cm")});
  }
  return rows;
}

}  // namespace ikbench::slim2023
