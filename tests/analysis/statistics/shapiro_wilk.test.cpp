#include "analysis/statistics/shapiro_wilk.hpp"

#include <cmath>
#include <vector>

#include "analysis/statistics/tails.hpp"
#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

using Sample = std::vector<double>;

namespace {

Sample normal_scores(int n) {
  Sample scores;
  for (int i = 1; i <= n; ++i) scores.push_back(normal_quantile((i - 0.375) / (n + 0.25)));
  return scores;
}

}  // namespace

TEST_CASE("Shapiro and Wilk's eleven weights have the W and p of R", "[shapiro_wilk]") {
  const Test test = shapiro_wilk(Sample{148, 154, 158, 160, 161, 162, 166, 170, 182, 195, 236});
  CHECK(test.statistic == Approx(0.7888146948).epsilon(1e-9));  // R 4.2.2, shapiro.test; 0.79 in the paper of 1965
  CHECK(test.p == Approx(0.00670381406).epsilon(1e-8));
}

TEST_CASE("PlantGrowth has the p of R, by group and of the residuals", "[shapiro_wilk]") {
  CHECK(shapiro_wilk(plant_growth[0]).p == Approx(0.747473443830).epsilon(1e-9));  // R 4.2.2, shapiro.test
  CHECK(shapiro_wilk(plant_growth[1]).p == Approx(0.451943960318).epsilon(1e-9));
  CHECK(shapiro_wilk(plant_growth[2]).p == Approx(0.564251894772).epsilon(1e-9));
  Sample residuals;
  for (const auto& group : plant_growth) {
    for (const double value : group) residuals.push_back(value - mean(group));
  }
  CHECK(shapiro_wilk(residuals).statistic == Approx(0.96606811887418).epsilon(1e-11));
  CHECK(shapiro_wilk(residuals).p == Approx(0.4378985955062).epsilon(1e-9));
}

TEST_CASE("three values have an exact p", "[shapiro_wilk]") {
  CHECK(shapiro_wilk(Sample{1, 2, 3}).statistic == Approx(1));
  CHECK(shapiro_wilk(Sample{1, 2, 3}).p == Approx(1).epsilon(1e-6));
  // 0 0 1: W = (1 / sqrt 2)^2 / (2 / 3) = 3 / 4, the least there is. Its p of 0 would say no more than that two are
  // equal.
  CHECK(shapiro_wilk(Sample{0, 0, 1}).statistic == Approx(0.75));
  CHECK(std::isnan(shapiro_wilk(Sample{0, 0, 1}).p));
  CHECK(shapiro_wilk(Sample{5, 2, 5}).undefined == "two of three values are equal");
  // 0 1 4: W = 8 / (26 / 3) = 12 / 13; p = 6 / pi (asin sqrt(12 / 13) - pi / 3).
  const double pi = std::acos(-1.0);
  CHECK(shapiro_wilk(Sample{0, 1, 4}).p == Approx(6 / pi * (std::asin(std::sqrt(12.0 / 13)) - pi / 3)).epsilon(1e-12));
}

TEST_CASE("normal scores are normal, their exponentials are not", "[shapiro_wilk]") {
  const int n = GENERATE(4, 5, 6, 11, 12, 50, 500, 5000);
  Sample scores = normal_scores(n);
  CAPTURE(n);
  CHECK(shapiro_wilk(scores).statistic > 0.97);
  CHECK(shapiro_wilk(scores).statistic <= 1);
  CHECK(shapiro_wilk(scores).p > 0.9);
  for (double& score : scores) score = std::exp(3 * score);
  CHECK(shapiro_wilk(scores).statistic < 0.85);
  if (n > 10) CHECK(shapiro_wilk(scores).p < 0.01);
}

TEST_CASE("W knows neither place nor unit nor order", "[shapiro_wilk]") {
  const auto [factor, shift] = GENERATE(table<double, double>({{1e-300, 0}, {1e300, 0}, {-1, 0}, {0.25, 1048576}}));
  Sample sample{148, 154, 158, 160, 161, 162, 166, 170, 182, 195, 236};
  for (double& value : sample) value = factor * value + shift;
  CHECK(shapiro_wilk(sample).statistic == Approx(0.7888146948).epsilon(1e-9));
}

TEST_CASE("a sample as wide as double precision has a W", "[shapiro_wilk]") {
  CHECK(shapiro_wilk(Sample{-1.7e308, 0, 1.7e308}).statistic == Approx(1));
  CHECK(shapiro_wilk(Sample{0, 5e-324, 1e-323}).statistic == Approx(1));
}

TEST_CASE("where there is no W the test says why", "[shapiro_wilk]") {
  CHECK(says(shapiro_wilk({}).undefined, "0 values"));
  CHECK(says(shapiro_wilk(Sample{1, 2}).undefined, "2 values"));
  CHECK(says(shapiro_wilk(Sample(5001, 1.0)).undefined, "5001 values"));
  CHECK(says(shapiro_wilk(Sample{1, 1, 1}).undefined, "equal"));
  CHECK(says(shapiro_wilk(Sample{1, NAN, 2}).undefined, "not finite"));
  CHECK(says(shapiro_wilk(Sample{1, HUGE_VAL, 2}).undefined, "not finite"));
  CHECK(std::isnan(shapiro_wilk(Sample{1, 1, 1}).p));
}
