// Whole numbers at random for many resamples, the same on every machine: the halves of std::mt19937_64, whose sequence
// the standard fixes, made to a range without a division (Lemire, ACM Trans. Modeling and Computer Simulation 29 (2019)
// 3).
#pragma once

#include <cstdint>
#include <random>

namespace ikbench::statistics {

class Draws {
 public:
  explicit Draws(std::uint64_t seed) : engine_(seed) {}

  // 0 to bound - 1, each equally likely; bound is at least 1.
  std::uint32_t below(std::uint32_t bound) {
    std::uint64_t product = half() * bound;
    if (static_cast<std::uint32_t>(product) < bound) {
      const std::uint32_t incomplete = (0u - bound) % bound;
      while (static_cast<std::uint32_t>(product) < incomplete) product = half() * bound;
    }
    return static_cast<std::uint32_t>(product >> 32);
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
