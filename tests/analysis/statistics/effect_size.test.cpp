#include "analysis/statistics/effect_size.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "analysis/statistics/tails.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;

namespace {

using Values = std::vector<double>;

// Cliff's variance from every pair, as his paper writes it.
double variance_from_pairs(const Values& a, const Values& b, double delta) {
  const auto sign = [](double x, double y) { return static_cast<double>((x > y) - (x < y)); };
  const double m = static_cast<double>(a.size()), n = static_cast<double>(b.size());
  double rows = 0, columns = 0, pairs = 0;
  for (const double x : a) {
    double row = 0;
    for (const double y : b) row += sign(x, y) / n;
    rows += (row - delta) * (row - delta) / (m - 1);
  }
  for (const double y : b) {
    double column = 0;
    for (const double x : a) {
      column += sign(x, y) / m;
      pairs += (sign(x, y) - delta) * (sign(x, y) - delta) / ((m - 1) * (n - 1));
    }
    columns += (column - delta) * (column - delta) / (n - 1);
  }
  return ((n - 1) * rows + (m - 1) * columns + pairs) / (m * n);
}

const GroupSummary table_3_ik_ba{0.0019, 1.7824e-4, 20}, table_3_ba{1.6849, 0.9069, 20};
constexpr double correction_of_20 = 0.980110402130946;  // g / d of twice 20: Gamma(19) / (sqrt(19) Gamma(18.5))

}  // namespace

TEST_CASE("the share of variance of PlantGrowth is that of R", "[effect_size]") {
  // R 4.2.2, effectsize and rstatix on aov(weight ~ group).
  const AnovaTable table = anova(std::vector<Values>{{4.17, 5.58, 5.18, 6.11, 4.50, 4.61, 5.17, 4.53, 5.33, 5.14},
                                                     {4.81, 4.17, 4.41, 3.59, 5.87, 3.83, 6.03, 4.89, 4.32, 4.69},
                                                     {6.31, 5.12, 5.54, 5.50, 5.37, 5.29, 4.92, 6.15, 5.80, 5.26}});
  CHECK(omega_squared(table) == Approx(0.20407884599).epsilon(1e-10));
}

TEST_CASE("equal means have no share of the variance, or less than none after correction for chance", "[effect_size]") {
  const AnovaTable table =
      anova(std::vector<Values>{{1, 2, 3}, {1, 2, 3}});  // between 0, within 4 on 4: (0 - 1) / (4 + 1)
  CHECK(omega_squared(table) == Approx(-0.2));
}

TEST_CASE("a table without sums of squares has no effect size", "[effect_size]") {
  for (const auto& groups : {std::vector<Values>{}, {{1, 1}, {1, 1}}, {{1}, {2}}, {{1, not_defined}, {1, 2}}}) {
    const AnovaTable table = anova(groups);
    CHECK(std::isnan(omega_squared(table)));
  }
}

TEST_CASE("Hedges's g of IK-BA's error against the others in Table 3", "[effect_size][paper]") {
  // By hand: difference of the printed means over the root mean square of the printed standard deviations.
  const std::vector<GroupSummary> others{
      table_3_ba, {0.3653, 0.2929, 20}, {0.4382, 0.3312, 20}, {0.2318, 0.0722, 20}, {0.4075, 0.0891, 20}};
  const Values expected_d{2.624, 1.755, 1.863, 4.503, 6.438};
  for (std::size_t i = 0; i < others.size(); ++i) {
    const double g = hedges_g(others[i], table_3_ik_ba);
    CHECK(g / correction_of_20 == Approx(expected_d[i]).margin(6e-4));
  }
}

TEST_CASE("groups without a mean or a spread have no g", "[effect_size]") {
  const GroupSummary good{1, 1, 5};
  for (const GroupSummary& other : {GroupSummary{1, not_defined, 1}, {not_defined, 1, 5}, {1, HUGE_VAL, 5}}) {
    CHECK(std::isnan(hedges_g(good, other)));
  }
  CHECK(std::isnan(hedges_g({1, 0, 5}, {2, 0, 5})));
  CHECK(std::isnan(hedges_g({1e308, 1, 5}, {-1e308, 1, 5})));
}

TEST_CASE("Cliff's delta of a published pair of samples", "[effect_size]") {
  // R's effsize, help of cliff.delta, treats these samples; interval by the formula in Python, with the normal
  // quantile.
  const Values a{10, 10, 20, 20, 20, 30, 30, 30, 40, 50}, b{10, 20, 30, 40, 40, 50};
  const Estimate delta = cliffs_delta(a, b, 0.95);
  CHECK(delta.value == Approx(-0.25));
  CHECK(delta.low == Approx(-0.712535095115308).epsilon(1e-12));
  CHECK(delta.high == Approx(0.363999895035978).epsilon(1e-12));
  const Estimate a12 = vargha_delaney(a, b, 0.95);
  CHECK(a12.value == Approx(0.375));
  CHECK(a12.low == Approx((1 + delta.low) / 2));
  CHECK(a12.high == Approx((1 + delta.high) / 2));
}

TEST_CASE("Cliff's interval from sorted samples is that from every pair", "[effect_size]") {
  Values a, b;
  for (int i = 0; i < 23; ++i) a.push_back(std::floor(10 * std::fmod(i * 0.6180339887, 1.0)));
  for (int i = 0; i < 14; ++i) b.push_back(2 + std::floor(9 * std::fmod(i * 0.7548776662, 1.0)));
  const Estimate delta = cliffs_delta(a, b, 0.95);
  const double variance = variance_from_pairs(a, b, delta.value);
  const double z = 1.959963984540054, rest = 1 - delta.value * delta.value;
  const double reach = z * std::sqrt(variance * (rest * rest + z * z * variance));
  CHECK(delta.low == Approx((delta.value * rest - reach) / (rest + z * z * variance)));
  CHECK(delta.high == Approx((delta.value * rest + reach) / (rest + z * z * variance)));
}

TEST_CASE("where one sample lies wholly above the other the interval is Wilson's", "[effect_size]") {
  // (n - z^2) / (n + z^2), n = 20 the smaller sample: (20 - 3.841459) / (20 + 3.841459) = 0.677750.
  Values a(20), b(30);
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = 100 + static_cast<double>(i);
  for (std::size_t i = 0; i < b.size(); ++i) b[i] = static_cast<double>(i);
  const Estimate above = cliffs_delta(a, b, 0.95);
  CHECK(above.value == 1);
  CHECK(above.low == Approx(0.677750).epsilon(1e-5));
  CHECK(above.high == 1);
  const Estimate below = vargha_delaney(b, a, 0.95);
  CHECK(below.value == 0);
  CHECK(below.low == 0);
  CHECK(below.high == Approx((1 - 0.677750) / 2).epsilon(1e-5));
}

TEST_CASE("a solver that diverged ranks, one that is not a number does not", "[effect_size]") {
  CHECK(cliffs_delta(Values{HUGE_VAL, HUGE_VAL}, Values{1, 1e308}, 0.95).value == 1);
  CHECK(cliffs_delta(Values{HUGE_VAL, 1}, Values{HUGE_VAL, 1}, 0.95).value == 0);
  const Estimate nan = vargha_delaney(Values{not_defined, 1}, Values{1, 2}, 0.95);
  CHECK(std::isnan(nan.value));
}

TEST_CASE("dominance without spread has no interval", "[effect_size]") {
  const auto [a, b, value] =
      GENERATE(table<Values, Values, double>({{{}, {1}, not_defined}, {{1}, {2, 3}, -1}, {{3, 3}, {3, 3, 3}, 0}}));
  const Estimate delta = cliffs_delta(a, b, 0.95);
  CHECK((delta.value == value || (std::isnan(delta.value) && std::isnan(value))));
  CHECK(std::isnan(delta.low));
  CHECK(std::isnan(delta.high));
  CHECK_THROWS_AS(cliffs_delta(a, b, 0), std::invalid_argument);
}
