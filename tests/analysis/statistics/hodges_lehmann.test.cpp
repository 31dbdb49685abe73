#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "analysis/statistics/mann_whitney.hpp"
#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

using Sample = std::vector<double>;

namespace {

// Makes and sorts every difference.
Estimate shift_of_all_differences(const Sample& first, const Sample& second, double level) {
  Sample all = first, differences;
  all.insert(all.end(), second.begin(), second.end());
  for (const double a : first) {
    for (const double b : second) differences.push_back(a == b ? 0.0 : a - b);
  }
  std::ranges::sort(differences);
  const std::size_t n = differences.size();
  const double lower = differences[(n - 1) / 2], upper = differences[n / 2];
  Estimate shift{.value = lower == upper ? lower : lower / 2 + upper / 2};
  const auto rank = distribution_of_u(first.size(), second.size(), midranks(all)).interval_rank(level);
  if (rank < 1) return shift;
  shift.low = differences[rank - 1];
  shift.high = differences[n - rank];
  return shift;
}

bool same_bits(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

}  // namespace

TEST_CASE("the permeability data have the shift of R", "[hodges_lehmann]") {
  // R's help page of wilcox.test (Hollander and Wolfe 1973, p. 69), with conf.int: -0.15 .. 0.76, estimate 0.305.
  const Sample term{0.80, 0.83, 1.89, 1.04, 1.45, 1.38, 1.91, 1.64, 0.73, 1.46}, week{1.15, 0.88, 0.90, 0.74, 1.21};
  const Estimate shift = hodges_lehmann(term, week, 0.95);
  CHECK(shift.value == Approx(0.305));
  CHECK(shift.low == Approx(-0.15));
  CHECK(shift.high == Approx(0.76));
}

TEST_CASE("the ozone of May and August is shifted by 32", "[hodges_lehmann]") {
  const Sample may{41, 36, 12, 18, 28, 23, 19, 8, 7, 16, 11, 14, 18, 14, 34, 6, 30, 11, 1, 11, 4, 32, 23, 45, 115, 37};
  const Sample august{39, 9,  16, 78, 35, 66, 122, 89,  110, 44, 28,  65, 22,
                      59, 23, 31, 44, 21, 9,  45,  168, 73,  76, 118, 84, 85};
  const Estimate shift = hodges_lehmann(may, august, 0.95);
  CHECK(shift.value == -32);  // the median of the 676 differences; the 231st from either end is the interval
  CHECK(shift.low == -53);
  CHECK(shift.high == -15);
}

TEST_CASE("the counted shift has the bits of the one from every difference", "[hodges_lehmann][property]") {
  // Ties, both signs, all magnitudes and infinite values; std::mt19937_64's sequence is fixed by the C++ standard.
  std::mt19937_64 engine(7);
  const Sample some{0, -0.0, 1, 1, -1, 0.1, 0.2, 0.3, 1e-300, -5e-324, 1e308, -1e308, HUGE_VAL, -HUGE_VAL, 3.25};
  for (int round = 0; round < 300; ++round) {
    Sample a(1 + engine() % 12), b(1 + engine() % 12);
    for (Sample* sample : {&a, &b}) {
      for (double& value : *sample) {
        value = round % 2 == 0 ? some[engine() % some.size()] : static_cast<double>(engine() % 1000) / 7 - 60;
      }
    }
    const double level = 0.5 + static_cast<double>(engine() % 50) / 101;
    const Estimate counted = hodges_lehmann(a, b, level);
    if (std::isnan(counted.value)) continue;
    const Estimate expected = shift_of_all_differences(a, b, level);
    CAPTURE(round, a, b, level);
    CHECK(same_bits(counted.value, expected.value));
    CHECK(same_bits(counted.low, expected.low));
    CHECK(same_bits(counted.high, expected.high));
  }
}

TEST_CASE("ten thousand million differences have a shift and its interval", "[hodges_lehmann]") {
  // Of 0 .. n - 1 and the same plus 1/4 there are n - |d| differences d - 1/4; up to d < 0 are (n + d)(n + d + 1) / 2.
  constexpr double n = 100'000;
  Sample a, b;
  for (int i = 0; i < n; ++i) {
    a.push_back(i);
    b.push_back(i + 0.25);
  }
  const Estimate shift = hodges_lehmann(a, b, 0.95);
  CHECK(shift.value == -0.25);
  const double rank = std::floor(n * n / 2 - 1.959963984540054 * std::sqrt(n * n * (2 * n + 1) / 12) + 0.5);
  double d = 1 - n;
  while ((n + d) * (n + d + 1) / 2 < rank) ++d;
  CHECK(shift.low == d - 0.25);
  CHECK(shift.high == -d - 0.25);
}

TEST_CASE("failed solves do not keep the others from a shift", "[hodges_lehmann]") {
  // Of 25 differences four are -inf; the 13th is the 9th of -13 -12 -12 -11 -11 -11 -10 ...
  const Estimate shift = hodges_lehmann(Sample{1, 2, 3, 4, HUGE_VAL}, Sample{11, 12, 13, 14, HUGE_VAL}, 0.95);
  CHECK(shift.value == -10);
}

TEST_CASE("too few values for the level have a shift and no interval", "[hodges_lehmann]") {
  const Estimate shift = hodges_lehmann(Sample{1, 2}, Sample{3, 4}, 0.95);
  CHECK(shift.value == -2);
  CHECK(std::isnan(shift.low));
  CHECK(hodges_lehmann(Sample{1, 2}, Sample{3, 4}, 0.6).low == -3);
}

TEST_CASE("values without ranks have no shift", "[hodges_lehmann]") {
  CHECK(std::isnan(hodges_lehmann({}, Sample{1}, 0.95).low));
  CHECK(std::isnan(hodges_lehmann(Sample{1, NAN}, Sample{1}, 0.95).low));
  CHECK(std::isnan(hodges_lehmann(Sample{3, 3}, Sample{3}, 0.95).low));
  CHECK(hodges_lehmann(Sample{1e308}, Sample{-1e308, 0}, 0.95).value == HUGE_VAL);  // 2e308 is none
  CHECK_THROWS_AS(hodges_lehmann(Sample{1}, Sample{2}, 95), std::invalid_argument);
}
