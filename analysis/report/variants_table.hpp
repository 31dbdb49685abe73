// What comparisons of variants say, as a table, in words and as JSON.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/inference/variants.hpp"
#include "analysis/report/table.hpp"

namespace ikbench::report {

// One row a label and metric, everything that is known of it. a12: P(an observation of B is better than one of A).
Table variants_table(std::span<const inference::VariantComparison> comparisons,
                     const inference::MarginQuestion& question);
// The designs and the notes, with their label; what holds for every label is said once, without.
std::vector<std::string> variants_notes(std::span<const inference::VariantComparison> comparisons);
// Whether a regression beyond the margin is shown, by how much and how sure; then how many outcomes there are of each
// kind, and with how many runs those would be decided that are not.
std::string variants_verdict(std::span<const inference::VariantComparison> comparisons,
                             const inference::MarginQuestion& question);
// One object: verdict, significance, margin, notes and rows, each as in the table; null where nothing is defined.
std::string variants_json(std::span<const inference::VariantComparison> comparisons,
                          const inference::MarginQuestion& question);

}  // namespace ikbench::report
