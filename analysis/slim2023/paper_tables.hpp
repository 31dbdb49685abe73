// The tables of Slim et al. (2023) for any study, beside the printed numbers where there are any: Table 3 (what was
// reached), Tables 4-6 (one-way ANOVA of error, variation and time), and Table 7 (time_assessment.hpp) and 8
// (circle.hpp) of the studies that are like the paper's.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/study.hpp"
#include "analysis/report/repetitions.hpp"
#include "analysis/report/study_tables.hpp"
#include "analysis/statistics/anova.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::slim2023 {

// One row of Table 3, with the printed mean and a remark on both.
struct Comparison {
  std::string solver;
  inference::Metric metric;
  statistics::Description ours;
  double paper_mean = statistics::not_defined;
  double ratio =
      statistics::not_defined;  // ours by the printed mean; for seconds, both first divided by those of IK-BA
  report::Graded remark = {};   // "in our range"; empty where there is nothing to hold it against
};

constexpr std::string_view time_reference = "IK-BA";

// `repetitions` are the run means of the same study by seed; without them, there are only ratios.
std::vector<Comparison> compare(const inference::StudyResults& study,
                                std::span<const report::RepeatedSolver> repetitions = {});

report::Table table_3(const inference::StudyResults& study, std::span<const report::RepeatedSolver> repetitions = {});
report::Table table_3_as_printed(std::string_view paper);
report::Table printed_anova_table(const inference::StudyResults& study,
                                  inference::Metric metric);  // table-4, table-5, table-6
report::Table anova_from_printed_table_3(std::string_view paper);

// Every table above that the study has, in the paper's order.
std::vector<report::Table> paper_tables(const inference::StudyResults& study,
                                        std::span<const report::RepeatedSolver> repetitions = {});

}  // namespace ikbench::slim2023
