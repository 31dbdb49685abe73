#include "numerics/random.hpp"

namespace ikbench::numerics {

namespace {

// splitmix64 (Steele, Lea and Flood 2014): a step of its generator is also a good mixing function.
std::uint64_t splitmix64(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

std::uint64_t mixed(std::uint64_t value) { return splitmix64(value); }

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

Random::Random(Key key) : kernels_(kernels()) {
  std::uint64_t seed = key.value();
  for (std::size_t lane = 0; lane < random_lanes; ++lane) {
    for (auto& word : state_.words) word[lane] = splitmix64(seed);
  }
}

Random Random::of_numpy(std::uint32_t seed, std::uint64_t skipped) {
  Random random{Key(seed)};
  random.numpy_ = std::make_unique<std::mt19937>(seed);
  random.numpy_->discard(2 * skipped);
  return random;
}

double Random::uniform() {
  if (numpy_) {
    const auto high = static_cast<std::uint32_t>((*numpy_)() >> 5), low = static_cast<std::uint32_t>((*numpy_)() >> 6);
    return (high * 0x1p26 + low) * 0x1p-53;
  }
  if (used_ == random_lanes) {
    kernels_.uniforms(state_, buffer_, random_lanes);
    used_ = 0;
  }
  return buffer_[used_++];
}

double Random::uniform(double from, double to) { return from + (to - from) * uniform(); }

int Random::index(int count) { return static_cast<int>(uniform() * count); }

}  // namespace ikbench::numerics
