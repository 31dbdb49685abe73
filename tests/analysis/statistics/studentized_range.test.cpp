#include "analysis/statistics/studentized_range.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

#include "analysis/statistics/descriptive.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double tail_of(double q, double k, double df) { return StudentizedRange(k).upper_tail(q, df); }

}  // namespace

TEST_CASE("the range of two means is Student's t times the square root of two", "[studentized_range]") {
  // P(Q > q) = 2 P(T > q / sqrt 2), T by Boost.Math's incomplete beta function; tails from 1 to 1e-250.
  const double df = GENERATE(1.0, 1.3, 2.0, 5.3, 19.0, 114.0, 1e4, 1e9);
  for (const double q : {1e-3, 0.3, 1.0, 2.0, 3.77, 6.0, 10.0, 20.0, 40.0, 1e4, 1e80}) {
    const double t_tail = cdf(complement(boost::math::students_t(df), q / std::sqrt(2.0)));
    if (t_tail < 1e-250) continue;
    CAPTURE(df, q, t_tail);
    CHECK(tail_of(q, 2, df) == Approx(2 * t_tail).epsilon(1e-10).margin(0));
  }
}

TEST_CASE("the range of two normal variables is a normal difference", "[studentized_range]") {
  for (const double q : {0.1, 1.0, 5.0, 20.0, 45.0}) {  // P(|Z1 - Z2| > q) = erfc(q / 2)
    CHECK(tail_of(q, 2, infinite) == Approx(std::erfc(q / 2)).epsilon(1e-10).margin(0));
  }
}

TEST_CASE("the range of three normal variables has a closed form in the limit of small ranges", "[studentized_range]") {
  // P(range < w) -> k w^(k-1) times the integral of the density to the k: 3 w^2 / (2 pi sqrt 3) for k = 3.
  const double w = 1e-2;
  const double expected = 3 * w * w / (2 * std::acos(-1.0) * std::sqrt(3.0));
  CHECK(1 - tail_of(w, 3, infinite) == Approx(expected).epsilon(1e-4));
}

TEST_CASE("the critical values of Nemenyi's test leave five percent", "[studentized_range]") {
  // Demsar (2006), Table 5a, with the digits of R 4.2.2, qtukey(0.95, k, Inf) / sqrt(2), which iterates to 1e-4 in q.
  const std::vector<double> at_95{1.959964, 2.343701, 2.569032, 2.727774, 2.849705,
                                  2.948320, 3.030879, 3.101730, 3.163684};
  for (std::size_t i = 0; i < at_95.size(); ++i) {
    const double k = static_cast<double>(i) + 2;
    CAPTURE(k);
    CHECK(tail_of(at_95[i] * std::sqrt(2.0), k, infinite) == Approx(0.05).epsilon(1e-5));
  }
}

TEST_CASE("a small range of three means has the probability of the reference", "[studentized_range]") {
  // SciPy 1.10.1, studentized_range.cdf(0.1, 3, 3); mpmath 1.3.0 has 0.00275027722293600.
  CHECK(1 - tail_of(0.1, 3, 3) == Approx(0.0027502772229359594).epsilon(1e-8));
}

TEST_CASE("tails agree with a quadrature in thirty digits", "[studentized_range]") {
  struct Case {
    double q, k, df, tail;
  };
  // mpmath 1.3.0: Gauss-Legendre over the largest value, trapezoidal over ln s.
  const auto [q, k, df, tail] = GENERATE(values<Case>({
      {3.5, 6, 114, 0.14037362351290922},
      {8, 6, 19.5, 0.00021542920939497612},
      {16, 6, 20.25, 4.5830946540705608e-9},
      {5, 30, 30.5, 0.17448520948512007},
      {6, 200, 12, 0.39434994270841411},
      {4, 3, 3, 0.12882137047966759},
  }));
  CAPTURE(q, k, df);
  CHECK(tail_of(q, k, df) == Approx(tail).epsilon(1e-10).margin(0));
}

TEST_CASE("the tail falls with the range and rises with the number of means", "[studentized_range]") {
  const double df = GENERATE(1.0, 4.4, 60.0, infinite);
  double previous = 1;
  for (double q = 0.25; q < 12; q += 0.25) {
    const double tail = tail_of(q, 5, df);
    CAPTURE(df, q);
    CHECK(tail < previous);
    CHECK(tail < tail_of(q, 6, df));
    previous = tail;
  }
}

TEST_CASE("no argument of the studentized range crashes it", "[studentized_range]") {
  CHECK(tail_of(0, 3, 5) == 1);
  CHECK(tail_of(-1, 3, 5) == 1);
  CHECK(tail_of(infinite, 3, 5) == 0);
  CHECK(tail_of(1e308, 3, infinite) == 0);
  CHECK(tail_of(1e308, 3, 1e308) == 0);
  CHECK(tail_of(1e308, 200, 1) >= 0);
  for (const double bad : {not_defined, -1.0, 0.0, 1.0, 2.5, 1e308, infinite}) {
    CHECK(std::isnan(tail_of(1, bad, 5)));
  }
  for (const double bad : {not_defined, -1.0, 0.0, 0.5}) {
    CHECK(std::isnan(tail_of(1, 3, bad)));
  }
  CHECK(std::isnan(tail_of(not_defined, 3, 5)));
}
