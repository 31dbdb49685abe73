#include <cmath>
#include <vector>

#include "analysis/statistics/proportion.hpp"
#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

TEST_CASE("McNemar's exact test is the sign test of the trials that tell two apart", "[paired_proportion]") {
  CHECK(mcnemar_exact({36, 12, 2, 0}) == Approx(2 * (1 + 14 + 91) / 16384.0));  // 2 P(at most 2 of 14)
  CHECK(mcnemar_exact({12, 9, 2, 21}) == Approx(0.0654296875));                 // SciPy 1.10.1, binomtest(2, 11)
  CHECK(mcnemar_exact({5, 3, 3, 5}) == 1);
  CHECK(mcnemar_exact({7, 0, 0, 3}) == 1);
}

TEST_CASE("the difference of two shares of the same trials has Newcombe's interval", "[paired_proportion]") {
  // Newcombe, Statistics in Medicine 17 (1998) 2635, method 10, by an independent script with SciPy 1.10.1.
  const Estimate first = newcombe_paired({36, 12, 2, 0}, 0.95);
  CHECK(first.value == Approx(0.2));
  CHECK(first.low == Approx(0.05692958400323875).epsilon(1e-10));
  CHECK(first.high == Approx(0.3404276029749407).epsilon(1e-10));
  const Estimate second = newcombe_paired({1, 1, 7, 12}, 0.95);
  CHECK(second.low == Approx(-0.506920226686141).epsilon(1e-10));
  CHECK(second.high == Approx(-0.02555912416485978).epsilon(1e-10));
  const Estimate all = newcombe_paired({0, 30, 0, 0}, 0.95);  // no correlation where a share is 0 or 1
  CHECK(all.low == Approx(0.8394678198623838).epsilon(1e-10));
  CHECK(all.high == 1);
  CHECK(std::isnan(newcombe_paired({}, 0.95).low));
}

TEST_CASE("swapping the two turns the interval round", "[paired_proportion]") {
  const Estimate one = newcombe_paired({12, 9, 2, 21}, 0.9), other = newcombe_paired({12, 2, 9, 21}, 0.9);
  CHECK(one.low == Approx(-other.high));
  CHECK(one.high == Approx(-other.low));
}
