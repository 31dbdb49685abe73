#include "analysis/statistics/bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

using Sample = std::vector<double>;
using Values = std::span<const double>;

namespace {

const Sample sample{1.2, 3.4, 0.7, 5.9, 2.2};

double mean_of(Values values) { return mean(values); }
double inverse_of_mean(Values values) { return 1 / mean(values); }

}  // namespace

TEST_CASE("ten thousand resamples of five values come close to all 3125", "[bootstrap]") {
  const BootstrapInterval interval = bootstrap(sample, mean_of);
  CHECK(interval.estimate == Approx(2.68));
  CHECK(interval.low == Approx(1.2).margin(0.08));  // R 4.2.2, quantile type 7 of all 3125 means
  CHECK(interval.high == Approx(4.42).margin(0.08));
  CHECK(interval.z0 == Approx(0.00441168007401).margin(0.04));             // qnorm(1568 / 3125)
  CHECK(interval.acceleration == Approx(0.0527792737555).epsilon(1e-10));  // sum d^3 / (6 (sum d^2)^1.5)
  CHECK(interval.bca_low == Approx(1.3).margin(0.08));  // all means at pnorm(z0 + (z0 + z) / (1 - a (z0 + z)))
  CHECK(interval.bca_high == Approx(4.66).margin(0.08));
  CHECK(interval.standard_error == Approx(0.8302653726300225).epsilon(0.03));  // sqrt(17.228 / 25 * 3125 / 3124)
}

TEST_CASE("the resamples are those of the halves of mt19937_64, on every machine", "[bootstrap]") {
  // Twenty resamples with seed 2024, by a script in another language: Nishimura and Matsumoto's generator,
  // pick = 5 x / 2^32 of its lower and then its upper 32 bits.
  const BootstrapInterval interval = bootstrap(sample, mean_of, {.resamples = 20, .seed = 2024});
  CHECK(interval.low == Approx(1.4665).epsilon(1e-12));
  CHECK(interval.high == Approx(4.271).epsilon(1e-12));
}

TEST_CASE("one seed has one answer, another seed another", "[bootstrap]") {
  const BootstrapInterval one = bootstrap(sample, mean_of, {.seed = 7});
  const BootstrapInterval again = bootstrap(sample, mean_of, {.seed = 7});
  const BootstrapInterval other = bootstrap(sample, mean_of, {.seed = 8});
  CHECK(one.standard_error == again.standard_error);
  CHECK(one.bca_low == again.bca_low);
  CHECK(one.standard_error != other.standard_error);
}

TEST_CASE("the unit of the values changes no acceleration, and scales the interval", "[bootstrap]") {
  const double unit = GENERATE(0x1p-1000, 0x1p-400, 0x1p400, 0x1p1000);  // powers of two: no digit is lost
  Sample scaled = sample;
  for (double& value : scaled) value *= unit;
  const BootstrapInterval one = bootstrap(sample, mean_of), other = bootstrap(scaled, mean_of);
  CHECK(other.undefined.empty());
  CHECK(other.bca_undefined.empty());
  CHECK(other.acceleration == one.acceleration);
  CHECK(other.standard_error == one.standard_error * unit);
  CHECK(other.bca_low == one.bca_low * unit);
  CHECK(other.bca_high == one.bca_high * unit);
}

TEST_CASE("the acceleration of a large sample is that of a thousand of its values", "[bootstrap]") {
  Sample large;  // exponential quantiles, in order
  for (int i = 0; i < 5000; ++i) large.push_back(-std::log(1 - (i + 0.5) / 5000));
  double cubes = 0;
  for (const double value : large) cubes += std::pow(value - mean(large), 3);
  const double exact = cubes / (6 * std::pow(sum_of_squares(large), 1.5));
  CHECK(bootstrap(large, mean_of, {.resamples = 2}).acceleration == Approx(exact).epsilon(0.05));
}

TEST_CASE("the intervals of a skewed mean end too low most often, those of BCa less so", "[bootstrap][coverage]") {
  // Exponential values of mean 1, 600 samples of 20 from one seed; at 0.95 a sound interval ends too low in 15 of them.
  std::mt19937_64 engine(3);
  int percentile_too_low = 0, bca_too_low = 0, bca_too_high = 0;
  for (int s = 0; s < 600; ++s) {
    Sample drawn;
    for (int i = 0; i < 20; ++i) drawn.push_back(-std::log((static_cast<double>(engine() >> 11) + 1) * 0x1p-53));
    const BootstrapInterval interval = bootstrap(drawn, mean_of, {.resamples = 400, .seed = engine()});
    percentile_too_low += interval.high < 1 ? 1 : 0;
    bca_too_low += interval.bca_high < 1 ? 1 : 0;
    bca_too_high += interval.bca_low > 1 ? 1 : 0;
  }
  CHECK(percentile_too_low < 72);  // it covers some 0.90 in all
  CHECK(bca_too_low < 0.9 * percentile_too_low);
  CHECK(bca_too_low + bca_too_high < 60);
  CHECK(bca_too_low + bca_too_high > 15);
}

TEST_CASE("a constant sample has percentiles at its value and no BCa interval", "[bootstrap]") {
  const BootstrapInterval interval = bootstrap(Sample{3, 3, 3}, mean_of, {.resamples = 50});
  CHECK(interval.low == 3);
  CHECK(interval.high == 3);
  CHECK(interval.standard_error == 0);
  CHECK(says(interval.bca_undefined, "same on every resample"));
  CHECK(std::isnan(interval.bca_low));
}

TEST_CASE("the largest value lies at the end of its resamples, so that it has no BCa interval", "[bootstrap]") {
  const Statistic largest = [](Values values) { return std::ranges::max(values); };
  const Statistic smallest = [](Values values) { return std::ranges::min(values); };
  CHECK(bootstrap(sample, largest).bca_undefined.empty());  // some resamples are below it
  CHECK(says(bootstrap(sample, smallest).bca_undefined, "one side"));
}

TEST_CASE("where there is no bootstrap it says why", "[bootstrap]") {
  CHECK(says(bootstrap({}, mean_of).undefined, "no values"));
  CHECK(says(bootstrap(Sample{1}, mean_of).undefined, "one value"));
  CHECK(says(bootstrap(Sample{1, NAN}, mean_of).undefined, "not finite"));
  CHECK(says(bootstrap(Sample{1, HUGE_VAL, 2}, mean_of).undefined, "not finite"));
  CHECK(says(bootstrap(Sample{0, 0, 1}, inverse_of_mean).undefined, "on some resamples"));
  CHECK(bootstrap(Sample{1e300, -1e300, 1}, mean_of).undefined.empty());
  CHECK(std::isnan(bootstrap(Sample{1}, mean_of).low));
  CHECK(!bootstrap(Sample{1}, mean_of).bca_undefined.empty());
  CHECK_THROWS_AS(bootstrap(sample, mean_of, {.resamples = 1}), std::invalid_argument);
  CHECK_THROWS_AS(bootstrap(sample, mean_of, {.level = 1}), std::invalid_argument);
}

namespace {

// One value of each replicate: a weighted sum by another, as an expected running time is.
std::vector<double> ratios(const Sample& above, const Sample& below, const std::vector<Sample>& replicates) {
  std::vector<double> result;
  for (const Sample& drawn : replicates) {
    double a = 0, b = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      a += drawn[i] * above[i];
      b += drawn[i] * below[i];
    }
    result.push_back(a / b);
  }
  return result;
}

double share_of(const std::vector<double>& values, double value) {
  return static_cast<double>(std::ranges::count(values, value)) / static_cast<double>(values.size());
}

}  // namespace

TEST_CASE("clusters are drawn as often as all 27 draws of three have them", "[bootstrap][clusters]") {
  constexpr int resamples = 20000;
  const std::vector<Sample> replicates = resampled_clusters(3, {.resamples = resamples});
  REQUIRE(replicates.size() == resamples);
  for (const Sample& drawn : replicates) REQUIRE(drawn[0] + drawn[1] + drawn[2] == 3);
  // Spent 1, 2, 6 and successes 1, 0, 1. Of the 27 draws: the first alone 1, the second alone 1 (no success), the third
  // alone 1; (2, 1, 0) 3 of ratio 4 / 2, (2, 0, 1) 3 of 8 / 3, (1, 2, 0) 3 of 5, (0, 2, 1) 3 of 10, (1, 0, 2) 3 of
  // 13 / 3, (0, 1, 2) 3 of 14 / 2, (1, 1, 1) 6 of 9 / 2.
  const std::vector<double> found = ratios({1, 2, 6}, {1, 0, 1}, replicates);
  const std::vector<std::pair<double, int>> expected{{1.0, 1}, {HUGE_VAL, 1}, {6.0, 1},      {2.0, 3}, {8.0 / 3, 3},
                                                     {5.0, 3}, {10.0, 3},     {13.0 / 3, 3}, {7.0, 3}, {4.5, 6}};
  for (const auto& [value, of_27] : expected) {
    const double share = of_27 / 27.0;
    CAPTURE(value);
    CHECK(std::abs(share_of(found, value) - share) < 4 * std::sqrt(share * (1 - share) / resamples));
  }
}

TEST_CASE("one seed draws the same clusters, another others", "[bootstrap][clusters]") {
  CHECK(resampled_clusters(20, {.resamples = 5}) == resampled_clusters(20, {.resamples = 5}));
  CHECK(resampled_clusters(20, {.resamples = 5}) != resampled_clusters(20, {.resamples = 5, .seed = 2}));
  CHECK_THROWS_AS(resampled_clusters(0, {}), std::invalid_argument);
  CHECK_THROWS_AS(resampled_clusters(3, {.resamples = 1}), std::invalid_argument);
}

TEST_CASE("percentiles of few clusters lie as far out as Student's t", "[bootstrap][clusters]") {
  Sample values;
  for (int i = 999; i >= 1; --i) values.push_back(i);
  // Ten clusters: t is 2.262157 and sqrt(10 / 9) of it 2.384521; the normal distribution leaves 0.00855 beyond, which
  // is 8.5 of 998 steps.
  CHECK(expanded_percentiles(values, 10, 0.95).low == 9);
  CHECK(expanded_percentiles(values, 10, 0.95).high == 991);
  // Very many: 0.025 of 998 is 24.95.
  CHECK(expanded_percentiles(values, 1000000, 0.95).low == 25);
  values.front() = HUGE_VAL;
  CHECK(expanded_percentiles(values, 2, 0.95).high == HUGE_VAL);
  CHECK(std::isnan(expanded_percentiles(values, 1, 0.95).low));
  CHECK(std::isnan(expanded_percentiles({}, 10, 0.95).low));
  values.front() = NAN;
  CHECK(std::isnan(expanded_percentiles(values, 10, 0.95).high));
}

TEST_CASE("values that are alike within clusters say as much as their clusters, not more", "[bootstrap][clusters]") {
  // Sixteen clusters of nine equal values: drawn as 144 values the interval is a third as wide.
  Sample sums, sizes(16, 9), values, ones(144, 1);
  for (int c = 0; c < 16; ++c) {
    sums.push_back(9 * c);
    values.insert(values.end(), 9, c);
  }
  const Resampling settings{.resamples = 2000};
  const double by_cluster = standard_deviation(ratios(sums, sizes, resampled_clusters(16, settings)));
  const double by_value = standard_deviation(ratios(values, ones, resampled_clusters(144, settings)));
  CHECK(by_cluster == Approx(std::sqrt(21.25 / 16)).epsilon(0.06));  // variance (16^2 - 1) / 12
  CHECK(by_value == Approx(by_cluster / 3).epsilon(0.1));
}

TEST_CASE("an interval of a share over runs covers as often as it says", "[bootstrap][clusters][coverage]") {
  // 400 studies of 20 runs of 10 points, half of the runs with a chance of 0.9 and half of 0.1 at every point.
  std::mt19937_64 engine(5);
  int covers = 0, naive_covers = 0;
  for (int s = 0; s < 400; ++s) {
    Sample reached(20), points(20, 10);
    double all = 0;
    for (double& run : reached) {
      const std::uint64_t chance = engine() % 2 == 0 ? 9 : 1;
      for (int point = 0; point < 10; ++point) run += engine() % 10 < chance ? 1 : 0;
      all += run;
    }
    const auto replicates = resampled_clusters(20, {.resamples = 200, .seed = engine()});
    const Interval interval = expanded_percentiles(ratios(reached, points, replicates), 20, 0.95);
    if (interval.low <= 0.5 && interval.high >= 0.5) ++covers;
    const double share = all / 200, naive = 1.96 * std::sqrt(share * (1 - share) / 200);
    if (std::abs(share - 0.5) <= naive) ++naive_covers;
  }
  CHECK(covers > 400 * 0.95 - 4 * std::sqrt(400 * 0.95 * 0.05));
  CHECK(naive_covers < 300);
}

TEST_CASE("intervals of a family hold together, and are wider the more there are in it", "[bootstrap][clusters]") {
  std::mt19937_64 engine(9);
  const auto normal = [&] {  // of mean 0 and variance 1, nearly: twelve uniform numbers
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += static_cast<double>(engine() >> 11) * 0x1p-53;
    return sum;
  };
  Family one{.estimates = {5}, .replicates = {{}}, .clusters = 10},
      many{.estimates = {}, .replicates = {}, .clusters = 10};
  for (int b = 0; b < 4000; ++b) one.replicates[0].push_back(5 + 2 * normal());
  for (int i = 0; i < 10; ++i) {
    many.estimates.push_back(0);
    auto& replicates = many.replicates.emplace_back();
    for (int b = 0; b < 4000; ++b) replicates.push_back(normal());
  }
  const Interval alone = simultaneous_intervals(one, 0.95)[0];
  CHECK(alone.high - 5 == Approx(2 * 2.384521).epsilon(0.06));  // as of ten clusters above
  CHECK(5 - alone.low == Approx(alone.high - 5));
  // The largest of ten: 2.80 for normal ones, (1 - 0.95^0.1) / 2 = 0.002558 in each tail; t with 9 degrees of freedom
  // has 3.675 there (mpmath), times sqrt(10 / 9).
  CHECK(simultaneous_intervals(many, 0.95)[3].high == Approx(3.874).epsilon(0.08));
}

TEST_CASE("what has no spread has no width, and what is not finite no interval", "[bootstrap][clusters]") {
  Family family{.estimates = {1, 2, NAN}, .replicates = {{1, 1, 1}, {2, HUGE_VAL, 2}, {1, 2, 3}}, .clusters = 10};
  const std::vector<Interval> intervals = simultaneous_intervals(family, 0.95);
  CHECK(intervals[0].low == 1);
  CHECK(intervals[0].high == 1);
  CHECK(std::isnan(intervals[1].low));
  CHECK(std::isnan(intervals[2].low));
  family.clusters = 1;
  CHECK(std::isnan(simultaneous_intervals(family, 0.95)[0].low));
  CHECK(simultaneous_intervals({}, 0.95).empty());
}
