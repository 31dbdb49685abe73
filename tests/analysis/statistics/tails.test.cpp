#include "analysis/statistics/tails.hpp"

#include <cmath>
#include <stdexcept>

#include "analysis/statistics/descriptive.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;

TEST_CASE("the normal's tails and quantiles are those of the tables", "[tails]") {
  CHECK(normal_critical(0.95) == Approx(1.959963984540054).epsilon(1e-14));  // R 4.2.2, qnorm(0.975)
  CHECK(normal_two_sided(-1.959963984540054) == Approx(0.05).epsilon(1e-13));
  CHECK(normal_two_sided(0) == 1);
  // P(Z > 38) = phi(38) / 38 (1 - 1 / 38^2 + 3 / 38^4 ...): far out there is still a number.
  const double density = std::exp(-38.0 * 38 / 2) / std::sqrt(2 * std::acos(-1.0));
  CHECK(normal_two_sided(38) == Approx(2 * density / 38 * (1 - 1.0 / 1444 + 3.0 / 1444 / 1444)).epsilon(1e-6));
}

TEST_CASE("the quantile of the normal is infinite at the ends and not defined beyond", "[tails]") {
  CHECK(normal_quantile(0) == -HUGE_VAL);
  CHECK(normal_quantile(1) == HUGE_VAL);
  CHECK(normal_quantile(0.5) == Approx(0).margin(1e-300));
  CHECK(std::isnan(normal_quantile(-0.1)));
  CHECK(std::isnan(normal_quantile(NAN)));
}

TEST_CASE("chi-square on two degrees of freedom is exponential", "[tails]") {
  CHECK(chi_squared_upper_tail(3, 2) == Approx(std::exp(-1.5)).epsilon(1e-13));
  CHECK(chi_squared_upper_tail(1000, 2) == Approx(std::exp(-500)).epsilon(1e-12));
  CHECK(chi_squared_upper_tail(0, 2) == 1);
  CHECK(std::isnan(chi_squared_upper_tail(-1, 2)));
  CHECK(std::isnan(chi_squared_upper_tail(HUGE_VAL, 2)));
  CHECK(std::isnan(chi_squared_upper_tail(1, 0)));
}

TEST_CASE("a confidence level lies between 0 and 1", "[tails]") {
  const double level = GENERATE(0.0, 1.0, 95.0, -0.5, NAN);
  CHECK_THROWS_AS(check_level(level), std::invalid_argument);
  CHECK_THROWS_AS(normal_critical(level), std::invalid_argument);
}

TEST_CASE("Student's t on one and two degrees of freedom is elementary", "[tails]") {
  for (const double t : {-3.0, -0.5, 0.0, 1.0, 12.7062047}) {
    CHECK(t_upper_tail(t, 1) == Approx(0.5 - std::atan(t) / std::acos(-1.0)));  // Cauchy's distribution
    CHECK(t_upper_tail(t, 2) == Approx(0.5 * (1 - t / std::sqrt(2 + t * t))));
  }
  CHECK(t_quantile(0.975, 1) == Approx(12.7062047));  // t table
  CHECK(t_quantile(0.975, HUGE_VAL) == Approx(1.959963985));
}

TEST_CASE("no argument of the t distributions throws", "[tails]") {
  const double inf = HUGE_VAL;
  for (const double bad : {not_defined, 0.0, -1.0}) {
    CHECK(std::isnan(t_upper_tail(1, bad)));
    CHECK(std::isnan(t_quantile(0.9, bad)));
  }
  CHECK(std::isnan(t_upper_tail(not_defined, 3)));
  CHECK(t_upper_tail(inf, 3) == 0);
  CHECK(t_upper_tail(-inf, 3) == 1);
  CHECK(t_upper_tail(1e308, 1e308) == 0);
  CHECK(std::isnan(t_quantile(0, 3)));
  CHECK(std::isnan(t_quantile(1, 3)));
}
