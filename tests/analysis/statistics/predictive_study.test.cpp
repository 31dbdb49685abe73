#include "analysis/statistics/predictive_study.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "analysis/statistics/descriptive.hpp"
#include "analysis/statistics/tails.hpp"
#include "tests/catch.hpp"

using namespace ikbench::statistics;

namespace {

constexpr Resampling few{.resamples = 200, .seed = 3, .level = 0.95};

std::vector<double> log_normal(std::mt19937_64& engine, double sigma, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    const double u = (static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53;
    values.push_back(std::exp(sigma * normal_quantile(u)));
  }
  return values;
}

std::array<double, predicted_statistics> statistics_of(const std::vector<double>& values) {
  const Description of = describe(values);
  return {of.mean, of.median, of.std, of.max, of.min};
}

}  // namespace

TEST_CASE("nineteen of twenty studies lie within the range that another of the same kind predicts", "[predictive]") {
  // Of 400 pairs of studies the share within has a standard error of 0.011.
  constexpr int pairs = 400;
  for (const double sigma : {0.1, 1.0}) {
    std::mt19937_64 engine(11);
    std::array<int, predicted_statistics> inside{};
    for (int pair = 0; pair < pairs; ++pair) {
      const PredictedRanges ranges = predicted_ranges(log_normal(engine, sigma, 20), 20, few);
      const auto next = statistics_of(log_normal(engine, sigma, 20));
      for (std::size_t s = 0; s < predicted_statistics; ++s) {
        inside[s] += ranges[s].low <= next[s] && next[s] <= ranges[s].high ? 1 : 0;
      }
    }
    for (std::size_t s = 0; s < predicted_statistics; ++s) {
      CAPTURE(sigma, s, inside[s]);
      CHECK(inside[s] >= 0.91 * pairs);
      CHECK(inside[s] <= 0.99 * pairs);
    }
  }
}

TEST_CASE("a constant predicts itself", "[predictive]") {
  const PredictedRanges ranges = predicted_ranges(std::vector<double>(20, 0.25), 20, few);
  for (const std::size_t s : {0u, 1u, 3u, 4u}) {
    CHECK(ranges[s].low == Approx(0.25));
    CHECK(ranges[s].high == Approx(0.25));
  }
  CHECK(ranges[2].high < 1e-12);
}

TEST_CASE("more values of ours narrow the range, and the unit only scales it", "[predictive]") {
  std::mt19937_64 engine(5);
  const std::vector<double> many = log_normal(engine, 0.5, 400);
  const PredictedRanges of_few = predicted_ranges(std::span(many).first(20), 20, few),
                        of_many = predicted_ranges(many, 20, few);
  CHECK(std::log(of_many[0].high / of_many[0].low) < std::log(of_few[0].high / of_few[0].low));
  std::vector<double> scaled;
  for (const double value : many) scaled.push_back(1000 * value);
  const PredictedRanges of_scaled = predicted_ranges(scaled, 20, few);
  for (std::size_t s = 0; s < predicted_statistics; ++s) {
    CHECK(of_scaled[s].low == Approx(1000 * of_many[s].low));
    CHECK(of_scaled[s].high == Approx(1000 * of_many[s].high));
  }
}

TEST_CASE("values without a logarithm, or fewer than five, predict nothing", "[predictive]") {
  for (const std::vector<double>& values :
       {std::vector<double>{1, 2, 3, 4}, std::vector<double>{1, 2, 3, 4, 0}, std::vector<double>{1, 2, 3, 4, -1},
        std::vector<double>{1, 2, 3, 4, std::numeric_limits<double>::infinity()}}) {
    for (const Estimate& range : predicted_ranges(values, 20, few)) {
      CHECK(std::isnan(range.low));
      CHECK(std::isnan(range.high));
    }
  }
}
