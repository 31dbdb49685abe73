// Is a value of one sample as often below as above one of the other, whatever their spreads? Brunner and Munzel,
// Biometrical J. 42 (2000) 17.
#pragma once

#include <span>
#include <string>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

// The statistic is positive if `first` is the larger, and infinite if no two values overlap. Then no variance is left
// to test with, and p is that of the statistic's permutations: 2 n1! n2! / (n1 + n2)! (Neubert and Brunner,
// Computational Statistics & Data Analysis 51 (2007) 5192). df are of Student's t, by Satterthwaite.
Test brunner_munzel(std::span<const double> first, std::span<const double> second);

}  // namespace ikbench::statistics
