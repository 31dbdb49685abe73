// Random whole numbers for many resamples, the same on every machine: the halves of std::mt19937_64, whose sequence the
// standard fixes, scaled to a range without a division (Lemire, ACM Trans. Modeling and Computer Simulation 29 (2019)
// 3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

namespace ikbench::statistics {

// The same settings and sample give the same numbers on every machine.
struct Resampling {
  int resamples = 10000;
  std::uint64_t seed = 1;
  double level = 0.95;
};

class Draws {
 public:
  explicit Draws(std::uint64_t seed) : engine_(seed) {}

  // 0 to count - 1, each equally likely; count is 1 to 2^32 - 1.
  std::size_t below(std::size_t count) {
    const auto bound = static_cast<std::uint32_t>(count);
    std::uint64_t product = half() * bound;
    if (static_cast<std::uint32_t>(product) < bound) {
      const std::uint32_t incomplete = (0u - bound) % bound;
      while (static_cast<std::uint32_t>(product) < incomplete) product = half() * bound;
    }
    return static_cast<std::size_t>(product >> 32);
  }

 private:
  std::uint64_t half() {
    has_rest_ = !has_rest_;
    if (!has_rest_) return number_ >> 32;
    number_ = engine_();
    return number_ & 0xffffffffu;
  }

  std::mt19937_64 engine_;
  std::uint64_t number_ = 0;
  bool has_rest_ = false;
};

}  // namespace ikbench::statistics
