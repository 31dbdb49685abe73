#include "analysis/statistics/proportion.hpp"

#include <cmath>
#include <stdexcept>

#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

TEST_CASE("18 of 20 have Wilson's interval", "[proportion]") {
  // R 4.2.2, prop.test(18, 20, correct = FALSE)
  CHECK(wilson({18, 20}).value == 0.9);
  CHECK(wilson({18, 20}).low == Approx(0.6989663548).epsilon(1e-9));
  CHECK(wilson({18, 20}).high == Approx(0.9721335188).epsilon(1e-9));
}

TEST_CASE("none or all of n have an interval that ends at 0 or 1", "[proportion]") {
  const double z2 = 1.959963984540054 * 1.959963984540054;
  CHECK(wilson({0, 20}).low == 0);
  CHECK(wilson({0, 20}).high == Approx(z2 / (20 + z2)));  // Wilson's equation at p = 0
  CHECK(wilson({20, 20}).low == Approx(20 / (20 + z2)));
  CHECK(wilson({20, 20}).high == 1);
}

TEST_CASE("a mean of shares has the interval of as many successes, whether or not they are whole", "[proportion]") {
  CHECK(wilson_of_mean(0.9, 20).low == wilson({18, 20}).low);
  CHECK(wilson_of_mean(0.9, 20).high == wilson({18, 20}).high);
  // Wilson's equation at its ends: |0.55 - p| = z sqrt(p (1 - p) / 3).
  const Estimate between = wilson_of_mean(0.55, 3);
  for (const double p : {between.low, between.high}) {
    CHECK(std::abs(0.55 - p) == Approx(1.959963984540054 * std::sqrt(p * (1 - p) / 3)));
  }
  CHECK(wilson_of_mean(0, 3).low == 0);
  CHECK(wilson_of_mean(1, 3).high == 1);
  CHECK(std::isnan(wilson_of_mean(0.5, 0).low));
  CHECK(std::isnan(wilson_of_mean(1.01, 3).low));
  CHECK(std::isnan(wilson_of_mean(NAN, 3).low));
}

TEST_CASE("Fisher's exact test: the tea, the convictions", "[proportion]") {
  // R's help page of fisher.test. Tea 3/4 and 1/4: tables of weights 1 16 36 16 1, two-sided (16 + 1) * 2 / 70.
  CHECK(fisher_exact({3, 4}, {1, 4}) == Approx(34.0 / 70));
  // Convictions of twins, 2/12 and 15/18: p 0.0005367.
  CHECK(fisher_exact({2, 12}, {15, 18}) == Approx(0.0005367241191434358).epsilon(1e-11));  // sums of binomials
  CHECK(fisher_exact({10, 13}, {2, 17}) == Approx(0.0005367241191434358).epsilon(1e-11));  // columns for rows
}

TEST_CASE("Fisher's exact test of hundreds and of a thousand million trials", "[proportion]") {
  CHECK(fisher_exact({180, 200}, {150, 200}) == Approx(0.00011278172795779367).epsilon(1e-10));  // sums of integers
  const double large = fisher_exact({500'000'000, 1'000'000'000}, {500'010'000, 1'000'000'000});
  const double z = 10000 / std::sqrt(2e9 * 0.25);  // the normal limit
  CHECK(large == Approx(std::erfc(z / std::sqrt(2.0))).epsilon(0.01));
  CHECK(fisher_exact({0, 1000}, {1000, 1000}) < 1e-300);
}

TEST_CASE("where there is only one table Fisher's p is 1", "[proportion]") {
  CHECK(fisher_exact({0, 10}, {0, 20}) == 1);
  CHECK(fisher_exact({10, 10}, {20, 20}) == 1);
  CHECK(fisher_exact({1, 1}, {0, 1}) == 1);
}

TEST_CASE("counts that cannot be have no interval and no p", "[proportion]") {
  CHECK(std::isnan(wilson({3, 2}).low));
  CHECK(std::isnan(wilson({-1, 2}).low));
  CHECK(std::isnan(fisher_exact({1, 2}, {0, 0})));
  CHECK(std::isnan(wilson({0, 0}).low));
  CHECK_THROWS_AS(wilson({1, 2}, 95), std::invalid_argument);
}

TEST_CASE("the difference of two shares has Newcombe's interval", "[proportion]") {
  // Newcombe, Statistics in Medicine 17 (1998) 873, Table II, method 10, with four digits.
  struct Published {
    Successes first, second;
    double low, high;
  };
  for (const Published& each :
       {Published{{56, 70}, {48, 80}, 0.0524, 0.3339}, Published{{9, 10}, {3, 10}, 0.1705, 0.8090},
        Published{{5, 56}, {0, 29}, -0.0381, 0.1926}, Published{{0, 10}, {0, 20}, -0.1611, 0.2775},
        Published{{10, 10}, {0, 10}, 0.6075, 1}}) {
    const Estimate found = newcombe(each.first, each.second, 0.95);
    CAPTURE(each.first.successes, each.second.successes);
    CHECK(found.low == Approx(each.low).margin(5.1e-5));
    CHECK(found.high == Approx(each.high).margin(5.1e-5));
  }
  CHECK(newcombe({56, 70}, {48, 80}, 0.95).value == Approx(0.2));
  CHECK(std::isnan(newcombe({1, 2}, {0, 0}, 0.95).low));
}

TEST_CASE("so many trials without a success exclude a larger chance, and no smaller one", "[proportion]") {
  // 0.05^(1 / 20) = 0.8609: a chance of 0.1391 has no success in 20 trials with probability 0.05.
  CHECK(most_without_success(20, 0.05) == Approx(0.13911).epsilon(1e-4));
  CHECK(std::pow(1 - most_without_success(7, 0.01), 7) == Approx(0.01));
  CHECK(most_without_success(0, 0.05) == 1);
}
