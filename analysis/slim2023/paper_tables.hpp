// The tables of Slim et al. (2023) for any study, beside the printed numbers where there are any: Table 3 (what was
// reached), Tables 4-6 (one-way ANOVA of error, variation and time), Table 7 (time_assessment.hpp) and 8 (circle.hpp)
// of the studies that are like the paper's, and the status of every solve.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/study.hpp"
#include "analysis/report/study_tables.hpp"
#include "analysis/statistics/anova.hpp"
#include "analysis/statistics/descriptive.hpp"

namespace ikbench::slim2023 {

// How a number of ours stands to the printed one: `agrees` when a test of the two summaries does not tell them apart,
// `close` when their ratio is within 0.5 to 2, else `differs`; `none` where there is nothing to hold it against, and
// `not_comparable` of times that are not.
enum class Agreement { none, agrees, close, differs, not_comparable };
std::string_view name_of(Agreement agreement);

// One row of Table 3, with the printed mean.
struct Comparison {
  std::string solver;
  inference::Metric metric;
  statistics::Description ours;
  double paper_mean = statistics::not_defined;
  double ratio =
      statistics::not_defined;  // ours by the printed mean; for seconds, both first divided by those of IK-BA
  Agreement agreement = Agreement::none;
};

// Agrees by Welch's test, though the ratio is not within 0.5 to 2: the spread is too large to tell the two apart.
bool rests_on_spread(const Comparison& row);

constexpr std::string_view time_reference = "IK-BA";

std::vector<Comparison> compare(const inference::StudyResults& study);

// The printed ANOVA of that metric where it answers the same question: the same solvers, runs as observations.
std::optional<statistics::AnovaTable> comparable_printed_anova(const inference::StudyResults& study,
                                                               inference::Metric metric);

report::Table table_3(const inference::StudyResults& study);
report::Table table_3_as_printed(std::string_view paper);
report::Table printed_anova_table(const inference::StudyResults& study,
                                  inference::Metric metric);  // table-4, table-5, table-6
report::Table anova_from_printed_table_3(std::string_view paper);

// Every table above that the study has, in the paper's order.
std::vector<report::Table> paper_tables(const inference::StudyResults& study);

}  // namespace ikbench::slim2023
