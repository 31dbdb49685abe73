#include "analysis/statistics/sign_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "analysis/statistics/paired_proportion.hpp"
#include "analysis/statistics/rounding.hpp"

namespace ikbench::statistics {

Test sign_test(std::span<const double> first, std::span<const double> second) {
  Test test;
  int above = 0, below = 0;
  if (first.size() != second.size()) {
    test.undefined = fmt::format("{} and {} values are not pairs", first.size(), second.size());
    return test;
  }
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double difference = first[i] == second[i] ? 0 : first[i] - second[i];
    if (std::isnan(difference)) test.undefined = "a value is not a number";
    const double size = std::max(std::abs(first[i]), std::abs(second[i]));
    const int sign = sign_of(std::isfinite(difference) ? without_rounding(difference, size) : difference);
    above += sign > 0 ? 1 : 0;
    below += sign < 0 ? 1 : 0;
  }
  if (first.empty()) test.undefined = "there are no differences";
  if (test.undefined.empty() && above + below == 0) test.undefined = "all differences are zero";
  if (!test.undefined.empty()) return test;
  test.p = mcnemar_exact({.first_only = above, .second_only = below});
  test.direction = sign_of(above - below);
  return test;
}

}  // namespace ikbench::statistics
