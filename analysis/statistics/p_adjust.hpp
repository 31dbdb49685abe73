// P-values of several tests, adjusted for there being several: what R's p.adjust computes.
#pragma once

#include <span>
#include <vector>

namespace ikbench::statistics {

enum class Correction {
  holm,                // Scandinavian J. Statistics 6 (1979) 65: family-wise, any dependence
  hochberg,            // Biometrika 75 (1988) 800: family-wise, independent or positively dependent tests
  bonferroni,          // family-wise, any dependence
  benjamini_hochberg,  // J. Royal Statistical Society B 57 (1995) 289: the expected share of false findings
};

// In the order given. A p that is NaN (a test that could not be made) stays NaN and does not count; the others are 0 to
// 1, anything else is std::invalid_argument.
std::vector<double> adjusted(std::span<const double> p, Correction correction);

}  // namespace ikbench::statistics
