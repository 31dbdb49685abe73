#include "solvers/random.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace ikbench {

namespace {

// splitmix64 (Steele, Lea and Flood 2014): a step of its generator is also a good mixing function.
std::uint64_t splitmix64(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

std::uint64_t mixed(std::uint64_t value) { return splitmix64(value); }

double unit(std::uint64_t bits) { return std::bit_cast<double>((bits >> 12) | 0x3ff0000000000000u) - 1.0; }

}  // namespace

Key::Key(std::uint64_t seed) : value_(mixed(seed)) {}

Key Key::with(std::uint64_t part) const {
  Key key = *this;
  key.value_ = mixed(value_ ^ mixed(part));
  return key;
}

Key Key::with(std::string_view part) const {
  std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
  for (const char c : part) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return with(hash);
}

Random::Random(Key key) {
  std::uint64_t seed = key.value();
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    for (auto& word : state_) word[lane] = splitmix64(seed);
  }
}

Random::Block Random::next_block() {
  Block block;
  auto& [s0, s1, s2, s3] = state_;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    block[lane] = unit(std::rotl(s0[lane] + s3[lane], 23) + s0[lane]);
    const std::uint64_t t = s1[lane] << 17;
    s2[lane] ^= s0[lane];
    s3[lane] ^= s1[lane];
    s1[lane] ^= s2[lane];
    s0[lane] ^= s3[lane];
    s2[lane] ^= t;
    s3[lane] = std::rotl(s3[lane], 45);
  }
  return block;
}

double Random::uniform() {
  if (used_ == lanes) {
    buffer_ = next_block();
    used_ = 0;
  }
  return buffer_[used_++];
}

double Random::uniform(double from, double to) { return from + (to - from) * uniform(); }

int Random::index(int count) { return static_cast<int>(uniform() * count); }

// Fills take whole blocks and leave the buffer of single draws alone.
void Random::uniforms(Eigen::Ref<Eigen::VectorXd> out) {
  const auto size = static_cast<std::size_t>(out.size());
  for (std::size_t i = 0; i < size; i += lanes) {
    const Block block = next_block();
    std::copy_n(block.begin(), std::min(lanes, size - i), out.data() + i);
  }
}

void Random::uniforms(Candidates& out) { uniforms(Eigen::Map<Eigen::VectorXd>(out.data(), out.size())); }

void Random::normals(Candidates& out) {
  const auto size = static_cast<std::size_t>(out.size());
  std::array<double, 2 * lanes> pairs;
  for (std::size_t i = 0; i < size; i += pairs.size()) {
    const Block radii = next_block();
    const Block angles = next_block();
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const double radius = std::sqrt(-2 * std::log(1 - radii[lane]));  // Box and Muller 1958
      const double angle = 2 * std::numbers::pi * (angles[lane] - 0.5);
      pairs[lane] = radius * std::cos(angle);
      pairs[lanes + lane] = radius * std::sin(angle);
    }
    std::copy_n(pairs.begin(), std::min(pairs.size(), size - i), out.data() + i);
  }
}

}  // namespace ikbench
