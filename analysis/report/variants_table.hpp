// Writes comparisons of variants as a table, in words and as JSON.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/variant_comparison.hpp"
#include "analysis/report/table.hpp"
#include "results/analysis_plan.hpp"

namespace ikbench::report {

// One row per label and metric. a12: for pairs the share in which B is better, else P(an observation of B is better).
// The plan gives margins and significance.
Table variants_table(std::span<const inference::VariantComparison> comparisons, const results::AnalysisPlan& plan);
// The columns of a reader: label, metric, B_is, mean_A, mean_B, B_by_A, its interval and p. The table may have others.
Table short_table(const Table& table);
// Says what a metric of B is: "better by more than 5 %", "undecided".
std::string verdict_of(std::span<const inference::VariantComparison> comparisons,
                       const inference::MetricComparison& metric, const results::AnalysisPlan& plan);
// Designs and notes with their label; one that holds for every label appears once, without label.
std::vector<std::string> variants_notes(std::span<const inference::VariantComparison> comparisons);
// Says whether a regression beyond the margin is shown, by how much and how sure, or of two labels what is undecided
// and what would decide it; then counts the metrics of each verdict.
std::string variants_verdict(std::span<const inference::VariantComparison> comparisons,
                             const results::AnalysisPlan& plan);
// One object: outcome and exit code of the command, verdict, significance, margin, notes and the rows of the table;
// null for undefined numbers.
struct Outcome {
  std::string_view name;  // "passed", "worse", "undecided", "more_runs"
  int exit_code = 0;
};
std::string variants_json(std::span<const inference::VariantComparison> comparisons, const results::AnalysisPlan& plan,
                          const Outcome& outcome);

}  // namespace ikbench::report
