#include "analysis/statistics/power.hpp"

#include <cmath>
#include <stdexcept>

#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;

TEST_CASE("power of the t-test is that of R's power.t.test", "[power]") {
  // R 4.2.2, help of power.t.test: n = 20, delta = 1: power 0.8689528; power .90, delta 1: n = 22.02110.
  CHECK(t_test_power(1, 20, 0.05) == Approx(0.8689528).epsilon(1e-6));
  CHECK(t_test_power(1, 22.02110, 0.05) == Approx(0.90).epsilon(1e-6));
  CHECK(t_test_power(-1, 20, 0.05) == Approx(t_test_power(1, 20, 0.05)));
  CHECK(t_test_power(0, 20, 0.05) == Approx(0.05));
}

TEST_CASE("runs needed are R's n, rounded up", "[power]") {
  // R's pwr.t.test at power .8: d = .2 393.4057, d = .5 63.76561, d = .8 25.52458; power.t.test at power .9: d =
  // 1 22.02110.
  CHECK(runs_needed(0.2, {.power = 0.8}).n == 394);
  CHECK(runs_needed(0.5, {.power = 0.8}).n == 64);
  CHECK(runs_needed(-0.8, {.power = 0.8}).n == 26);
  CHECK(runs_needed(1, {.power = 0.9}).n == 23);
  CHECK(t_test_power(0.5, 63.76561, 0.05) == Approx(0.8).epsilon(1e-6));
}

TEST_CASE("the smallest n reaches the power and one run fewer does not", "[power]") {
  const double d = GENERATE(0.01, 0.3, 1.0, 3.0, 5.0);
  const PowerGoal goal{.power = GENERATE(0.5, 0.8, 0.99), .alpha = GENERATE(0.05, 0.001)};
  const double n = runs_needed(d, goal).n;
  CHECK(t_test_power(d, n, goal.alpha) >= goal.power);
  CHECK((n == 2 || t_test_power(d, n - 1, goal.alpha) < goal.power));
}

TEST_CASE("the smallest effect that a number of runs shows has the power asked for", "[power]") {
  CHECK(smallest_effect(63.76561, {.power = 0.8}) == Approx(0.5).epsilon(1e-6));  // R's pwr.t.test, d = .5
  for (const double n : {2.0, 5.0, 20.0, 1e5}) {
    const double d = smallest_effect(n, {.power = 0.9, .alpha = 0.01});
    CHECK(t_test_power(d, n, 0.01) == Approx(0.9).epsilon(1e-9));
  }
  CHECK(std::isnan(smallest_effect(1, {})));
  CHECK(std::isnan(smallest_effect(not_defined, {})));
}

TEST_CASE("runs to see a difference with groups of equal spread are those of the pooled test", "[power]") {
  const GroupSummary a{0, 2, 10}, b{7, 2, 30};  // a difference of 1 is d = 0.5
  CHECK(runs_to_see(a, b, 1, {.power = 0.8}).n == 64);
  CHECK(runs_to_see(a, b, -1, {.power = 0.8}).n == 64);
}

TEST_CASE("against a constant group the runs are those of a one-sample test", "[power]") {
  // R's pwr.t.test(d = .5, power = .8, type = "one.sample"): n = 33.36713.
  CHECK(runs_to_see({0, 2, 10}, {0, 0, 10}, 1, {.power = 0.8}).n == 34);
}

TEST_CASE("runs for the Mann-Whitney test follow Noether", "[power]") {
  // By hand: (1.959964 + 0.841621)^2 = 7.848879, over 6 * 0.2^2 = 32.7; over 6 * 0.5^2 = 5.2.
  CHECK(runs_for_rank_test(0.7, {.power = 0.8}).n == 33);
  CHECK(runs_for_rank_test(0.3, {.power = 0.8}).n == 33);
  CHECK(runs_for_rank_test(1, {.power = 0.8}).n == 6);
}

TEST_CASE("an enormous difference needs two runs", "[power]") {
  CHECK(runs_needed(1e6, {}).n == 2);
  CHECK(runs_needed(1e308, {}).n == 2);
  CHECK(runs_needed(HUGE_VAL, {}).n == 2);
  CHECK(t_test_power(1e308, 1e7, 0.05) == Approx(1));
}

TEST_CASE("where no number of runs will do it says why", "[power]") {
  const auto says = [](const RunsNeeded& runs, const std::string& reason) {
    CAPTURE(runs.undefined, reason);
    CHECK(std::isnan(runs.n));
    CHECK(runs.undefined.find(reason) != std::string::npos);
  };
  const GroupSummary good{1, 1, 5}, constant{1, 0, 5};
  says(runs_needed(0, {}), "difference of zero");
  says(runs_needed(1e-5, {}), "ten million");
  says(runs_needed(not_defined, {}), "not defined");
  says(runs_to_see(good, good, 0, {}), "difference of zero");
  says(runs_to_see(good, good, 1e-6, {}), "ten million");
  says(runs_to_see(good, good, not_defined, {}), "not defined");
  says(runs_to_see(constant, constant, 1, {}), "constant");
  says(runs_to_see(good, {1, not_defined, 1}, 1, {}), "fewer than two");
  says(runs_to_see(good, {1, not_defined, 5}, 1, {}), "not defined");
  says(runs_for_rank_test(0.5, {}), "neither");
  says(runs_for_rank_test(0.5001, {}), "ten million");
  says(runs_for_rank_test(not_defined, {}), "A12");
  says(runs_for_rank_test(1.1, {}), "A12");
  CHECK(std::isnan(t_test_power(1, 1, 0.05)));
  CHECK(std::isnan(t_test_power(1, 20, 0)));
  CHECK_THROWS_AS(runs_needed(1, {.power = 1}), std::invalid_argument);
  CHECK_THROWS_AS(runs_needed(1, {.power = 0.8, .alpha = 0}), std::invalid_argument);
  CHECK_THROWS_AS(runs_needed(1, {.power = 0.01, .alpha = 0.05}), std::invalid_argument);
}
