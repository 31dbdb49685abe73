// What rounding makes of numbers: decimals are off by half of a last place, and so is what is made of them. Two numbers
// that are equal by the decimals then differ in their last bits, and a test that ranks such differences, or divides by
// their spread, would take those bits for data. This is the one rule for all.
#pragma once

#include <span>
#include <vector>

namespace ikbench::statistics {

// 0 where rounding alone can have made the difference of two values up to that size.
double without_rounding(double difference, double size);

// Numbers that come from values up to sizes[i] each: where rounding alone keeps the magnitudes of two apart they become
// equal, and 0 where it keeps one from 0. What comes from smaller values is more exact, and has the word. What is not
// finite stays.
std::vector<double> without_rounding(std::span<const double> numbers, std::span<const double> sizes);

// Of values themselves, as means of the same numbers added up in another order.
std::vector<double> without_rounding(std::span<const double> values);

// first[i] - second[i]; as many as there are pairs.
std::vector<double> differences_without_rounding(std::span<const double> first, std::span<const double> second);

}  // namespace ikbench::statistics
