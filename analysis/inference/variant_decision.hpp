// What the tests of all labels and metrics of a comparison say together, and in words what they leave open.
#pragma once

#include <span>

#include "analysis/inference/variants.hpp"

namespace ikbench::inference {

// The outcomes: worse and better where Holm's correction over every label and metric leaves p below the significance,
// so that one that is not worse is called so anywhere with that probability at most; same where both one-sided tests of
// equivalence are below it (Schuirmann, J. Pharmacokinetics and Biopharmaceutics 15 (1987) 657), which a claim of "all
// the same" need not correct (Berger, Technometrics 24 (1982) 295), and better or worse by less where the corrected
// test of the difference is too. p_worse, p_better, p_difference and p_ranks are left as corrected.
void decide(std::span<VariantComparison> comparisons, const MarginQuestion& question);

}  // namespace ikbench::inference
