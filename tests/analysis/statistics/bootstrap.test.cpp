#include "analysis/statistics/bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"
#include "tests/error_rates/bca.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

using Sample = std::vector<double>;
TEST_CASE("the resamples are those of the halves of mt19937_64, on every machine", "[bootstrap]") {
  // Twenty resamples with seed 2024, by a script in another language: Nishimura and Matsumoto's generator,
  // pick = 5 x / 2^32 of its lower and then its upper 32 bits.
  const Sample sample{1.2, 3.4, 0.7, 5.9, 2.2};
  Draws draws(2024);
  Sample means;
  for (int i = 0; i < 20; ++i) {
    Sample picked(5);
    for (double& value : picked) value = sample[draws.below(5)];
    means.push_back(mean(picked));
  }
  std::ranges::sort(means);
  CHECK(quantile(means, 0.025, QuantileType::type_7) == Approx(1.4665).epsilon(1e-12));
  CHECK(quantile(means, 0.975, QuantileType::type_7) == Approx(4.271).epsilon(1e-12));
}

TEST_CASE("the BCa interval of five values is near that of all 3125 resamples", "[bootstrap]") {
  const Estimate interval = bca_of_mean(Sample{1.2, 3.4, 0.7, 5.9, 2.2});
  CHECK(interval.low == Approx(1.3).margin(0.08));    // all means, type 7, at pnorm(z0 + (z0 + z) / (1 - a (z0 + z))),
  CHECK(interval.high == Approx(4.66).margin(0.08));  // z0 = qnorm(1568 / 3125), a = 0.0527792737555
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
  CHECK(expanded_percentiles(0.5, values, 10, 0.95).low == 9);
  CHECK(expanded_percentiles(0.5, values, 10, 0.95).high == 991);
  // Very many: 0.025 of 998 is 24.95.
  CHECK(expanded_percentiles(0.5, values, 1000000, 0.95).low == 25);
  values.front() = HUGE_VAL;
  CHECK(expanded_percentiles(0.5, values, 2, 0.95).high == HUGE_VAL);
  CHECK(std::isnan(expanded_percentiles(0.5, values, 1, 0.95).low));
  CHECK(std::isnan(expanded_percentiles(0.5, {}, 10, 0.95).low));
  values.front() = NAN;
  CHECK(std::isnan(expanded_percentiles(0.5, values, 10, 0.95).high));
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
    const Estimate interval = expanded_percentiles(0.5, ratios(reached, points, replicates), 20, 0.95);
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
  std::vector<Sample> one(1), many;
  for (int b = 0; b < 4000; ++b) one[0].push_back(5 + 2 * normal());
  for (int i = 0; i < 10; ++i) {
    Sample& replicates = many.emplace_back();
    for (int b = 0; b < 4000; ++b) replicates.push_back(normal());
  }
  const Estimate alone = simultaneous_intervals(Sample{5}, one, 10, 0.95)[0];
  CHECK(alone.high - 5 == Approx(2 * 2.384521).epsilon(0.06));  // as of ten clusters above
  CHECK(5 - alone.low == Approx(alone.high - 5));
  // The largest of ten: 2.80 for normal ones, (1 - 0.95^0.1) / 2 = 0.002558 in each tail; t with 9 degrees of freedom
  // has 3.675 there (mpmath), times sqrt(10 / 9).
  CHECK(simultaneous_intervals(Sample(10), many, 10, 0.95)[3].high == Approx(3.874).epsilon(0.08));
}

TEST_CASE("what has no spread has no width, and what is not finite no interval", "[bootstrap][clusters]") {
  const Sample values{1, 2, NAN};
  const std::vector<Sample> replicates{{1, 1, 1}, {2, HUGE_VAL, 2}, {1, 2, 3}};
  const std::vector<Estimate> intervals = simultaneous_intervals(values, replicates, 10, 0.95);
  CHECK(intervals[0].low == 1);
  CHECK(intervals[0].high == 1);
  CHECK(std::isnan(intervals[1].low));
  CHECK(std::isnan(intervals[2].low));
  CHECK(std::isnan(simultaneous_intervals(values, replicates, 1, 0.95)[0].low));
  CHECK(simultaneous_intervals({}, {}, 10, 0.95).empty());
}
