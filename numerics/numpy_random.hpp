// The uniform numbers of NumPy's legacy generator (numpy.random.seed and rand), for studies that repeat a program that
// drew from it: MT19937, whose sequence the standard fixes, with 53 bits of two draws.
#pragma once

#include <cstdint>
#include <random>

namespace ikbench::numerics {

class NumpyRandom {
 public:
  // As after numpy.random.seed(seed) and `skipped` uniform numbers.
  NumpyRandom(std::uint32_t seed, std::uint64_t skipped) : draws_(seed) { draws_.discard(2 * skipped); }

  // [0, 1)
  double uniform() {
    const auto high = static_cast<double>(draws_() >> 5), low = static_cast<double>(draws_() >> 6);
    return (high * 67108864 + low) / 9007199254740992;  // 2^26, 2^53
  }
  double uniform(double from, double to) { return from + (to - from) * uniform(); }

 private:
  std::mt19937 draws_;
};

}  // namespace ikbench::numerics
