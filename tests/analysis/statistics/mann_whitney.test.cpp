#include "analysis/statistics/mann_whitney.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

using Sample = std::vector<double>;

TEST_CASE("the permeability data have the exact p of R", "[mann_whitney]") {
  // R's help page of wilcox.test (Hollander and Wolfe 1973, p. 69): W = 35, one-sided p 0.1272 = 382 / 3003 (counted).
  const Sample term{0.80, 0.83, 1.89, 1.04, 1.45, 1.38, 1.91, 1.64, 0.73, 1.46}, week{1.15, 0.88, 0.90, 0.74, 1.21};
  const Test test = mann_whitney(term, week);
  CHECK(test.statistic == 35);
  CHECK(test.p == Approx(764.0 / 3003).epsilon(1e-13));
}

TEST_CASE("the ozone of May and August has the approximate p of R", "[mann_whitney]") {
  // R's help page of wilcox.test, airquality, months 5 and 8: W = 127.5, p = 0.0001208.
  const Sample may{41, 36, 12, 18, 28, 23, 19, 8, 7, 16, 11, 14, 18, 14, 34, 6, 30, 11, 1, 11, 4, 32, 23, 45, 115, 37};
  const Sample august{39, 9,  16, 78, 35, 66, 122, 89,  110, 44, 28,  65, 22,
                      59, 23, 31, 44, 21, 9,  45,  168, 73,  76, 118, 84, 85};
  const Test test = mann_whitney(may, august);
  CHECK(test.statistic == 127.5);
  CHECK(test.p == Approx(0.0001208).epsilon(1e-3));
}

TEST_CASE("the exact distribution of two and three values, counted by hand", "[mann_whitney]") {
  // Ten arrangements: one has U = 0 and one U = 6; one has U = 1; two each have U = 2 and 3.
  CHECK(mann_whitney(Sample{1, 2}, Sample{3, 4, 5}).p == Approx(0.2));
  CHECK(mann_whitney(Sample{4, 5}, Sample{1, 2, 3}).p == Approx(0.2));
  CHECK(mann_whitney(Sample{1, 3}, Sample{2, 4, 5}).p == Approx(0.4));
  CHECK(mann_whitney(Sample{1, 4}, Sample{2, 3, 5}).p == Approx(0.8));
  CHECK(mann_whitney(Sample{2, 3}, Sample{1, 4, 5}).p == Approx(0.8));
  CHECK(mann_whitney(Sample{3, 2}, Sample{1, 2.5, 5}).p == 1);
}

TEST_CASE("swapping the samples keeps p and turns U round", "[mann_whitney]") {
  const Sample a{1, 4, 6, 9.5}, b{2, 3, 5, 8, 12};
  const Test one = mann_whitney(a, b), other = mann_whitney(b, a);
  CHECK(one.statistic + other.statistic == 20);
  CHECK(one.p == Approx(other.p));
}

TEST_CASE("49 against 49 separated values: exact, one arrangement in all", "[mann_whitney]") {
  Sample low, high;
  for (int i = 0; i < 49; ++i) {
    low.push_back(i);
    high.push_back(100 + i);
  }
  const Test test = mann_whitney(low, high);
  const double log_ways = std::lgamma(99.0) - 2 * std::lgamma(50.0);  // 98! / (49! 49!)
  CHECK(test.p == Approx(2 * std::exp(-log_ways)).epsilon(1e-10));
  low.push_back(49);
  CHECK(mann_whitney(low, high).p !=
        Approx(2 * std::exp(std::lgamma(50.0) + std::lgamma(51.0) - std::lgamma(100.0))).epsilon(1e-3));
}

TEST_CASE("the exact and the approximate p meet at fifty values", "[mann_whitney]") {
  Sample a, b;
  for (int i = 0; i < 49; ++i) {
    a.push_back(i);
    b.push_back(i * 1.1 + 4.03);
  }
  const double exact = mann_whitney(a, b).p;
  const double mean = 49 * 49 / 2.0, sd = std::sqrt(49 * 49 * 99 / 12.0);
  const double z = (std::abs(mann_whitney(a, b).statistic - mean) - 0.5) / sd;
  CHECK(exact == Approx(std::erfc(z / std::sqrt(2.0))).epsilon(0.02));
}

TEST_CASE("failed solves rank last", "[mann_whitney]") {
  const Test test = mann_whitney(Sample{1, 2, 3, 4, HUGE_VAL}, Sample{11, 12, 13, 14, HUGE_VAL});
  // Sixteen finite pairs all negative, four against a failure -inf, four of a failure +inf, one pair of failures equal.
  CHECK(test.statistic == 4.5);
  CHECK(!std::isnan(test.p));
}

TEST_CASE("one value or two on each side have a p", "[mann_whitney]") {
  CHECK(mann_whitney(Sample{1, 2}, Sample{3, 4}).p == Approx(1.0 / 3));
  CHECK(mann_whitney(Sample{1}, Sample{2}).p == 1);
}

TEST_CASE("where the two-sample test has no p it says why", "[mann_whitney]") {
  CHECK(says(mann_whitney({}, Sample{1}).undefined, "no values"));
  CHECK(says(mann_whitney(Sample{1, NAN}, Sample{1}).undefined, "not a number"));
  const Test constant = mann_whitney(Sample{3, 3}, Sample{3});
  CHECK(says(constant.undefined, "all values are equal"));
  CHECK(std::isnan(constant.p));
}
