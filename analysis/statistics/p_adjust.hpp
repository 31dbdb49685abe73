// Adjusts p-values for several tests, as R's p.adjust does.
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

// Adjusted p-values in the given order. A p that is NaN (a test that could not be made) stays NaN and does not count.
// The others must be 0 to 1; anything else throws std::invalid_argument.
std::vector<double> adjusted(std::span<const double> p, Correction correction);

}  // namespace ikbench::statistics
