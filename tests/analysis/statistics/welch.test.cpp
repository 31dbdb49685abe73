#include "analysis/statistics/welch.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "analysis/statistics/multiple_comparisons.hpp"
#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;

namespace {

MeanDifference welch(const GroupSummary& a, const GroupSummary& b) { return tamhane(std::array{a, b}, 0.95).front(); }

}  // namespace

TEST_CASE("Welch's test of Student's sleep data is that of R", "[welch]") {
  // R's help page of t.test: t = -1.8608, df = 17.776, p-value = 0.07939; means 0.75 and 2.33.
  const MeanDifference test = welch({.mean = 0.75, .std = 1.789010, .n = 10}, {.mean = 2.33, .std = 2.002249, .n = 10});
  CHECK(test.difference.value / test.standard_error == Approx(-1.8608).epsilon(1e-4));
  CHECK(test.df == Approx(17.776).epsilon(1e-4));
  CHECK(test.p == Approx(0.07939).epsilon(1e-3));
}

TEST_CASE("Welch's analysis of variance of PlantGrowth is that of R", "[welch]") {
  // R 4.2.2, oneway.test(weight ~ group, PlantGrowth): F 5.181, df 2 and 17.128, p 0.01739; means and standard
  // deviations of the groups of ten.
  const std::vector<GroupSummary> groups{{5.032, 0.5830914, 10}, {4.661, 0.7936757, 10}, {5.526, 0.4425733, 10}};
  const Test test = welch_anova(groups);
  CHECK(test.statistic == Approx(5.1809724).epsilon(1e-6));
  CHECK(test.df == 2);
  CHECK(test.df_within == Approx(17.1284186).epsilon(1e-6));
  CHECK(test.p == Approx(0.0173928).epsilon(1e-5));
}

TEST_CASE("Welch's analysis of two groups is the square of his t", "[welch]") {
  const GroupSummary a{0.75, 1.789010, 10}, b{2.33, 2.002249, 10};
  const MeanDifference t = welch(a, b);
  const Test test = welch_anova(std::vector<GroupSummary>{a, b});
  CHECK(test.statistic == Approx(t.q * t.q / 2));
  CHECK(test.df_within == Approx(t.df));
  CHECK(test.p == Approx(t.p));
}

TEST_CASE("Welch's analysis of variance needs two groups with spread", "[welch]") {
  const GroupSummary a{1, 1, 5};
  const auto reason = [&](const GroupSummary& other) {
    const Test test = welch_anova(std::vector<GroupSummary>{a, other});
    CHECK(std::isnan(test.p));
    CHECK(std::isnan(test.statistic));
    return ikbench::samples::numbered(test.undefined);
  };
  CHECK(welch_anova({}).undefined.find("no group") != std::string::npos);
  CHECK(welch_anova(std::vector<GroupSummary>{a}).undefined.find("one group") != std::string::npos);
  CHECK(reason({1, 0, 5}) == "group 2 is constant");
  CHECK(reason({1, 1, 1}) == "group 2 has fewer than two values, so no spread");
  CHECK(reason({not_defined, 1, 5}) == "the mean or the standard deviation of group 2 is not defined");
  CHECK(reason({1, HUGE_VAL, 5}) == "the mean or the standard deviation of group 2 is not defined");
  CHECK(reason({1, 1e200, 5}).find("too far apart") != std::string::npos);
  CHECK(reason({1e308, 1, 5}).find("too far apart") != std::string::npos);
  CHECK(welch_anova(std::vector<GroupSummary>{a, {2, 1, 5}}).undefined.empty());
}

TEST_CASE("the unit of the values changes none of Welch's tests, to where squares vanish or overflow", "[welch]") {
  const double unit = GENERATE(0x1p-1000, 0x1p-540, 0x1p600, 0x1p1000);  // powers of two: no digit is lost
  const auto scaled = [unit](const GroupSummary& group) {
    return GroupSummary{group.mean * unit, group.std * unit, group.n};
  };
  const GroupSummary a{0.75, 1.789010, 10}, b{2.33, 2.002249, 10};
  CHECK(welch(scaled(a), scaled(b)).p == Approx(welch(a, b).p).epsilon(1e-14));
  CHECK(welch(scaled(a), scaled(b)).df == Approx(welch(a, b).df).epsilon(1e-14));
  const std::vector<GroupSummary> groups{a, b}, others{scaled(a), scaled(b)};
  CHECK(welch_anova(others).p == welch_anova(groups).p);
  CHECK(welch_anova(others).df_within == welch_anova(groups).df_within);
}

TEST_CASE("equal groups have p = 1", "[welch]") {
  CHECK(welch({.mean = 1, .std = 1, .n = 5}, {.mean = 1, .std = 1, .n = 5}).p == Approx(1));
}

TEST_CASE("a constant group against one with spread is a one-sample t-test", "[welch]") {
  // t = 1 / (2 / sqrt 4) = 1 on 3 degrees of freedom: p = 1/3 + 1/2 ... = 0.391002 (t table).
  const MeanDifference test = welch({.mean = 2, .std = 2, .n = 4}, {.mean = 1, .std = 0, .n = 20});
  CHECK(test.df == Approx(3));
  CHECK(test.p == Approx(0.391002).epsilon(1e-5));
}

TEST_CASE("Student's test of the pairs of the sleep data is that of R", "[welch]") {
  // R's help page of t.test: t = -4.0621, df = 9, p-value = 0.002833, interval -2.4598858 to -0.7001142.
  const std::vector<double> drug_1{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
  const std::vector<double> drug_2{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};
  const MeanDifference test = paired_t(drug_1, drug_2, 0.95);
  CHECK(test.difference.value == Approx(-1.58));
  CHECK(test.difference.value / test.standard_error == Approx(-4.0621).epsilon(1e-5));
  CHECK(test.df == 9);
  CHECK(test.p == Approx(0.002833).epsilon(2e-4));
  CHECK(test.difference.low == Approx(-2.4598858).epsilon(1e-7));
  CHECK(test.difference.high == Approx(-0.7001142).epsilon(1e-7));
}

TEST_CASE("Student's interval of a mean is that of R", "[welch]") {
  // R 4.2.2, t.test(extra[group == 1]) of the sleep data: -0.5297804 to 2.0297804.
  const Estimate interval = mean_interval({.mean = 0.75, .std = 1.789010, .n = 10}, 0.95);
  CHECK(interval.low == Approx(-0.5297804).epsilon(1e-6));
  CHECK(interval.high == Approx(2.0297804).epsilon(1e-6));
  CHECK(mean_interval({.mean = 3, .std = 0, .n = 4}, 0.95).high == 3);
}

TEST_CASE("pairs or a mean without spread say so", "[welch]") {
  const auto reason = [](const std::vector<double>& a, const std::vector<double>& b) {
    return paired_t(a, b, 0.95).undefined;
  };
  CHECK(reason({1, 2, 3}, {2, 3, 4}).find("differ by the same") != std::string::npos);
  CHECK(reason({1}, {2}).find("fewer than two") != std::string::npos);
  CHECK(reason({}, {}).find("fewer than two") != std::string::npos);
  CHECK(reason({1, not_defined}, {1, 2}).find("not defined") != std::string::npos);
  CHECK(reason({1, HUGE_VAL}, {1, HUGE_VAL}).find("not defined") != std::string::npos);
  CHECK(std::isnan(mean_interval({.mean = 1, .std = not_defined, .n = 1}, 0.95).low));
  CHECK(std::isnan(mean_interval({.mean = 0, .std = 1e308, .n = 2}, 0.95).high));
  CHECK_THROWS_AS(paired_t(std::vector<double>{1, 2}, std::vector<double>{1}, 0.95), std::invalid_argument);
  CHECK_THROWS_AS(mean_interval({1, 1, 5}, 1.5), std::invalid_argument);
}
