#include "analysis/statistics/median_interval.hpp"

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

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
  const MedianInterval interval = median_interval(counted(20));
  CHECK(interval.low_rank == 6);
  CHECK(interval.high_rank == 15);
  CHECK(interval.low == 6);
  CHECK(interval.high == 15);
  CHECK(interval.coverage == Approx(1 - 2 * 21700.0 / 1048576).epsilon(1e-12));  // 1 + 20 + 190 + 1140 + 4845 + 15504
}

TEST_CASE("of six values at 0.95 the extremes are taken, of five there is no interval", "[median_interval]") {
  CHECK(median_interval(counted(6)).low_rank == 1);
  CHECK(median_interval(counted(6)).coverage == Approx(1 - 2.0 / 64));
  CHECK(says(median_interval(counted(5)).undefined, "5 values are too few for a level of 0.95"));
  CHECK(std::isnan(median_interval(counted(5)).low));
  CHECK(median_interval(counted(5), 0.9).low_rank == 1);
  CHECK(says(median_interval({}).undefined, "too few"));
}

TEST_CASE("the next order statistics would hold it with less than the level", "[median_interval]") {
  for (std::size_t n = 6; n < 60; ++n) {
    const MedianInterval interval = median_interval(counted(n));
    const double narrower =
        interval.coverage -
        2 * std::exp(std::lgamma(static_cast<double>(n) + 1) - std::lgamma(static_cast<double>(interval.low_rank) + 1) -
                     std::lgamma(static_cast<double>(n - interval.low_rank) + 1) -
                     static_cast<double>(n) * std::log(2.0));
    CAPTURE(n);
    CHECK(interval.coverage >= 0.95);
    CHECK(narrower < 0.95);
  }
}

TEST_CASE("a million values have the normal's ranks", "[median_interval]") {
  // (n + 1) / 2 - 1.96 sqrt n / 2 = 499020.5
  CHECK(median_interval(counted(1'000'000)).low_rank == 499'020);
}

TEST_CASE("failed solves rank last in the interval of the median", "[median_interval]") {
  const MedianInterval interval = median_interval(Sample{1, 2, 3, 4, 5, HUGE_VAL});
  CHECK(interval.low == 1);
  CHECK(std::isinf(interval.high));
}

TEST_CASE("values that are not sorted or not numbers have no interval of the median", "[median_interval]") {
  CHECK(says(median_interval(Sample{1, 2, 3, 5, 4, 6, 7}).undefined, "not sorted"));
  CHECK(says(median_interval(Sample{1, 2, 3, 4, 5, 6, NAN}).undefined, "not a number"));
  CHECK_THROWS_AS(median_interval(counted(20), 1), std::invalid_argument);
}
