#include "analysis/statistics/mean_ratio.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "analysis/statistics/welch.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;

namespace {

using Values = std::vector<double>;

// R's data set sleep: hours gained by ten people with each of two drugs.
const Values drug_1{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
const Values drug_2{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};

}  // namespace

TEST_CASE("the ratio of 2 4 6 to 1 2 3 by hand", "[mean_ratio]") {
  // Means 4 and 2, squared errors 4/3 and theta^2 / 3. t at 1, 1.5 and 0.5: 1.549193, 0.692820, 2.520504
  // on 2.941176, 3.709199 and 2.249027 degrees of freedom; their tails by mpmath 1.3.0.
  const RatioComparison result = mean_ratio(Values{1, 2, 3}, Values{2, 4, 6}, {.margin = 0.5, .level = 0.9});
  CHECK(result.ratio == Approx(2));
  CHECK(result.df == Approx(50.0 / 17));
  CHECK(result.p_difference == Approx(2 * 0.110440420247048).epsilon(1e-11));
  CHECK(result.p_above == Approx(0.264671282044847).epsilon(1e-11));
  CHECK(result.p_below == Approx(1 - 0.0570647188477114).epsilon(1e-11));
  CHECK(result.p_equivalent == Approx(1 - 0.264671282044847).epsilon(1e-11));
  CHECK(result.exact.empty());
  CHECK(result.undefined.empty());
}

TEST_CASE("beyond the margin is beyond the relative and the absolute one, and within it is within either",
          "[mean_ratio]") {
  // As above; mean(b) - mean(a) is 2, so that with an absolute margin of 2 it lies on the margin: t = 0.
  const Values a{1, 2, 3}, b{2, 4, 6};
  const RatioComparison on_it = mean_ratio(a, b, {.margin = 0.5, .absolute_margin = 2});
  CHECK(on_it.p_above == Approx(0.5));
  CHECK(on_it.p_equivalent == Approx(0.5));
  CHECK(on_it.p_below > 0.9);
  const RatioComparison small = mean_ratio(a, b, {.margin = 0.5, .absolute_margin = 0.001});
  const RatioComparison none = mean_ratio(a, b, {.margin = 0.5});
  CHECK(small.p_above == none.p_above);  // the relative margin is the larger
  CHECK(small.p_equivalent == none.p_equivalent);
  CHECK(small.ratio == none.ratio);
  const RatioComparison pairs = paired_mean_ratio(a, b, {.margin = 0.5, .absolute_margin = 2});
  CHECK(pairs.p_above == Approx(0.5));  // differences 1, 2, 3
  const RatioComparison no_ratio = mean_ratio(Values{-1, 0, 1}, b, {.margin = 0.5, .absolute_margin = 4});
  CHECK(no_ratio.undefined == "the mean of the first sample is not positive, so there is no ratio to it");
  CHECK(no_ratio.p_above == Approx(0.5));
  CHECK(paired_mean_ratio(Values{0.1, 0.1}, Values{0.11, 0.11}, {.margin = 0, .absolute_margin = 0.02}).p_equivalent ==
        0);
  CHECK_THROWS_AS(mean_ratio(a, b, {.absolute_margin = -1}), std::invalid_argument);
}

TEST_CASE("at a ratio of 1 the test is Welch's, and Student's of pairs", "[mean_ratio]") {
  const RatioComparison independent = mean_ratio(drug_1, drug_2, {});
  const WelchTest test = welch(summarise(drug_1), summarise(drug_2));
  CHECK(independent.p_difference == Approx(test.p));
  CHECK(independent.df == Approx(test.df));
  const RatioComparison pairs = paired_mean_ratio(drug_1, drug_2, {});
  CHECK(pairs.p_difference == Approx(0.002833).epsilon(2e-4));  // R's help page of t.test, paired
  CHECK(pairs.df == 9);
}

TEST_CASE("pairs of twice the time have the ratio 2 without doubt", "[mean_ratio]") {
  // b = 2 a, a = 1 2 3: b - 1.05 a = 0.95 a, t = 2 sqrt 3 on 2: p = (1 - t / sqrt(2 + t^2)) / 2 = 0.0370899.
  const RatioComparison result = paired_mean_ratio(Values{1, 2, 3}, Values{2, 4, 6}, {});
  CHECK(result.ratio == 2);
  CHECK(result.p_above == Approx(0.0370899).epsilon(1e-5));
  CHECK(result.p_difference == Approx(2 * 0.0370899).epsilon(1e-5));
  CHECK(result.low == 2);
  CHECK(result.high == 2);
}

TEST_CASE("the interval of paired ratios is Fieller's closed form", "[mean_ratio]") {
  // Roots of (mA^2 - t^2 vA) x^2 - 2 (mA mB - t^2 c) x + mB^2 - t^2 vB, with variances and covariance of the means.
  const Values a{10, 12, 9, 11, 13}, b{12, 13, 9, 14, 15};
  const double m_a = 11, m_b = 12.6, v_a = 10.0 / 20, v_b = 21.2 / 20, c = 13.0 / 20;
  const double t2 = 2.776445105 * 2.776445105;  // t table, 4 degrees of freedom
  const double p = m_a * m_a - t2 * v_a, q = m_a * m_b - t2 * c, r = m_b * m_b - t2 * v_b;
  const RatioComparison result = paired_mean_ratio(a, b, {});
  CHECK(result.low == Approx((q - std::sqrt(q * q - p * r)) / p).epsilon(1e-8));
  CHECK(result.high == Approx((q + std::sqrt(q * q - p * r)) / p).epsilon(1e-8));
}

TEST_CASE("the interval's bounds are where the one-sided tests turn", "[mean_ratio]") {
  const auto method = GENERATE(mean_ratio, paired_mean_ratio);
  const double scale = GENERATE(0.3, 0.9, 1.0, 1.04, 1.3, 8.0);
  Values a, b;
  for (int i = 0; i < 12; ++i) {
    a.push_back(5 + std::fmod(i * 0.6180339887, 1.0));
    b.push_back(scale * (5 + std::fmod(i * 0.7548776662, 1.0)));
  }
  const double alpha = 0.05;
  const RatioComparison at_level = method(a, b, {.margin = 0, .level = 1 - 2 * alpha});
  REQUIRE(at_level.low < at_level.ratio);
  REQUIRE(at_level.high > at_level.ratio);
  for (double margin = 0; margin < 0.99; margin += 0.01) {
    const RatioComparison result = method(a, b, {.margin = margin, .level = 1 - 2 * alpha});
    CAPTURE(scale, margin, result.low, result.high);
    CHECK((result.p_above < alpha) == (result.low > 1 + margin));
    CHECK((result.p_below < alpha) == (result.high < 1 - margin));
    CHECK((result.p_equivalent < alpha) == (result.low > 1 - margin && result.high < 1 + margin));
  }
  if (at_level.low > 1 && at_level.low < 1.9) {  // at the bound itself the p is the level's
    CHECK(method(a, b, {.margin = at_level.low - 1}).p_above == Approx(alpha).epsilon(1e-6));
  }
}

TEST_CASE("an interval has no bounds where the denominator is not told from zero", "[mean_ratio]") {
  const RatioComparison result = mean_ratio(Values{-1, 0, 2}, Values{5, 6, 7}, {});
  CHECK(result.ratio == Approx(18));
  CHECK(std::isnan(result.low));
  CHECK(std::isnan(result.high));
  CHECK(std::isfinite(result.p_above));
  CHECK(result.undefined.empty());
}

TEST_CASE("a mean that is not positive has no ratio to it, but a difference", "[mean_ratio]") {
  for (const auto method : {mean_ratio, paired_mean_ratio}) {
    for (const Values& a : {Values{-1, 0, 1}, Values{-3, -2, -1}}) {
      const RatioComparison result = method(a, Values{5, 6, 8}, {});
      CHECK(std::isnan(result.ratio));
      CHECK(std::isnan(result.p_equivalent));
      CHECK(result.p_difference < 0.02);
      CHECK(result.undefined.find("not positive") != std::string::npos);
    }
  }
}

TEST_CASE("equal pairs are equal, not probably equal", "[mean_ratio]") {
  const RatioComparison result = paired_mean_ratio(Values{1, 2, 3}, Values{1, 2, 3}, {});
  CHECK(result.exact == "all pairs are equal");
  CHECK(result.ratio == 1);
  CHECK(result.low == 1);
  CHECK(result.high == 1);
  CHECK(result.p_difference == 1);
  CHECK(result.p_above > 0.9);  // b - 1.05 a = -0.05 a still spreads
  CHECK(result.p_equivalent < 0.05);
}

TEST_CASE("constant samples are compared as facts", "[mean_ratio]") {
  const auto method = GENERATE(mean_ratio, paired_mean_ratio);
  const auto [b, difference, above, below, equivalent] = GENERATE(table<double, double, double, double, double>(
      {{3.0, 1, 1, 1, 0}, {3.1, 0, 1, 1, 0}, {3.3, 0, 0, 1, 1}, {2.8, 0, 1, 0, 1}, {3.15, 0, 1, 1, 1}}));
  const RatioComparison result = method(Values{3, 3, 3}, Values{b, b, b}, {});  // margin 0.05: 2.85 to 3.15
  CAPTURE(b);
  CHECK_FALSE(result.exact.empty());
  CHECK(result.ratio == Approx(b / 3));
  CHECK(result.low == result.ratio);
  CHECK(result.p_difference == difference);
  CHECK(result.p_above == above);
  CHECK(result.p_below == below);
  CHECK(result.p_equivalent == equivalent);
}

TEST_CASE("a ratio that cannot be had says why", "[mean_ratio]") {
  const auto method = GENERATE(mean_ratio, paired_mean_ratio);
  const auto [a, b, reason] =
      GENERATE(table<Values, Values, std::string>({{{}, {}, "fewer than two"},
                                                   {{1}, {2}, "fewer than two"},
                                                   {{1, not_defined}, {1, 2}, "not finite"},
                                                   {{1, 2}, {1, HUGE_VAL}, "not finite"},
                                                   {{1e-300, 1e-300}, {1e20, 2e20}, "too large"},
                                                   {{-1.7e308, -1.6e308}, {1.7e308, 1e308}, "too large"}}));
  const RatioComparison result = method(a, b, {});
  CAPTURE(reason, result.undefined);
  CHECK(result.undefined.find(reason) != std::string::npos);
  CHECK(std::isnan(result.ratio));
  CHECK(std::isnan(result.p_above));
}

TEST_CASE("an interval of next to no level is the ratio", "[mean_ratio]") {
  const RatioComparison result = mean_ratio(Values{3, 7, 8}, Values{2, 2.5, 9}, {.margin = 0, .level = 1e-15});
  CHECK(result.low == Approx(result.ratio));
  CHECK(result.high == Approx(result.ratio));
}

TEST_CASE("the unit of time changes no ratio", "[mean_ratio]") {
  const double unit = GENERATE(1e-300, 1e-140, 1e-3, 1e140, 1e305);
  const auto method = GENERATE(mean_ratio, paired_mean_ratio);
  Values a{10, 12, 9, 11, 13}, b{12, 13, 9, 14, 15};
  const RatioComparison expected = method(a, b, {});
  for (double& value : a) value *= unit;
  for (double& value : b) value *= unit;
  const RatioComparison result = method(a, b, {});
  CHECK(result.low == Approx(expected.low));
  CHECK(result.high == Approx(expected.high));
  CHECK(result.p_above == Approx(expected.p_above));
  CHECK(result.p_equivalent == Approx(expected.p_equivalent));
}

TEST_CASE("a margin or a level out of range is refused, and pairs must be pairs", "[mean_ratio]") {
  const Values a{1, 2}, three{1, 2, 3};
  CHECK_THROWS_AS(mean_ratio(a, a, {.margin = 1}), std::invalid_argument);
  CHECK_THROWS_AS(mean_ratio(a, a, {.margin = -0.1}), std::invalid_argument);
  CHECK_THROWS_AS(mean_ratio(a, a, {.margin = not_defined}), std::invalid_argument);
  CHECK_THROWS_AS(mean_ratio(a, a, {.margin = 0, .level = 1}), std::invalid_argument);
  CHECK_THROWS_AS(paired_mean_ratio(a, three, {}), std::invalid_argument);
}
