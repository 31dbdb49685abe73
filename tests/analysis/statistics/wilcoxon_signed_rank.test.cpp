#include "analysis/statistics/wilcoxon_signed_rank.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

using Sample = std::vector<double>;

TEST_CASE("the depression data have the exact p of R", "[wilcoxon_signed_rank]") {
  // R's help page of wilcox.test (Hollander and Wolfe 1973, p. 29): V = 40, one-sided p 0.01953 = 10 / 512 (counted).
  const Sample first{1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
  const Sample second{0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};
  const WilcoxonSignedRank test = wilcoxon_signed_rank(first, second);
  CHECK(test.V == 40);
  CHECK(test.n == 9);
  CHECK(test.method == "exact");
  CHECK(test.p == Approx(20.0 / 512).epsilon(1e-14));
}

TEST_CASE("zeros are dropped and counted, and with ties the test is exact too", "[wilcoxon_signed_rank]") {
  // Sizes 1 1 2 3 4 of 1 -1 2 3 4: V = 1.5 + 3 + 4 + 5 = 13.5. Of the 32 signs of the ranks 1.5 1.5 3 4 5 one has a sum
  // of 15 and two have 13.5, and as many 0 and 1.5.
  const WilcoxonSignedRank test = wilcoxon_signed_rank(Sample{1, 0, -1, 2, 0, 3, 4});
  CHECK(test.n == 5);
  CHECK(test.zeros == 2);
  CHECK(test.V == 13.5);
  CHECK(test.direction == 1);
  CHECK(test.method == "exact");
  CHECK(test.p == Approx(6.0 / 32).epsilon(1e-14));
}

TEST_CASE("five equal differences have no smaller p than any five", "[wilcoxon_signed_rank]") {
  CHECK(wilcoxon_signed_rank(Sample{1, 1, 1, 1, 1}).p == Approx(2.0 / 32).epsilon(1e-14));
  CHECK(wilcoxon_signed_rank(Sample{1, 2, 3, -4, 0}).p == wilcoxon_signed_rank(Sample{1, 2, 3, -4}).p);
}

TEST_CASE("of fifty differences or more the test is approximate, corrected for ties", "[wilcoxon_signed_rank]") {
  // By hand: 60 differences of one size, 40 above 0: V = 40 * 30.5, mean 915, variance
  // 60 * 61 * 121 / 24 - (60^3 - 60) / 48 = 13953.75.
  Sample differences(60, 1.0);
  std::fill_n(differences.begin(), 20, -1.0);
  const WilcoxonSignedRank test = wilcoxon_signed_rank(differences);
  CHECK(test.method == "normal approximation");
  CHECK(test.p == Approx(std::erfc(304.5 / std::sqrt(13953.75) / std::sqrt(2.0))).epsilon(1e-12));
}

TEST_CASE("differences of one sign: exactly one of the 2^n signs, twice", "[wilcoxon_signed_rank]") {
  Sample differences;
  for (int n = 1; n < 50; ++n) {
    differences.push_back(n);
    CHECK(wilcoxon_signed_rank(differences).p == Approx(std::min(1.0, std::ldexp(2.0, -n))).epsilon(1e-12));
  }
  differences.push_back(50);
  CHECK(wilcoxon_signed_rank(differences).method == "normal approximation");
}

TEST_CASE("turning the signs keeps p", "[wilcoxon_signed_rank]") {
  const WilcoxonSignedRank one = wilcoxon_signed_rank(Sample{1, -2, 3, 4, -5.5, 6});
  const WilcoxonSignedRank other = wilcoxon_signed_rank(Sample{-1, 2, -3, -4, 5.5, -6});
  CHECK(one.V + other.V == 21);
  CHECK(one.p == Approx(other.p));
}

TEST_CASE("two failures in one pair are equal, one alone is the largest difference", "[wilcoxon_signed_rank]") {
  const Sample first{1, 2, 3, HUGE_VAL, HUGE_VAL}, second{0, 0.5, 0, 0, HUGE_VAL};
  const WilcoxonSignedRank test = wilcoxon_signed_rank(first, second);
  CHECK(test.zeros == 1);
  CHECK(test.V == 10);
  CHECK(!std::isnan(test.p));
}

TEST_CASE("where the signed-rank test has no p it says why", "[wilcoxon_signed_rank]") {
  CHECK(says(wilcoxon_signed_rank(Sample{}).undefined, "no differences"));
  CHECK(says(wilcoxon_signed_rank(Sample{0, 0}).undefined, "all differences are zero"));
  CHECK(says(wilcoxon_signed_rank(Sample{1, NAN}).undefined, "not a number"));
  CHECK(says(wilcoxon_signed_rank(Sample{1, 2}, Sample{1}).undefined, "not pairs"));
  CHECK(std::isnan(wilcoxon_signed_rank(Sample{0, 0}).p));
  CHECK(wilcoxon_signed_rank(Sample{3}).p == 1);
}
