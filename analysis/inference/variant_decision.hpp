// What the tests of several metrics say together, and in words what they leave open.
#pragma once

#include <span>

#include "analysis/inference/variant_metric.hpp"

namespace ikbench::inference {

// The outcomes of several metrics: worse and better where Holm's correction over all of them leaves p below the
// significance; same where both one-sided tests of equivalence are below it (Schuirmann, J. Pharmacokinetics and
// Biopharmaceutics 15 (1987) 657), which a claim of "all the same" need not correct (Berger, Technometrics 24 (1982)
// 295).
void decide(std::span<MetricComparison> comparisons, const MarginQuestion& question);

}  // namespace ikbench::inference
