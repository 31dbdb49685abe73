// The paper's printed numbers (results/published) as the analysis needs them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/study.hpp"
#include "analysis/statistics/anova.hpp"

namespace ikbench::slim2023 {

// What the paper measured, and by which numbers it prints that: the table of its ANOVA, the figures of its curves over
// the points and of its box plots.
constexpr std::array<inference::Metric, 3> paper_metrics{inference::Metric::position_error_cm,
                                                         inference::Metric::variation_deg, inference::Metric::seconds};
struct PaperNumbers {
  int anova_table, curves_figure, box_figure;
};
const PaperNumbers& paper_numbers(inference::Metric metric);  // std::out_of_range for what the paper did not measure

struct PrintedRow {
  std::string algorithm;
  statistics::GroupSummary summary;
  double median = statistics::not_defined;
  double max = statistics::not_defined;
  double min = statistics::not_defined;
  double min_resolution = statistics::not_defined;  // half a unit of its last printed digit
};

// The rows of the printed Table 3 for one metric; none where nothing is published, or the paper has no such metric.
std::vector<PrintedRow> printed_table_3(std::string_view paper, inference::Metric metric);
// The same for a study that can be held against it: one on Table 3's path. A circle is Table 8's, random targets are
// Table 7's, whatever the labels of the solvers.
std::vector<PrintedRow> printed_table_3(const inference::StudyResults& study, inference::Metric metric);
std::optional<PrintedRow> printed_row(std::string_view paper, std::string_view algorithm, inference::Metric metric);
std::optional<PrintedRow> printed_row(const inference::StudyResults& study, std::string_view algorithm,
                                      inference::Metric metric);

// A printed ANOVA (Tables 4-6: error, variation, time), cells as printed; nothing where it is not published.
std::optional<statistics::AnovaTable> printed_anova(std::string_view paper, inference::Metric metric);

// A row of the printed Table 7: times until IK-BA with so many bats comes to the tolerance.
struct PrintedTime {
  int bats;
  double mean_ms, median_ms, std_ms, max_ms, min_ms;
};
std::vector<PrintedTime> printed_table_7(std::string_view paper);  // none where it is not published

// A row of the printed Table 8.
struct PrintedPosture {
  int point;
  std::array<double, 4> angles_deg;  // theta1 to theta4, which equals theta1
  double error_cm;
};
std::vector<PrintedPosture> printed_table_8(std::string_view paper);  // none where it is not published

}  // namespace ikbench::slim2023
