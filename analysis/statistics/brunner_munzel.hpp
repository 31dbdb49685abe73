// Is a value of one sample as often below as above one of the other, whatever their spreads? Brunner and Munzel,
// Biometrical J. 42 (2000) 17.
#pragma once

#include <span>
#include <string>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::statistics {

struct BrunnerMunzel {
  double above = not_defined;      // the chance that a value of `first` is above one of `second`, equal ones half
  double statistic = not_defined;  // positive if `first` is the larger; infinite if no two values overlap
  double df = not_defined;         // of Student's t, by Satterthwaite
  double p = not_defined;          // two-sided. Without overlap, where no variance is left to test with, that of the
                           // statistic's permutations: 2 n1! n2! / (n1 + n2)! (Neubert and Brunner, Computational
                           // Statistics & Data Analysis 51 (2007) 5192)
  std::string undefined;  // why there is no p; empty if there is one
};

BrunnerMunzel brunner_munzel(std::span<const double> first, std::span<const double> second);

}  // namespace ikbench::statistics
