#include "analysis/statistics/group_sequential.hpp"

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "analysis/statistics/mean_ratio.hpp"
#include "analysis/statistics/tails.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;

TEST_CASE("one look is the test itself", "[group_sequential]") {
  for (const double p : {1e-9, 0.001, 0.05, 0.5, 0.97, 1.0}) {
    CHECK(chance_to_cross(constant_of(p, 1, {}), {}) == Approx(p).epsilon(1e-12));
  }
  CHECK(chance_to_cross(constant_of(0, 1, {}), {}) == 0);
}

TEST_CASE("the boundaries of Pocock and of O'Brien and Fleming have their printed constants", "[group_sequential]") {
  // Jennison and Turnbull, Group Sequential Methods (2000), Tables 2.1 and 2.3: two-sided, alpha 0.05; three decimals.
  struct Printed {
    int looks;
    double pocock, obrien_fleming;
  };
  for (const Printed& printed : {Printed{2, 2.178, 1.977}, Printed{3, 2.289, 2.004}, Printed{4, 2.361, 2.024},
                                 Printed{5, 2.413, 2.040}, Printed{10, 2.555, 2.087}}) {
    CAPTURE(printed.looks);
    const Boundary pocock{.looks = printed.looks, .shape = 0.5}, obrien_fleming{.looks = printed.looks, .shape = 0};
    CHECK(2 * chance_to_cross(printed.pocock, pocock) == Approx(0.05).margin(2e-4));
    CHECK(2 * chance_to_cross(printed.obrien_fleming, obrien_fleming) == Approx(0.05).margin(2e-4));
  }
}

TEST_CASE("sums of n symmetric terms stay below 0 with the chance of C(2n, n) / 4^n", "[group_sequential]") {
  // Sparre Andersen, Mathematica Scandinavica 1 (1953) 263, for any symmetric distribution without ties.
  double below = 1;
  for (int n = 1; n <= 20; ++n) {
    below *= (2.0 * n - 1) / (2.0 * n);
    for (const double shape : {0.0, 0.25, 0.5}) {
      CHECK(chance_to_cross(0, {.looks = n, .shape = shape}) == Approx(1 - below).epsilon(1e-10));
    }
  }
}

TEST_CASE("more looks at one boundary cross it more often, and never more than the looks together",
          "[group_sequential]") {
  for (const double c : {1.0, 2.0, 4.0, 6.0}) {
    const double alone = chance_to_cross(c, {});
    double before = alone;
    for (const int looks : {2, 5, 20, 100}) {
      const double now = chance_to_cross(c, {.looks = looks, .shape = 0.5});
      CHECK(now > before);
      CHECK(now < std::min(1.0, looks * alone));
      before = now;
    }
  }
}

TEST_CASE("an early look needs a smaller p for the same constant, unless the shape is Pocock's", "[group_sequential]") {
  CHECK(constant_of(0.01, 1, {.looks = 4, .shape = 0.5}) == Approx(2.3263478740));
  CHECK(constant_of(0.01, 1, {.looks = 4, .shape = 0}) == Approx(2.3263478740 / 2));
  CHECK(constant_of(0.01, 4, {.looks = 4, .shape = 0}) == Approx(2.3263478740));
  CHECK(std::isnan(constant_of(not_defined, 1, {})));
  CHECK(std::isnan(chance_to_cross(not_defined, {})));
}

TEST_CASE("a plan out of range is refused", "[group_sequential]") {
  for (const Boundary& boundary :
       {Boundary{.looks = 0}, Boundary{.looks = 101}, Boundary{.shape = -0.1}, Boundary{.shape = 0.6}}) {
    CHECK_THROWS_AS(chance_to_cross(1, boundary), std::invalid_argument);
    CHECK_THROWS_AS(constant_of(0.1, 1, boundary), std::invalid_argument);
  }
}

TEST_CASE(
    "t-tests of a ratio at the margin that are looked at ten times are wrong in 5 %, and without the boundary in more",
    "[group_sequential]") {
  constexpr int repetitions = 800, looks = 10, step = 4;
  const Boundary boundary{.looks = looks};
  std::mt19937_64 random(1);
  const auto normal = [&](double mean) {
    return mean + 0.3 * normal_quantile((static_cast<double>(random() >> 11) + 0.5) / 9007199254740992.0);
  };
  double wrong = 0, wrong_without = 0;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    std::vector<double> a, b;
    double largest = -100, least_p = 1;
    for (int look = 1; look <= looks; ++look) {
      for (int run = 0; run < step; ++run) {
        a.push_back(normal(1));
        b.push_back(normal(1.05));
      }
      const double p = mean_ratio(a, b, {.margin = 0.05}).p_above;  // true: the ratio is not above 1.05
      largest = std::max(largest, constant_of(p, look, boundary));
      least_p = std::min(least_p, p);
    }
    wrong += chance_to_cross(largest, boundary) < 0.05 ? 1 : 0;
    wrong_without += least_p < 0.05 ? 1 : 0;
  }
  const double error = std::sqrt(0.05 * 0.95 / repetitions);  // 0.0077
  CHECK(wrong / repetitions < 0.05 + 3 * error);
  CHECK(wrong / repetitions > 0.05 - 3 * error);
  CHECK(wrong_without / repetitions > 0.12);
}
