// What comparisons of variants say, as a table, in words and as JSON.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/inference/variants.hpp"
#include "analysis/report/table.hpp"
#include "results/analysis_plan.hpp"

namespace ikbench::report {

// What a comparison is made by: margins and significance are those of `plan`.
struct VariantsReport {
  std::span<const inference::VariantComparison> comparisons;
  const results::AnalysisPlan& plan;
};

// One row a label and metric. a12: in pairs the share in which B is better, else P(an observation of B is better).
Table variants_table(const VariantsReport& of);
// The designs and the notes, with their label; what holds for every label is said once, without.
std::vector<std::string> variants_notes(const VariantsReport& of);
// Whether a regression beyond the margin is shown, by how much and how sure; then how many metrics there are of each
// kind.
std::string variants_verdict(const VariantsReport& of);
// One object: verdict, significance, margin, notes and rows, each as in the table; null where nothing is defined.
std::string variants_json(const VariantsReport& of);

}  // namespace ikbench::report
