// Removes rounding. Decimals are off by half of a last place, and so are numbers computed from them. Two numbers that
// are equal as decimals then differ in their last bits, and a test that ranks such differences, or divides by their
// spread, would take those bits for data. This is the one rule for all.
#pragma once

#include <span>
#include <vector>

namespace ikbench::statistics {

// 0 if rounding alone can explain the difference of two values up to that size.
double without_rounding(double difference, double size);

// For numbers that come from values up to sizes[i] each: makes two equal if rounding alone separates their magnitudes,
// and 0 if rounding alone separates one from 0. The number from smaller values is more exact, and decides. Leaves
// values that are not finite.
std::vector<double> without_rounding(std::span<const double> numbers, std::span<const double> sizes);

// For the values themselves, such as means of the same numbers added in another order.
std::vector<double> without_rounding(std::span<const double> values);

// first[i] - second[i] for every pair.
std::vector<double> differences_without_rounding(std::span<const double> first, std::span<const double> second);

}  // namespace ikbench::statistics
