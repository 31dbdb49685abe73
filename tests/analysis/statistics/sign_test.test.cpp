#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/statistics/ranks.hpp"
#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

using Sample = std::vector<double>;

TEST_CASE("the depression data have seven signs of nine", "[sign_test]") {
  // R's help page of wilcox.test (Hollander and Wolfe 1973, p. 29): first is the larger in all but the second and
  // eighth pair. Of 2^9 signs 1 + 9 + 36 have at most two of one kind.
  const Sample first{1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
  const Sample second{0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};
  const Test test = sign_test(first, second);
  CHECK(test.direction == 1);
  CHECK(test.p == Approx(2 * 46.0 / 512).epsilon(1e-12));
  CHECK(sign_test(second, first).p == test.p);
  CHECK(sign_test(second, first).direction == -1);
}

TEST_CASE("pairs of equal values are left out", "[sign_test]") {
  const Test test = sign_test(Sample{1, 0, 2, 5, 0.3}, Sample{0, 0, 1, 4, 0.1 + 0.2});
  CHECK(test.p == Approx(2.0 / 8));
}

TEST_CASE("n signs of one kind are two of the 2^n", "[sign_test]") {
  Sample ahead, behind;
  for (int n = 1; n < 100; ++n) {
    ahead.push_back(n + 1);
    behind.push_back(n);
    CHECK(sign_test(ahead, behind).p == Approx(std::min(1.0, std::ldexp(2.0, -n))).epsilon(1e-10));
  }
}

TEST_CASE("a failure is behind, and two failures in one pair are equal", "[sign_test]") {
  const Test test = sign_test(Sample{1, 2, 3, HUGE_VAL, HUGE_VAL}, Sample{0, 0.5, 0, 0, HUGE_VAL});
  CHECK(test.p == Approx(2.0 / 16));
}

TEST_CASE("where the sign test has no p it says why", "[sign_test]") {
  CHECK(says(sign_test(Sample{}, Sample{}).undefined, "no differences"));
  CHECK(says(sign_test(Sample{1, 2}, Sample{1, 2}).undefined, "all differences are zero"));
  CHECK(says(sign_test(Sample{1, NAN}, Sample{0, 0}).undefined, "not a number"));
  CHECK(says(sign_test(Sample{1, 2}, Sample{1}).undefined, "not pairs"));
  CHECK(std::isnan(sign_test(Sample{0, 0}, Sample{0, 0}).p));
  CHECK(sign_test(Sample{3}, Sample{1}).p == 1);
}
