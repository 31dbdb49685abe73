#include "analysis/statistics/descriptive.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "analysis/statistics/quantile.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;

TEST_CASE("mean, median, standard deviation, maximum and minimum by hand", "[descriptive]") {
  const Description d = describe(std::vector<double>{4, 1, 3, 2});
  CHECK(d.n == 4);
  CHECK(d.mean == 2.5);
  CHECK(d.median == 2.5);
  CHECK(d.std == Approx(std::sqrt(5.0 / 3)));  // squares 2.25 + 0.25 + 0.25 + 2.25, by n - 1
  CHECK(d.max == 4);
  CHECK(d.min == 1);
}

TEST_CASE("many equal leading digits cost the standard deviation nothing", "[descriptive]") {
  // 1e9 + {4, 7, 13, 16}: deviations -6 -3 3 6, squares 90, by 3.
  CHECK(describe(std::vector<double>{1e9 + 4, 1e9 + 7, 1e9 + 13, 1e9 + 16}).std == std::sqrt(30.0));
}

TEST_CASE("one value has a mean and no standard deviation", "[descriptive]") {
  const Description d = describe(std::vector<double>{3});
  CHECK(d.mean == 3);
  CHECK(d.median == 3);
  CHECK(std::isnan(d.std));
}

TEST_CASE("equal values have standard deviation zero", "[descriptive]") {
  CHECK(describe(std::vector<double>{0.1, 0.1, 0.1}).std == 0);
}

TEST_CASE("no values have no description", "[descriptive]") {
  const Description d = describe({});
  CHECK(d.n == 0);
  CHECK(std::isnan(d.mean));
  CHECK(std::isnan(d.median));
  CHECK(std::isnan(d.max));
}

TEST_CASE("values that are not finite are counted, have no mean, and rank as the worst", "[descriptive]") {
  const Description d = describe(std::vector<double>{NAN, 1, 2, 3, HUGE_VAL, 4});
  CHECK(d.n == 6);
  CHECK(d.not_finite == 2);
  CHECK(std::isnan(d.mean));
  CHECK(std::isnan(d.std));
  CHECK(d.median == 3.5);  // of 1 2 3 4 worst worst
  CHECK(d.min == 1);
  CHECK(!std::isfinite(d.max));
}

TEST_CASE("minus infinity is below every number, and what is not a number is not", "[descriptive]") {
  const std::vector<double> values{NAN, 3, -HUGE_VAL, 1, 2};
  CHECK(ranked_values(values) == std::vector<double>{-HUGE_VAL, 1, 2, 3, HUGE_VAL});
  const Description d = describe(values);
  CHECK(d.not_finite == 2);
  CHECK(d.median == 2);
  CHECK(d.min == -HUGE_VAL);
  CHECK(std::isnan(d.mean));
  CHECK(std::isnan(describe(std::vector<double>{-HUGE_VAL, HUGE_VAL}).median));  // any number would do
}

TEST_CASE("the unit of the values scales their standard deviation, to where squares vanish or overflow",
          "[descriptive]") {
  const std::vector<double> values{4, 1, 3, 2};
  const double unit = GENERATE(0x1p-1060, 0x1p-600, 0x1p-500, 0x1p520, 0x1p1021);  // powers of two: no digit is lost
  std::vector<double> scaled;
  for (const double value : values) scaled.push_back(value * unit);
  CHECK(describe(scaled).mean == 2.5 * unit);
  CHECK(standard_deviation(scaled) == Approx(std::sqrt(5.0 / 3) * unit).epsilon(1e-3).margin(0));  // subnormals: 2^14
  CHECK(standard_error(scaled) == Approx(std::sqrt(5.0 / 12) * unit).epsilon(1e-3).margin(0));
}

TEST_CASE("ordinary values keep the bits of the plain formula", "[descriptive]") {
  const std::vector<double> values{0.1, 0.37, 1e-3, 12.25, 7.77};
  CHECK(describe(values).std == std::sqrt(sum_of_squares(values) / 4));
  CHECK(standard_error(values) == std::sqrt(sum_of_squares(values) / 4 / 5));
}

TEST_CASE("a mean does not overflow, and one value or none has no standard deviation", "[descriptive]") {
  CHECK(mean(std::vector<double>{1e308, -1e308}) == 0);
  CHECK(mean(std::vector<double>{-1.7e308, 1.7e308, 1.7e308}) == Approx(1.7e308 / 3));
  CHECK(std::isinf(mean(std::vector<double>{HUGE_VAL, 1})));
  CHECK(std::isnan(mean(std::vector<double>{HUGE_VAL, -HUGE_VAL})));
  CHECK(std::isnan(standard_deviation({})));
  CHECK(std::isnan(standard_deviation(std::vector<double>{5})));
  CHECK(std::isnan(standard_error(std::vector<double>{1, NAN})));
  CHECK(describe(std::vector<double>{1e308, -1e308}).std == Approx(std::sqrt(2.0) * 1e308));
}

TEST_CASE("a power of two below the largest magnitude", "[descriptive]") {
  CHECK(power_of_two_below(std::vector<double>{3, -9, 0}) == 8);
  CHECK(power_of_two_below(std::vector<double>{0.25}) == 0.25);
  CHECK(power_of_two_below(std::vector<double>{5e-324}) == 5e-324);
  CHECK(power_of_two_below({}) == 1);
  CHECK(power_of_two_below(std::vector<double>{0, 0}) == 1);
  CHECK(power_of_two_below(std::vector<double>{1, -HUGE_VAL}) == 1);
}

TEST_CASE("quartiles of 1 2 3 4 9 2 by Hyndman and Fan's types", "[quantile]") {
  const std::vector<double> sorted = ranked_values(std::vector<double>{1, 2, 3, 4, 9, 2});
  // Types 5 to 8: R's quantile; 1 to 4 and 9 by hand from the paper's definitions, n p = 1.5 and 4.5.
  const auto [number, q1, q3] = GENERATE(table<int, double, double>({{1, 2, 4},
                                                                     {2, 2, 4},
                                                                     {3, 2, 3},
                                                                     {4, 1.5, 3.5},
                                                                     {5, 2, 4},
                                                                     {6, 1.75, 5.25},
                                                                     {7, 2, 3.75},
                                                                     {8, 1.9166666667, 4.4166666667},
                                                                     {9, 1.9375, 4.3125}}));
  CAPTURE(number);
  CHECK(quantile(sorted, 0.25, QuantileType{number}) == Approx(q1));
  CHECK(quantile(sorted, 0.75, QuantileType{number}) == Approx(q3));
}

TEST_CASE("on a jump the discontinuous types take the lower value, the middle, and the even rank", "[quantile]") {
  const std::vector<double> sorted{10, 20, 30, 40};
  CHECK(quantile(sorted, 0.5, QuantileType::type_1) == 20);  // n p = 2 exactly
  CHECK(quantile(sorted, 0.5, QuantileType::type_2) == 25);
  CHECK(quantile(sorted, 0.375, QuantileType::type_3) == 20);  // n p - 1/2 = 1, odd: the next
  CHECK(quantile(sorted, 0.625, QuantileType::type_3) == 20);  // n p - 1/2 = 2, even: this one
}

TEST_CASE("the quantiles at 0 and 1 are the extremes for every type", "[quantile]") {
  const int number = GENERATE(1, 2, 3, 4, 5, 6, 7, 8, 9);
  const std::vector<double> sorted{1, 5, 6};
  CHECK(quantile(sorted, 0, QuantileType{number}) == 1);
  CHECK(quantile(sorted, 1, QuantileType{number}) == 6);
  CHECK(quantile(std::vector<double>{7}, 0.3, QuantileType{number}) == 7);
}

TEST_CASE("a probability that does not exist is refused", "[quantile]") {
  CHECK_THROWS_AS(quantile(std::vector<double>{1}, 1.5, QuantileType::type_7), std::invalid_argument);
  CHECK_THROWS_AS(quantile(std::vector<double>{1}, NAN, QuantileType::type_7), std::invalid_argument);
}
