// Differences of decimals have wrong last bits. No test takes them for data.
#include "analysis/statistics/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <tuple>
#include <vector>

#include "analysis/statistics/equal_variances.hpp"
#include "analysis/statistics/ranks.hpp"
#include "analysis/statistics/welch.hpp"
#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

using Sample = std::vector<double>;

namespace {

// The header's rule: compares each number, the most exact first, with all before it.
Sample joined_one_by_one(const Sample& numbers, const Sample& sizes) {
  std::vector<std::size_t> order(numbers.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return std::tuple(sizes[i], std::abs(numbers[i])); });
  Sample different{0}, result = numbers;
  for (const std::size_t i : order) {
    const double magnitude = std::abs(numbers[i]);
    const auto distance = [&](double other) { return std::pair(std::abs(magnitude - other), -other); };
    const double nearest = std::ranges::min(different, {}, distance);
    const bool is_rounding = without_rounding(magnitude - nearest, sizes[i]) == 0;
    if (is_rounding) result[i] = nearest == 0 ? 0.0 : std::copysign(nearest, numbers[i]);
    if (!is_rounding) different.push_back(magnitude);
  }
  return result;
}

}  // namespace

TEST_CASE("numbers are joined as if each were compared with all before it", "[rounding][property]") {
  std::mt19937_64 engine(11);  // whose sequence the C++ standard fixes
  for (int round = 0; round < 200; ++round) {
    Sample numbers, sizes;
    const double grid =
        std::ldexp(1.0, -30 - static_cast<int>(engine() % 24));  // from far beyond rounding to within it
    for (int i = 0; i < 100; ++i) {
      const double value = grid * static_cast<double>(engine() % 500) +
                           (round % 2 == 0 ? 0 : 0.1 * static_cast<double>(engine() % 3 + 1));
      numbers.push_back(engine() % 2 == 0 ? value : -value);
      sizes.push_back(std::abs(value) + std::ldexp(1.0, -static_cast<int>(engine() % 40)));
    }
    CAPTURE(round);
    CHECK(without_rounding(numbers, sizes) == joined_one_by_one(numbers, sizes));
  }
}

TEST_CASE("two values lie equally far from their median, so they have no spread about it", "[rounding]") {
  const Groups pairs{{1.1, 1.4}, {2.3, 9.7}, {0.1, 0.7}, {3.3, 1e3}, {1e-3, 12.2}, {5.1, 5.2}};
  const Test test = brown_forsythe(pairs);
  CHECK(std::isnan(test.p));
  CHECK(says(test.undefined, "constant"));
  // Three values have: the deviations are 0.1 0 0.1 and 0.1 0 2.1.
  CHECK(std::isfinite(brown_forsythe(Groups{{1.1, 1.2, 1.3}, {1.1, 1.2, 3.3}}).p));
}

TEST_CASE("pairs of decimals that differ by the same have no spread", "[rounding]") {
  const Sample a{1.1, 2.2, 3.3, 14.7, 0.3}, b{1.2, 2.3, 3.4, 14.8, 0.4};
  const MeanDifference test = paired_t(a, b, 0.95);
  CHECK(says(test.undefined, "differ by the same"));
  CHECK(std::isnan(test.p));
  CHECK(test.difference.value == Approx(-0.1));
}
