#include "analysis/statistics/power.hpp"

#include <cmath>
#include <stdexcept>

#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;

TEST_CASE("runs to see a difference with groups of equal spread are those of the pooled test, rounded up", "[power]") {
  // R's pwr.t.test at power .8: d = .2 393.4057, d = .5 63.76561, d = .8 25.52458; power.t.test at power .9: d =
  // 1 22.02110.
  const GroupSummary a{0, 1, 10}, b{7, 1, 30};
  CHECK(runs_to_see(a, b, 0.2, {.power = 0.8}) == 394);
  CHECK(runs_to_see(a, b, 0.5, {.power = 0.8}) == 64);
  CHECK(runs_to_see(a, b, -0.8, {.power = 0.8}) == 26);
  CHECK(runs_to_see(a, b, 1, {.power = 0.9}) == 23);
  CHECK(runs_to_see({0, 2, 10}, {7, 2, 30}, 1, {.power = 0.8}) == 64);
}

TEST_CASE("against a constant group the runs are those of a one-sample test", "[power]") {
  // R's pwr.t.test(d = .5, power = .8, type = "one.sample"): n = 33.36713.
  CHECK(runs_to_see({0, 2, 10}, {0, 0, 10}, 1, {.power = 0.8}) == 34);
}

TEST_CASE("pairs to see a difference are those of the paired test, rounded up", "[power]") {
  // R's pwr.t.test(type = "paired") at power .8: d = .2 198.1508, d = .5 33.36713; power.t.test: d = 1 9.93785; SciPy
  // 1.10.1's nct at power .9, d = .5: 44 pairs have 0.90003.
  CHECK(pairs_to_see(1, 0.2, {.power = 0.8}) == 199);
  CHECK(pairs_to_see(2, -1, {.power = 0.8}) == 34);
  CHECK(pairs_to_see(1, 1, {.power = 0.8}) == 10);
  CHECK(pairs_to_see(1, 0.5, {.power = 0.9}) == 44);
}

TEST_CASE("an enormous difference needs two runs", "[power]") {
  const GroupSummary group{0, 1, 5};
  for (const double difference : {1e6, 1e308, HUGE_VAL}) CHECK(runs_to_see(group, group, difference, {}) == 2);
}

TEST_CASE("where no number of runs will do there is none", "[power]") {
  const GroupSummary good{1, 1, 5}, constant{1, 0, 5};
  CHECK(std::isnan(runs_to_see(good, good, 0, {})));
  CHECK(std::isinf(runs_to_see(good, good, 1e-6, {})));
  CHECK(std::isnan(runs_to_see(good, good, not_defined, {})));
  CHECK(std::isnan(runs_to_see(constant, constant, 1, {})));
  CHECK(std::isnan(runs_to_see(good, {1, not_defined, 1}, 1, {})));
  CHECK(std::isnan(runs_to_see(good, {1, not_defined, 5}, 1, {})));
  CHECK(std::isnan(pairs_to_see(1, 0, {})));
  CHECK(std::isnan(pairs_to_see(0, 1, {})));
  CHECK(std::isnan(pairs_to_see(not_defined, 1, {})));
  CHECK_THROWS_AS(pairs_to_see(1, 1, {.power = 1}), std::invalid_argument);
  CHECK_THROWS_AS(runs_to_see(good, good, 1, {.power = 1}), std::invalid_argument);
  CHECK_THROWS_AS(runs_to_see(good, good, 1, {.power = 0.8, .alpha = 0}), std::invalid_argument);
  CHECK_THROWS_AS(runs_to_see(good, good, 1, {.power = 0.01, .alpha = 0.05}), std::invalid_argument);
}

TEST_CASE("the least difference that n values show is that of R's power.t.test", "[power]") {
  // The n of a difference has that difference as its least one: two groups of 64 see half a deviation (Cohen 1988).
  CHECK(least_difference(64, false, {}) == Approx(0.5).margin(0.003));
  CHECK(least_difference(34, true, {}) == Approx(0.5).margin(0.008));
  for (const int n : {3, 5, 20}) {
    const double least = least_difference(n, false, {.alpha = 0.05 / 15});
    CHECK(runs_to_see({.std = 1, .n = n}, {.std = 1, .n = n}, least * (1 + 1e-9), {.alpha = 0.05 / 15}) == n);
    CHECK(pairs_to_see(1, least_difference(n, true, {}) * (1 + 1e-9), {}) == n);
  }
  CHECK(std::isnan(least_difference(1, false, {})));
}

TEST_CASE("a standard deviation is plausible from one end of its interval to the other", "[power]") {
  // Chi-square of 9 degrees of freedom: 2.700 and 19.023 at 0.025 and 0.975 (tables).
  CHECK(plausible_deviation(2, 10, 0.025) == Approx(2 * std::sqrt(9 / 19.0228)).epsilon(1e-4));
  CHECK(plausible_deviation(2, 10, 0.975) == Approx(2 * std::sqrt(9 / 2.70039)).epsilon(1e-4));
  CHECK(std::isnan(plausible_deviation(1, 1, 0.5)));
}
