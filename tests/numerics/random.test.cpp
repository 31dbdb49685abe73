// The random streams: the published generator, eight lanes of it, and the numbers made from it.
#include "numerics/random.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/uniform.hpp>

#include "numerics/instruction_set.hpp"
#include "tests/common.hpp"
#include "tests/solvers/objectives.hpp"

using namespace ikbench;
using namespace ikbench::numerics;
using namespace ikbench::robots;
using namespace ikbench::solvers;

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

enum class Kind { uniform, normal, truncated };

// `count` numbers from a fill.
std::vector<double> many(Kind kind, std::uint64_t key = 2023, int count = 100'000) {
  Random random{Key(key)};
  Eigen::VectorXd out(count);
  switch (kind) {
    case Kind::uniform:
      random.uniforms(out);
      break;
    case Kind::normal:
      random.normals(out);
      break;
    case Kind::truncated:
      random.truncated_normals(out);
      break;
  }
  return {out.begin(), out.end()};
}

const boost::math::normal standard_normal;
const boost::math::uniform unit_interval(0, 1);

double normal_share(double x) { return cdf(standard_normal, x); }
double uniform_share(double x) { return cdf(unit_interval, x); }
// The distribution function of the standard normal distribution cut off at -1 and 1.
double truncated_share(double x) {
  const double below = cdf(standard_normal, -1.0);
  return (cdf(standard_normal, x) - below) / (1 - 2 * below);
}

// The largest Kolmogorov-Smirnov statistic of n values in 99 of 100 cases.
double at_most(double n) { return 1.63 / std::sqrt(n); }

// The eight lanes of a key's stream.
std::array<Xoshiro, 8> lanes_of(Key key) {
  std::uint64_t seed = key.value();
  std::array<Xoshiro, 8> lanes{};
  for (Xoshiro& lane : lanes) {
    for (std::uint64_t& word : lane.s) word = splitmix(seed);
  }
  return lanes;
}

RandomState state_of(Key key) {
  RandomState state{};
  const std::array<Xoshiro, 8> lanes = lanes_of(key);
  for (std::size_t lane = 0; lane < 8; ++lane) {
    for (std::size_t word = 0; word < 4; ++word) state.words[word][lane] = lanes[lane].s[word];
  }
  return state;
}

// Checks that pairs are independent given their marginal distributions: correlation within 4 standard errors, and the
// counts of a 10 x 10 grid of equal shares within the chi-square that one in 10000 exceeds.
void check_independent(const std::vector<double>& a, const std::vector<double>& b,
                       const std::function<double(double)>& share) {
  REQUIRE(a.size() == b.size());
  const auto n = static_cast<double>(a.size());
  std::array<std::array<double, 10>, 10> counts{};
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double u = share(a[i]), v = share(b[i]);
    sum += 12 * (u - 0.5) * (v - 0.5);
    const auto cell = [](double x) { return std::min<std::size_t>(static_cast<std::size_t>(x * 10), 9); };
    ++counts[cell(u)][cell(v)];
  }
  CHECK(std::abs(sum / n) < 4 / std::sqrt(n));
  double chi_square = 0;
  for (const auto& row : counts) {
    for (const double count : row) chi_square += (count - n / 100) * (count - n / 100) / (n / 100);
  }
  CHECK(chi_square < quantile(complement(boost::math::chi_squared(99), 1e-4)));
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
  std::array<Xoshiro, 8> lanes = lanes_of(key);
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

TEST_CASE("every instruction set fills with the same bits, and no further than it is told", "[random]") {
  using Fill = void (*numerics::Kernels::*)(RandomState&, double*, ptrdiff_t);
  std::vector<std::size_t> sizes{1000};
  for (std::size_t size = 0; size <= 40; ++size) sizes.push_back(size);
  const auto before = Key(7);
  for (const Fill fill :
       {&numerics::Kernels::uniforms, &numerics::Kernels::normals, &numerics::Kernels::truncated_normals}) {
    for (const std::size_t size : sizes) {
      const auto count = static_cast<ptrdiff_t>(size);
      std::vector<double> expected(size);
      RandomState expected_state = state_of(before);
      (numerics::kernels(InstructionSet::portable).*fill)(expected_state, expected.data(), count);
      for (const InstructionSet set : instruction_sets()) {
        CAPTURE(name_of(set), size);
        constexpr double untouched = -9;
        std::vector<double> exact(size), out(size + 40, untouched);
        RandomState state = state_of(before), other = state;
        (numerics::kernels(set).*fill)(state, exact.data(), count);  // ends where its memory ends
        (numerics::kernels(set).*fill)(other, out.data() + 20, count);
        REQUIRE(std::equal(exact.begin(), exact.end(), expected.begin(),
                           [](double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }));
        REQUIRE(std::equal(exact.begin(), exact.end(), out.begin() + 20));
        REQUIRE(std::count(out.begin(), out.end(), untouched) == 40);
        REQUIRE(std::memcmp(&state, &expected_state, sizeof state) == 0);
        REQUIRE(std::memcmp(&other, &expected_state, sizeof other) == 0);
      }
    }
  }
}

TEST_CASE("a fill takes whole blocks of eight, of normal numbers sixteen from two", "[random]") {
  for (int size = 0; size <= 40; ++size) {
    for (const Kind kind : {Kind::uniform, Kind::normal, Kind::truncated}) {
      Random random{Key(3)};
      Eigen::VectorXd out(size);
      if (kind == Kind::uniform) random.uniforms(out);
      if (kind == Kind::normal) random.normals(out);
      if (kind == Kind::truncated) random.truncated_normals(out);
      const int block = kind == Kind::normal ? 16 : 8, blocks = (size + block - 1) / block * (block / 8);
      CHECK(random.uniform() == numbers(3, 8 * blocks + 1).back());
    }
  }
}

TEST_CASE("normal numbers are Box and Muller's of the raw stream", "[random]") {
  std::array<Xoshiro, 8> lanes = lanes_of(Key(11));
  const std::vector<double> values = many(Kind::normal, 11, 160'000);
  for (std::size_t pair = 0; pair < 10'000; ++pair) {
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const double u = static_cast<double>(lanes[lane]() >> 12) * 0x1p-52;
      const std::uint64_t drawn = lanes[lane]();
      const double v = static_cast<double>(drawn >> 12) * 0x1p-52;
      const double radius = std::sqrt(-2 * std::log(1 - u)), angle = v * std::numbers::pi / 2;
      const double left = (drawn & 1) != 0 ? -1 : 1, down = (drawn & 2) != 0 ? -1 : 1;
      REQUIRE(std::abs(values[16 * pair + lane] - left * radius * std::cos(angle)) < 1e-14);
      REQUIRE(std::abs(values[16 * pair + 8 + lane] - down * radius * std::sin(angle)) < 1e-14);
    }
  }
}

TEST_CASE("truncated normal numbers are the quantiles of the raw stream", "[random]") {
  const std::vector<double> values = many(Kind::truncated, 12, 10'000), shares = numbers(12, 10'000);
  const double below = cdf(standard_normal, -1.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    REQUIRE(std::abs(values[i] - quantile(standard_normal, below + (1 - 2 * below) * shares[i])) < 1e-14);
  }
}

TEST_CASE("numbers have the distribution of their kind", "[random]") {
  CHECK(kolmogorov_smirnov(many(Kind::uniform), uniform_share) < at_most(100'000));
  CHECK(kolmogorov_smirnov(many(Kind::normal), normal_share) < at_most(100'000));
  CHECK(kolmogorov_smirnov(many(Kind::truncated), truncated_share) < at_most(100'000));
}

TEST_CASE("the smallest and the largest draws give truncated normal numbers at -1 and below 1", "[random]") {
  // States whose next number is the sum of two words, of which the other is 0: 0 for all zeros; all ones for this.
  for (const std::uint64_t first : {std::uint64_t{0}, ~std::uint64_t{0}}) {
    RandomState state{};
    for (std::size_t lane = 0; lane < 8; ++lane) {
      // rotl(s0 + s3, 23) + s0 with s0 = 0 is rotl(s3, 23): all zeros or all ones.
      state.words[3][lane] = first;
      state.words[1][lane] = 1;
    }
    for (const InstructionSet set : instruction_sets()) {
      RandomState own = state;
      std::array<double, 8> out{};
      numerics::kernels(set).truncated_normals(own, out.data(), 8);
      for (const double x : out) {
        CHECK(std::abs(x) <= 1);
        CHECK(std::abs(x) > 1 - 1e-14);
        CHECK((x < 0) == (first == 0));
      }
    }
  }
}

TEST_CASE("streams of neighbouring keys are independent", "[random][independence]") {
  for (std::uint64_t key = 0; key < 20; ++key) {
    CAPTURE(key);
    check_independent(many(Kind::uniform, key, 20'000), many(Kind::uniform, key + 1, 20'000), uniform_share);
    check_independent(many(Kind::normal, key, 20'000), many(Kind::normal, key + 1, 20'000), normal_share);
    check_independent(many(Kind::truncated, key, 20'000), many(Kind::truncated, key + 1, 20'000), truncated_share);
  }
}

TEST_CASE("an index is equally often each of its values and never outside", "[random]") {
  Random random{Key(1)};
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) ++counts.at(static_cast<std::size_t>(random.index(7)));
  for (const int count : counts) CHECK(std::abs(count - 10000) < 400);  // standard deviation 93
  CHECK(random.index(1) == 0);
}
