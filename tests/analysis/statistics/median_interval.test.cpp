#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "analysis/statistics/quantile.hpp"
#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

using Sample = std::vector<double>;

namespace {

Sample counted(std::size_t n) {
  Sample sample(n);
  std::iota(sample.begin(), sample.end(), 1.0);
  return sample;
}

}  // namespace

TEST_CASE("of 20 values the 6th and the 15th hold the median with 0.9586", "[median_interval]") {
  const Estimate interval = median_interval(counted(20), 0.95);
  CHECK(interval.value == 10.5);
  CHECK(interval.low == 6);
  CHECK(interval.high == 15);
}

TEST_CASE("of six values at 0.95 the extremes are taken, of five there is no interval", "[median_interval]") {
  CHECK(median_interval(counted(6), 0.95).low == 1);
  CHECK(std::isnan(median_interval(counted(5), 0.95).low));
  CHECK(std::isnan(median_interval(counted(5), 0.95).low));
  CHECK(median_interval(counted(5), 0.9).low == 1);
  CHECK(std::isnan(median_interval({}, 0.95).low));
}

TEST_CASE("the next order statistics would hold it with less than the level", "[median_interval]") {
  for (std::size_t n = 6; n < 60; ++n) {
    const Estimate interval = median_interval(counted(n), 0.95);
    // Each further value outside leaves the median out with the chance of so many signs of n.
    const auto chance = [&](double values) {
      const auto all = static_cast<double>(n);
      return std::exp(std::lgamma(all + 1) - std::lgamma(values + 1) - std::lgamma(all - values + 1) -
                      all * std::log(2.0));
    };
    double missed = 0;
    for (double values = 0; values < interval.low; ++values) missed += 2 * chance(values);
    CAPTURE(n);
    CHECK(missed <= 0.05);
    CHECK(missed + 2 * chance(interval.low) > 0.05);
    CHECK(interval.low + interval.high == static_cast<double>(n) + 1);
  }
}

TEST_CASE("a million values have the normal's ranks", "[median_interval]") {
  // (n + 1) / 2 - 1.96 sqrt n / 2 = 499020.5
  CHECK(median_interval(counted(1'000'000), 0.95).low == 499'020);
}

TEST_CASE("failed solves rank last in the interval of the median", "[median_interval]") {
  const Estimate interval = median_interval(Sample{1, 2, 3, 4, 5, HUGE_VAL}, 0.95);
  CHECK(interval.low == 1);
  CHECK(std::isinf(interval.high));
}

TEST_CASE("a level is between 0 and 1", "[median_interval]") {
  CHECK_THROWS_AS(median_interval(counted(20), 1), std::invalid_argument);
}
