#include "analysis/statistics/group_sequential.hpp"

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "analysis/statistics/tails.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;

TEST_CASE("one look is the test itself", "[group_sequential]") {
  for (const double level : {1e-9, 0.001, 0.05, 0.5, 0.97}) {
    CHECK(level_of_look(constant_of(level, {}), 1, {}) == Approx(level).epsilon(1e-9));
  }
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

TEST_CASE("Pocock's looks have the printed level, those of O'Brien and Fleming ask much of early ones",
          "[group_sequential]") {
  // Pocock, Biometrika 64 (1977) 191, Table 1: two-sided 0.05 in 4 and in 10 looks.
  CHECK(2 * level_of_look(constant_of(0.025, {.looks = 4, .shape = 0.5}), 1, {.looks = 4, .shape = 0.5}) ==
        Approx(0.0182).margin(1e-4));
  CHECK(2 * level_of_look(constant_of(0.025, {.looks = 10, .shape = 0.5}), 3, {.looks = 10, .shape = 0.5}) ==
        Approx(0.0106).margin(1e-4));
  // By the constant 2.024 of four looks: Phi(-2.024 sqrt(4)) and Phi(-2.024).
  CHECK(level_of_look(constant_of(0.025, {.looks = 4, .shape = 0}), 1, {.looks = 4, .shape = 0}) ==
        Approx(2.58e-5).epsilon(0.02));
  CHECK(level_of_look(constant_of(0.025, {.looks = 4, .shape = 0}), 4, {.looks = 4, .shape = 0}) ==
        Approx(0.02148).epsilon(0.01));
}

TEST_CASE("a plan out of range is refused", "[group_sequential]") {
  for (const Boundary& boundary :
       {Boundary{.looks = 0}, Boundary{.looks = 101}, Boundary{.shape = -0.1}, Boundary{.shape = 0.6}}) {
    CHECK_THROWS_AS(chance_to_cross(1, boundary), std::invalid_argument);
    CHECK_THROWS_AS(constant_of(0.1, boundary), std::invalid_argument);
    CHECK_THROWS_AS(level_of_look(2, 1, boundary), std::invalid_argument);
  }
}

TEST_CASE("a mean of 0 that is looked at ten times is found to be larger in 5 %, and without the boundary in more",
          "[group_sequential]") {
  constexpr int repetitions = 800, looks = 10;
  const Boundary boundary{.looks = looks};
  std::vector<double> levels;
  for (int look = 1; look <= looks; ++look)
    levels.push_back(level_of_look(constant_of(0.05, boundary), look, boundary));
  std::mt19937_64 random(1);
  double wrong = 0, wrong_without = 0;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    double sum = 0, least_p = 1;
    bool is_found = false;
    for (int look = 1; look <= looks; ++look) {
      sum += normal_quantile((static_cast<double>(random() >> 11) + 0.5) / 9007199254740992.0);
      const double p = 0.5 * std::erfc(sum / std::sqrt(2.0 * look));
      is_found = is_found || p < levels[static_cast<std::size_t>(look) - 1];
      least_p = std::min(least_p, p);
    }
    wrong += is_found ? 1 : 0;
    wrong_without += least_p < 0.05 ? 1 : 0;
  }
  const double error = std::sqrt(0.05 * 0.95 / repetitions);  // 0.0077
  CHECK(wrong / repetitions < 0.05 + 3 * error);
  CHECK(wrong / repetitions > 0.05 - 3 * error);
  CHECK(wrong_without / repetitions > 0.12);
}
