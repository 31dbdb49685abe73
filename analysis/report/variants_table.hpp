// Writes comparisons of variants as a table, in words and as JSON.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/inference/variants.hpp"
#include "analysis/report/table.hpp"
#include "results/analysis_plan.hpp"

namespace ikbench::report {

// Comparisons with the plan that gives margins and significance.
struct VariantsReport {
  std::span<const inference::VariantComparison> comparisons;
  const results::AnalysisPlan& plan;
};

// One row per label and metric. a12: for pairs the share in which B is better, else P(an observation of B is better).
Table variants_table(const VariantsReport& of);
// Designs and notes with their label; one that holds for every label appears once, without label.
std::vector<std::string> variants_notes(const VariantsReport& of);
// Says whether a regression beyond the margin is shown, by how much and how sure; then counts the metrics of each
// verdict.
std::string variants_verdict(const VariantsReport& of);
// One object: verdict, significance, margin, notes and the rows of the table; null for undefined numbers.
std::string variants_json(const VariantsReport& of);

}  // namespace ikbench::report
