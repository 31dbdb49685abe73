#include <cmath>
#include <limits>
#include <vector>

#include "analysis/statistics/mann_whitney.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;

using Sample = std::vector<double>;

TEST_CASE("the pain scores of Brunner and Munzel have the p of R and SciPy", "[brunner_munzel]") {
  // Their example, also that of R's lawstat::brunner.munzel.test (3.1375, df 17.683, p 0.005786, estimate 0.788961);
  // SciPy 1.10.1 brunnermunzel gives 3.1374674823029505 and 0.005786208666151538.
  const Sample first{1, 2, 1, 1, 1, 1, 1, 1, 1, 1, 2, 4, 1, 1}, second{3, 3, 4, 3, 1, 2, 3, 1, 1, 5, 4};
  const Test test = brunner_munzel(first, second);
  CHECK(test.statistic == Approx(-3.1374674823029505).epsilon(1e-13));
  CHECK(test.df == Approx(17.683).epsilon(1e-4));
  CHECK(test.p == Approx(0.005786208666151538).epsilon(1e-11));
  CHECK(brunner_munzel(second, first).statistic == Approx(3.1374674823029505).epsilon(1e-13));
  CHECK(brunner_munzel(second, first).p == test.p);
}

TEST_CASE("PlantGrowth and the ozone of May and August have the p of SciPy", "[brunner_munzel]") {
  // SciPy 1.10.1, brunnermunzel.
  const Sample control{4.17, 5.58, 5.18, 6.11, 4.50, 4.61, 5.17, 4.53, 5.33, 5.14};
  const Sample one{4.81, 4.17, 4.41, 3.59, 5.87, 3.83, 6.03, 4.89, 4.32, 4.69};
  const Sample two{6.31, 5.12, 5.54, 5.50, 5.37, 5.29, 4.92, 6.15, 5.80, 5.26};
  CHECK(brunner_munzel(control, one).p == Approx(0.1978083989376457).epsilon(1e-11));
  CHECK(brunner_munzel(control, two).p == Approx(0.044718863185473134).epsilon(1e-11));
  CHECK(brunner_munzel(one, two).p == Approx(0.011244179779992036).epsilon(1e-11));
  const Sample may{41, 36, 12, 18, 28, 23, 19, 8, 7, 16, 11, 14, 18, 14, 34, 6, 30, 11, 1, 11, 4, 32, 23, 45, 115, 37};
  const Sample august{39, 9,  16, 78, 35, 66, 122, 89,  110, 44, 28,  65, 22,
                      59, 23, 31, 44, 21, 9,  45,  168, 73,  76, 118, 84, 85};
  CHECK(brunner_munzel(august, may).statistic == Approx(5.09152681621113).epsilon(1e-13));
  CHECK(brunner_munzel(august, may).p == Approx(5.869131577851405e-06).epsilon(1e-10));
}

TEST_CASE("by hand: two against two that interlock", "[brunner_munzel]") {
  // 1 3 against 2 4: placements 0 1 and 1 2 of two, so above = 1/4; the variances are 1/2, over 2 * 2^2 each;
  // t = -1/4 / sqrt(1/8) = -1/sqrt(2) with two degrees of freedom: p = 1 - t / sqrt(2 + t^2) = 1 - 1 / sqrt(5).
  const Test test = brunner_munzel(Sample{1, 3}, Sample{2, 4});
  CHECK(test.statistic == Approx(-1 / std::sqrt(2.0)).epsilon(1e-14));
  CHECK(test.df == Approx(2).epsilon(1e-14));
  CHECK(test.p == Approx(1 - 1 / std::sqrt(5.0)).epsilon(1e-12));
}

TEST_CASE("without overlap, p is the share of the two arrangements without overlap", "[brunner_munzel]") {
  CHECK(brunner_munzel(Sample{1, 2, 3}, Sample{4, 5, 6}).p == Approx(0.1));          // 2 of 20
  CHECK(brunner_munzel(Sample{4, 5, 6, 7}, Sample{1, 2, 3}).p == Approx(2.0 / 35));  // of 35
  CHECK(brunner_munzel(Sample{4, 5, 6, 7}, Sample{1, 2, 3}).statistic == std::numeric_limits<double>::infinity());
  CHECK(brunner_munzel(Sample{1, 1}, Sample{2, 2}).p == Approx(1.0 / 3));
}

TEST_CASE("only the order counts, and infinite values have their place in it", "[brunner_munzel]") {
  const double inf = std::numeric_limits<double>::infinity();
  const double p = brunner_munzel(Sample{1, 3, 5, 9}, Sample{2, 4, 8, 10}).p;
  CHECK(brunner_munzel(Sample{1e-9, 3, 5, 1e9}, Sample{2, 4, 8, inf}).p == p);
}

TEST_CASE("what has no answer says why", "[brunner_munzel]") {
  CHECK(brunner_munzel(Sample{1}, Sample{2, 3}).undefined == "a sample has fewer than two values");
  CHECK(brunner_munzel(Sample{}, Sample{}).undefined == "a sample has fewer than two values");
  CHECK(brunner_munzel(Sample{1, 1}, Sample{1, 1, 1}).undefined == "all values are equal");
  CHECK(std::isnan(brunner_munzel(Sample{1, 1}, Sample{1, 1, 1}).p));
  CHECK_FALSE(brunner_munzel(Sample{1, not_defined}, Sample{1, 2}).undefined.empty());
}
