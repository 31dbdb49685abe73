// The paper's printed numbers (results/published) as its tables and figures need them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/claims/printed.hpp"

namespace ikbench::slim2023 {

using claims::PrintedRow;
using claims::PrintedTime;

// The paper's metrics, and the numbers of their printed pieces: the table of the ANOVA, the figures of curves over the
// points and of box plots.
constexpr std::array<inference::Metric, 3> paper_metrics{inference::Metric::position_error_cm,
                                                         inference::Metric::variation_deg, inference::Metric::seconds};
struct PaperNumbers {
  int anova_table, curves_figure, box_figure;
};
const PaperNumbers& paper_numbers(inference::Metric metric);  // std::out_of_range for other metrics

// The rows of the printed Table 3 for one metric, if the study is comparable: on Table 3's path. A circle is Table 8's,
// random targets are Table 7's, whatever the labels of the solvers.
std::vector<PrintedRow> printed_table_3(const inference::StudyResults& study, inference::Metric metric);
std::optional<PrintedRow> printed_row(const inference::StudyResults& study, std::string_view algorithm,
                                      inference::Metric metric);

// The printed ANOVA of that metric (Tables 4 to 6), if it answers the same question as the study's.
std::optional<statistics::AnovaTable> comparable_printed_anova(const inference::StudyResults& study,
                                                               inference::Metric metric);

// Table 7: times of IK-BA to the tolerance, by number of bats.
std::vector<PrintedTime> printed_table_7(std::string_view paper);  // empty if it is not published

// A row of the printed Table 8.
struct PrintedPosture {
  int point;
  std::array<double, 4> angles_deg;  // theta1 to theta4, which equals theta1
  double error_cm;
};
std::vector<PrintedPosture> printed_table_8(std::string_view paper);  // empty if it is not published

}  // namespace ikbench::slim2023
