// The random streams: the published generator, eight lanes of it, and the numbers made from it.
#include "solvers/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/catch.hpp"
#include "tests/solvers/objectives.hpp"

using namespace ikbench;

namespace {

// xoshiro256++ 1.0 as Blackman and Vigna print it (2019), one lane.
struct Xoshiro {
  std::array<std::uint64_t, 4> s;

  static std::uint64_t rotl(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }
  std::uint64_t operator()() {
    const std::uint64_t result = rotl(s[0] + s[3], 23) + s[0];
    const std::uint64_t t = s[1] << 17;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= t;
    s[3] = rotl(s[3], 45);
    return result;
  }
};

// splitmix64 as Vigna prints it (2015).
std::uint64_t splitmix(std::uint64_t& x) {
  std::uint64_t z = (x += 0x9e3779b97f4a7c15);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

std::vector<double> numbers(std::uint64_t key, int count) {
  Random random{Key(key)};
  std::vector<double> numbers(static_cast<std::size_t>(count));
  for (double& number : numbers) number = random.uniform();
  return numbers;
}

// Kolmogorov-Smirnov statistic of sorted values against their distribution function.
template <class Distribution>
double kolmogorov_smirnov(std::vector<double> values, Distribution&& distribution) {
  std::sort(values.begin(), values.end());
  const auto n = static_cast<double>(values.size());
  double largest = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double F = distribution(values[i]);
    largest = std::max({largest, F - static_cast<double>(i) / n, static_cast<double>(i + 1) / n - F});
  }
  return largest;
}

std::vector<double> many(bool normal) {
  Random random{Key(2023)};
  Candidates out(100, 1000);
  normal ? random.normals(out) : random.uniforms(out);
  return {out.data(), out.data() + out.size()};
}

double moment(const std::vector<double>& values, int order, double centre) {
  double sum = 0;
  for (const double value : values) sum += std::pow(value - centre, order);
  return sum / static_cast<double>(values.size());
}

}  // namespace

TEST_CASE("the test's own generator gives the published first numbers of state 1, 2, 3, 4", "[random]") {
  // From the authors' xoshiro256plusplus.c; the same vector checks the ports in rand_xoshiro (Rust) and others.
  Xoshiro reference{{1, 2, 3, 4}};
  for (const std::uint64_t expected : {41943041u, 58720359u}) CHECK(reference() == expected);
  for (const std::uint64_t expected : {3588806011781223u, 3591011842654386u}) CHECK(reference() == expected);
  CHECK(reference() == 9228616714210784205u);
  std::uint64_t zero = 0;
  CHECK(splitmix(zero) == 0xe220a8397b1dcdafu);  // splitmix64's published first number of seed 0
}

TEST_CASE("a stream is eight generators taking turns, seeded one after the other by splitmix64", "[random]") {
  const Key key(42);
  std::uint64_t seed = key.value();
  std::array<Xoshiro, 8> lanes{};
  for (Xoshiro& lane : lanes) {
    for (std::uint64_t& word : lane.s) word = splitmix(seed);
  }
  Random random{key};
  for (int i = 0; i < 1000; ++i) {
    const std::uint64_t bits = lanes[static_cast<std::size_t>(i % 8)]();
    REQUIRE(random.uniform() == static_cast<double>(bits >> 12) * 0x1p-52);
  }
}

TEST_CASE("a fill gives the numbers that single draws give, and leaves single draws their block", "[random]") {
  const std::vector<double> expected = numbers(5, 40);
  Random random{Key(5)};
  CHECK(random.uniform() == expected[0]);  // opens the block 0 ... 7
  const Eigen::VectorXd fill = drawn_vector(random, 19);
  for (int i = 0; i < 19; ++i) CHECK(fill[i] == expected[static_cast<std::size_t>(8 + i)]);
  CHECK(random.uniform() == expected[1]);
  const Candidates rows = drawn_uniforms(random, 2, 4);  // the 19 took three blocks; row by row
  CHECK(rows(0, 0) == expected[32]);
  CHECK(rows(1, 0) == expected[36]);
}

TEST_CASE("a stream is a function of its key alone", "[random]") {
  CHECK(numbers(1, 100) == numbers(1, 100));
  const Key key = Key(1).with("IK-BA").with(3);
  CHECK(key.value() == Key(1).with("IK-BA").with(3).value());
}

TEST_CASE("keys that differ in any part are different", "[random]") {
  std::vector<std::uint64_t> keys;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    for (const char* label : {"", "a", "b", "ab", "ba"}) {
      for (std::uint64_t run = 0; run < 10; ++run) {
        for (std::uint64_t point = 0; point < 10; ++point)
          keys.push_back(Key(seed).with(label).with(run).with(point).value());
      }
    }
  }
  std::sort(keys.begin(), keys.end());
  CHECK(std::adjacent_find(keys.begin(), keys.end()) == keys.end());
}

TEST_CASE("streams of neighbouring keys are uncorrelated", "[random]") {
  const int n = 10000;
  for (std::uint64_t key = 0; key < 20; ++key) {
    const std::vector<double> a = numbers(key, n), b = numbers(key + 1, n);
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - 0.5) * (b[i] - 0.5);
    CHECK(std::abs(12 * sum / n) < 4 / std::sqrt(n));  // correlation within 4 standard errors
  }
}

TEST_CASE("uniform numbers have the moments and the distribution of the unit interval", "[random]") {
  const std::vector<double> values = many(false);
  CHECK(*std::min_element(values.begin(), values.end()) >= 0);
  CHECK(*std::max_element(values.begin(), values.end()) < 1);
  const double n = 100000;
  CHECK(std::abs(moment(values, 1, 0) - 0.5) < 4 * std::sqrt(1 / 12.0 / n));
  CHECK(std::abs(moment(values, 2, 0.5) - 1 / 12.0) < 4 * std::sqrt(1 / 180.0 / n));
  // 1.63 / sqrt(n): the 1 % point of Kolmogorov's distribution
  CHECK(kolmogorov_smirnov(values, [](double x) { return x; }) < 1.63 / std::sqrt(n));
}

TEST_CASE("normal numbers have the moments and the distribution of the standard normal", "[random]") {
  const std::vector<double> values = many(true);
  const double n = 100000;
  CHECK(std::abs(moment(values, 1, 0)) < 4 / std::sqrt(n));
  CHECK(std::abs(moment(values, 2, 0) - 1) < 4 * std::sqrt(2 / n));
  CHECK(std::abs(moment(values, 3, 0)) < 4 * std::sqrt(15 / n));
  CHECK(std::abs(moment(values, 4, 0) - 3) < 4 * std::sqrt(96 / n));
  CHECK(kolmogorov_smirnov(values, [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2)); }) < 1.63 / std::sqrt(n));
}

TEST_CASE("an index is equally often each of its values and never outside", "[random]") {
  Random random{Key(1)};
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) ++counts.at(static_cast<std::size_t>(random.index(7)));
  for (const int count : counts) CHECK(std::abs(count - 10000) < 400);  // standard deviation 93
  CHECK(random.index(1) == 0);
}

TEST_CASE("a uniform number between two is between them", "[random]") {
  Random random{Key(1)};
  for (int i = 0; i < 1000; ++i) {
    const double number = random.uniform(-3, -2);
    REQUIRE(number >= -3);
    REQUIRE(number < -2);
  }
}
