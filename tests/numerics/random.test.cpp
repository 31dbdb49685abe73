// The random streams: the published generator, eight lanes of it, and the numbers made from it.
#include "numerics/random.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/normal.hpp>

#include "tests/solvers/objectives.hpp"

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

// `count` numbers from a fill.
std::vector<double> filled(std::uint64_t key, int count, void (*fill)(Random&, Eigen::VectorXd&)) {
  Random random{Key(key)};
  Eigen::VectorXd out(count);
  fill(random, out);
  return {out.begin(), out.end()};
}

const boost::math::normal standard_normal;

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

// Checks that pairs of uniform numbers are independent: correlation within 4 standard errors, and the
// counts of a 10 x 10 grid of equal shares within the chi-square that one in 10000 exceeds.
void check_independent(const std::vector<double>& a, const std::vector<double>& b) {
  REQUIRE(a.size() == b.size());
  const auto n = static_cast<double>(a.size());
  std::array<std::array<double, 10>, 10> counts{};
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += 12 * (a[i] - 0.5) * (b[i] - 0.5);
    ++counts[static_cast<std::size_t>(a[i] * 10)][static_cast<std::size_t>(b[i] * 10)];
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
  const auto before = Key(7);
  for (const Fill fill :
       {&numerics::Kernels::uniforms, &numerics::Kernels::normals, &numerics::Kernels::truncated_normals}) {
    for (const std::size_t size : sizes()) {
      const auto count = static_cast<ptrdiff_t>(size);
      std::vector<double> expected(size);
      RandomState expected_state = state_of(before);
      (numerics::kernels(InstructionSet::portable).*fill)(expected_state, expected.data(), count);
      for (const InstructionSet set : instruction_sets()) {
        CAPTURE(name_of(set), size);
        for (const Guarded::Page page : {Guarded::Page::after, Guarded::Page::before}) {
          Row out(std::vector<double>(size, -9), page);
          RandomState state = state_of(before);
          (numerics::kernels(set).*fill)(state, out.data(), count);
          REQUIRE(same_bits(out.data(), expected.data(), size));
          REQUIRE(out.kept_within());
          REQUIRE(std::memcmp(&state, &expected_state, sizeof state) == 0);
        }
      }
    }
  }
}

TEST_CASE("a fill takes whole blocks of eight, of normal numbers sixteen from two", "[random]") {
  for (int size = 0; size <= 40; ++size) {
    Random random{Key(3)};
    Eigen::VectorXd out(size);
    random.uniforms(out);
    random.truncated_normals(out);
    random.normals(out);
    const int blocks = 2 * ((size + 7) / 8) + 2 * ((size + 15) / 16);
    CHECK(random.uniform() == numbers(3, 8 * blocks + 1).back());
  }
}

TEST_CASE("normal numbers are Box and Muller's of the raw stream", "[random]") {
  std::array<Xoshiro, 8> lanes = lanes_of(Key(11));
  const std::vector<double> values = filled(11, 160'000, [](Random& from, auto& out) { from.normals(out); });
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
  const std::vector<double> values = filled(12, 10'000, [](Random&from, auto&out) { from.truncated_normals(out); }),
                            shares = numbers(12, 10'000);
  const double below = cdf(standard_normal, -1.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    REQUIRE(std::abs(values[i] - quantile(standard_normal, below + (1 - 2 * below) * shares[i])) < 1e-14);
  }
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
    check_independent(numbers(key, 20'000), numbers(key + 1, 20'000));
  }
}

TEST_CASE("an index is equally often each of its values and never outside", "[random]") {
  Random random{Key(1)};
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) ++counts.at(static_cast<std::size_t>(random.index(7)));
  for (const int count : counts) CHECK(std::abs(count - 10000) < 400);  // standard deviation 93
  CHECK(random.index(1) == 0);
}

TEST_CASE("the numbers of NumPy's np.random.seed and np.random.random_sample", "[random]") {
  Random zero = Random::of_numpy(0, 0), later = Random::of_numpy(0, 2), ten = Random::of_numpy(10, 0);
  for (const double number : {0.5488135039273248, 0.7151893663724195, 0.6027633760716439, 0.5448831829968969})
    CHECK(zero.uniform() == number);
  CHECK(later.uniform() == 0.6027633760716439);
  CHECK(ten.uniform() == 0.771320643266746);
}
