// The paper's printed numbers (results/published) as the analysis needs them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/anova.hpp"
#include "analysis/study.hpp"

namespace ikbench {

struct PrintedRow {
  std::string algorithm;
  GroupSummary summary;
  double median = not_defined;
  double max = not_defined;
  double min = not_defined;
};

// The rows of the printed Table 3 for one metric; none where nothing is published, or the paper has no such metric.
std::vector<PrintedRow> printed_table_3(std::string_view paper, Metric metric);
std::optional<PrintedRow> printed_row(std::string_view paper, std::string_view algorithm, Metric metric);

// A printed ANOVA (Tables 4-6: error, variation, time), cells as printed; nothing where it is not published.
std::optional<AnovaTable> printed_anova(std::string_view paper, Metric metric);

// Half a unit of the last printed digit: what rounding may have taken from, or added to, "1.7824e-4".
double half_unit(std::string_view printed);

}  // namespace ikbench
