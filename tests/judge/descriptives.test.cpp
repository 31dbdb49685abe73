#include <boost/math/distributions/normal.hpp>

#include "analysis/judge/statistics/omnibus.hpp"
#include "tests/judge/studies.hpp"

namespace {

// Returns the probability that `k` standard normal numbers lie within `range` of each other: k times the integral, over
// the smallest number x, of phi(x) (Phi(x + range) - Phi(x))^(k - 1).
double range_probability(std::size_t k, double range) {
  const boost::math::normal normal;
  const double step = 0.01;
  double sum = 0;
  for (double x = -9; x < 9; x += step)
    sum += pdf(normal, x) * std::pow(cdf(normal, x + range) - cdf(normal, x), static_cast<double>(k) - 1);
  return static_cast<double>(k) * sum * step;
}

MetricSamples samples_of(std::vector<std::vector<double>> groups) {
  MetricSamples of{.metric = "x", .quantity = "x"};
  for (auto& values : groups) of.groups.push_back({.name = "g", .sample = Sample{std::move(values)}});
  return of;
}

// The groups and the certified F of one of NIST's reference data sets (StRD).
std::pair<std::vector<std::vector<double>>, double> of_nist(const std::string& name) {
  std::ifstream file("tests/data/nist/" + name + ".dat");
  REQUIRE(file);
  std::vector<std::vector<double>> groups;
  double f = 0;
  std::size_t group = 0;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    double value = 0;
    if (line.starts_with("Between ")) f = std::stod(line.substr(line.find_last_of(' ', line.find_last_not_of(" \r"))));
    if (f == 0 || !(words >> group >> value)) continue;
    groups.resize(std::max(groups.size(), group));
    groups[group - 1].push_back(value);
  }
  return {groups, f};
}

// R's data set: ctrl, trt1, trt2.
const std::vector<std::vector<double>> plants{{4.17, 5.58, 5.18, 6.11, 4.50, 4.61, 5.17, 4.53, 5.33, 5.14},
                                              {4.81, 4.17, 4.41, 3.59, 5.87, 3.83, 6.03, 4.89, 4.32, 4.69},
                                              {6.31, 5.12, 5.54, 5.50, 5.37, 5.29, 4.92, 6.15, 5.80, 5.26}};

}  // namespace

TEST_CASE("a group is described as MATLAB does", "[describe]") {
  const Descriptives of = describe_values({1, 2, 3, 4, 9, 2});
  CHECK(of.n == 6);
  CHECK(of.mean == 3.5);
  CHECK(of.sd == Approx(std::sqrt(41.5 / 5)));  // by hand: 6.25 2.25 .25 .25 30.25 2.25
  CHECK(of.median == 2.5);
  CHECK(of.lower_quartile == 2);
  CHECK(of.upper_quartile == 4);
  CHECK(of.quantile_95 == of.largest);
  CHECK(of.smallest == 1);
  CHECK(of.largest == 9);
  CHECK(describe_values({1, 2, 3, 5}).lower_quartile == 1.5);  // at n p + 1/2 = 1.5
  CHECK(describe_values({7}).upper_quartile == 7);
  CHECK(std::isnan(describe_values({7}).sd));
}

TEST_CASE("a difference of means in standard deviations is Hedges'", "[describe]") {
  const std::vector<double> a{1, 2, 3, 4, 5}, b{2, 4, 4, 7, 9, 10};
  CHECK(*hedges_g(summarise(a), summarise(b)) == Approx(-1.06182667).epsilon(1e-8));  // SciPy's gammaln
  CHECK_FALSE(hedges_g({5, 1, 0}, {5, 2, 0}));
  CHECK_FALSE(hedges_g({1, 1, 0}, {2, 2, 1}));
}

TEST_CASE("critical differences of mean ranks are those of Demsar's tables", "[describe]") {
  CHECK(critical_difference(4, 14) == Approx(1.25).epsilon(0.005));  // of his example, section 3.2.2
  for (const auto& [groups, q] : {std::pair(2, 1.960), {3, 2.343}, {5, 2.728}, {10, 3.164}, {20, 3.544}})
    CHECK(critical_difference(static_cast<std::size_t>(groups), static_cast<std::size_t>(groups * (groups + 1))) ==
          Approx(q / std::sqrt(6)).epsilon(0.0006));  // of 20 SciPy's studentized_range
  // With k (k + 1) blocks, the critical difference is the quantile of the studentized range, divided by the root of 12.
  for (std::size_t k = 2; k <= 20; ++k)
    CHECK(range_probability(k, critical_difference(k, k * (k + 1)) * std::sqrt(12)) == Approx(0.95).margin(1e-4));
  CHECK(std::isnan(critical_difference(1, 9)));
  CHECK(std::isnan(critical_difference(21, 9)));
}

TEST_CASE("Friedman's test has the numbers of R", "[describe]") {
  // Hollander and Wolfe's rounding times, friedman.test of R: 11.1429, df 2, p 0.003805.
  MetricSamples rounding = samples_of({{5.40, 5.85, 5.20, 5.55, 5.90, 5.45, 5.40, 5.45, 5.25, 5.85, 5.25,
                                        5.65, 5.60, 5.05, 5.50, 5.45, 5.55, 5.45, 5.50, 5.65, 5.70, 6.30},
                                       {5.50, 5.70, 5.60, 5.50, 5.85, 5.55, 5.40, 5.50, 5.15, 5.80, 5.20,
                                        5.55, 5.35, 5.00, 5.50, 5.55, 5.55, 5.50, 5.45, 5.60, 5.65, 6.30},
                                       {5.55, 5.75, 5.50, 5.40, 5.70, 5.60, 5.35, 5.35, 5.00, 5.70, 5.10,
                                        5.45, 5.45, 4.95, 5.40, 5.50, 5.35, 5.55, 5.25, 5.40, 5.55, 6.25}});
  CHECK(friedman(rounding).empty());  // not paired
  rounding.is_paired = true;
  const std::vector<OmnibusTest> tests = friedman(rounding);
  REQUIRE(tests.size() == 2);
  CHECK(tests[0].df == 2);
  CHECK(tests[1].df_within == 42);
  CHECK(tests[1].statistic == Approx(21 * tests[0].statistic / (22 * 2 - tests[0].statistic)));
  CHECK(friedman(rounding).front().statistic == Approx(11.142857).epsilon(1e-6));
  CHECK(friedman(rounding).front().p == Approx(0.003805).epsilon(1e-3));
  MetricSamples equal = samples_of({{1, 2}, {1, 2}, {1, 2}});
  equal.is_paired = true;
  CHECK(friedman(equal).empty());
}

TEST_CASE("a summary has no more than its three numbers", "[describe]") {
  const Descriptives of = describe({.name = "a", .sample = SummaryStatistics{20, 0.5, 0.1}});
  CHECK(of.n == 20);
  CHECK(of.mean == 0.5);
  CHECK(of.sd == 0.1);
  CHECK(std::isnan(of.median));
  CHECK(describe({.name = "a"}).n == 0);
}

TEST_CASE("ANOVA of PlantGrowth is that of R", "[describe]") {
  const OmnibusTest test = anova(samples_of(plants)).front();
  CHECK(test.statistic == Approx(4.846088).epsilon(1e-6));
  CHECK(test.df == 2);
  CHECK(test.df_within == 27);
  CHECK(test.p == Approx(0.01591).epsilon(1e-3));
  CHECK(test.ss_between == Approx(3.76634).epsilon(1e-6));
  CHECK(test.ss_within == Approx(10.49209).epsilon(1e-6));
}

TEST_CASE("tests of all have the numbers of R, also in blocks", "[describe]") {
  // InsectSprays: aov 34.70.
  const MetricSamples sprays = samples_of({{10, 7, 20, 14, 14, 12, 10, 23, 17, 20, 14, 13},
                                           {11, 17, 21, 11, 16, 14, 17, 17, 19, 21, 7, 13},
                                           {0, 1, 7, 2, 3, 1, 2, 1, 3, 0, 1, 4},
                                           {3, 5, 12, 6, 4, 3, 5, 5, 5, 5, 2, 4},
                                           {3, 5, 3, 5, 3, 6, 1, 1, 3, 2, 6, 4},
                                           {11, 9, 15, 22, 15, 16, 13, 10, 26, 26, 24, 13}});
  CHECK(anova(sprays).front().statistic == Approx(34.70228).epsilon(1e-6));
  // OrchardSprays by row of the orchard: aov with Error(row) 20.908.
  MetricSamples orchard = samples_of({{12, 4, 5, 5, 4, 2, 3, 2},
                                      {8, 6, 8, 14, 4, 7, 10, 4},
                                      {84, 29, 13, 9, 17, 16, 15, 19},
                                      {57, 28, 39, 36, 22, 27, 20, 51},
                                      {43, 95, 114, 39, 51, 55, 47, 61},
                                      {87, 114, 44, 57, 20, 90, 69, 71},
                                      {80, 72, 60, 77, 92, 24, 72, 71},
                                      {130, 72, 127, 69, 86, 81, 81, 76}});
  orchard.is_paired = true;
  CHECK(anova(orchard).front().statistic == Approx(20.9082518).epsilon(1e-8));
  CHECK(anova(orchard).front().df_within == 49);

  // Unequal spreads: oneway.test of R 4.2; rm_anova of pingouin 0.7.0.
  CHECK(anova(samples_of(plants)).back().statistic == Approx(5.181).epsilon(1e-4));
  const OmnibusTest welch = anova(sprays).back();
  CHECK(welch.statistic == Approx(36.0654438936).epsilon(1e-10));
  CHECK(welch.df == 5);
  CHECK(welch.df_within == Approx(30.0425605088).epsilon(1e-10));
  CHECK(welch.p == Approx(7.999379455e-12).epsilon(1e-9));
  const OmnibusTest corrected = anova(orchard).back();
  CHECK(corrected.statistic == anova(orchard).front().statistic);
  CHECK(corrected.epsilon == Approx(0.4984314915).epsilon(1e-9));
  CHECK(corrected.df == 7 * corrected.epsilon);
  CHECK(corrected.p == Approx(2.80996383e-07).epsilon(1e-6));
  // A row in which all are alike decides the same, however large its values are.
  const auto with_row = [&](double value) {
    MetricSamples longer = orchard;
    for (Group& group : longer.groups) values_in(group).push_back(value);
    return anova(longer);
  };
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(with_row(1e30)[i].statistic == Approx(with_row(0)[i].statistic).epsilon(1e-12));
    CHECK(with_row(1e30)[i].p == Approx(with_row(0)[i].p).epsilon(1e-12));
  }
  orchard.groups.resize(2);
  CHECK(anova(orchard).size() == 1);  // one difference has one spread
}

TEST_CASE("two values in each group are enough for Welch's F", "[describe]") {
  const std::vector<OmnibusTest> tests = anova(samples_of({{1, 3}, {4, 8}, {7, 8}}));
  REQUIRE(tests.size() == 2);
  CHECK(tests[1].statistic == Approx(509.0 / 59));  // by hand, in fractions
  CHECK(tests[1].df_within == Approx(28.0 / 17));
}

TEST_CASE("without spread in a group Welch's F is not defined", "[describe]") {
  CHECK(anova(samples_of({{1, 2, 3}, {5, 5, 5}})).size() == 1);
}

TEST_CASE("ANOVA has the digits that NIST certifies, also where many equal leading ones cost some", "[describe]") {
  for (const auto& [name, digits] :
       {std::pair{"SiRstv", 1e-9}, {"AtmWtAg", 1e-9}, {"SmLs04", 1e-9}, {"SmLs07", 1e-4}}) {
    CAPTURE(name);
    const auto [groups, f] = of_nist(name);
    CHECK(anova(samples_of(groups)).front().statistic == Approx(f).epsilon(digits));
  }
  CHECK(anova(samples_of(of_nist("SiRstv").first)).front().p ==
        Approx(0.349447493402193).epsilon(1e-12));  // R 4.2.2, aov
}

TEST_CASE("what has no spread, no second group or no value has no test of all", "[describe]") {
  for (const auto& groups : {std::vector<std::vector<double>>{}, {{1, 2}}, {{1, 2}, {}}, {{3, 3}, {3, 3}}})
    CHECK(anova(samples_of(groups)).empty());
  CHECK(anova(samples_of({{1}, {2}})).empty());
  MetricSamples lost = samples_of({{1, 2}, {3, 5}});
  lost.groups[0].sample = ExcludedSample{.missing = 1, .values = values_in(lost.groups[0])};
  CHECK(anova(lost).empty());
}
