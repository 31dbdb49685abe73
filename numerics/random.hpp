// Random numbers, the same on every machine: xoshiro256++ (Blackman and Vigna 2019) in eight interleaved lanes, seeded
// by splitmix64 from a key. A stream is a pure function of its key. Distributions are our own, because those of std
// differ between libraries.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <random>
#include <string_view>

#include "numerics/kernels.hpp"

namespace ikbench::numerics {

// A key of a stream, mixed from parts: Key(seed).with("IK-BA").with(run).with(point).
class Key {
 public:
  explicit Key(std::uint64_t seed);
  Key with(std::uint64_t part) const;
  Key with(std::string_view part) const;
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_;
};

// A stream of random numbers.
class Random {
 public:
  explicit Random(Key key);
  // Makes a stream of NumPy's numbers after np.random.seed(seed), without the first `skipped`: MT19937, whose pairs
  // make 53 bits (Matsumoto and Nishimura 1998). This stream gives single numbers only and fills no vectors.
  static Random of_numpy(std::uint32_t seed, std::uint64_t skipped);

  double uniform();                        // [0, 1), 52 bits
  double uniform(double from, double to);  // [from, to)
  int index(int count);                    // 0 ... count - 1

  // These three fill a vector or Candidates, row by row: with numbers in [0, 1), with standard normal numbers (Box and
  // Muller 1958), and with standard normal numbers within [-1, 1]. They take whole blocks of eight, and do not touch
  // the block from which single numbers are drawn.
  template <class Numbers>
  void uniforms(Eigen::PlainObjectBase<Numbers>& out) {
    kernels_.uniforms(state_, out.data(), out.size());
  }
  template <class Numbers>
  void normals(Eigen::PlainObjectBase<Numbers>& out) {
    kernels_.normals(state_, out.data(), out.size());
  }
  template <class Numbers>
  void truncated_normals(Eigen::PlainObjectBase<Numbers>& out) {
    kernels_.truncated_normals(state_, out.data(), out.size());
  }

 private:
  const Kernels& kernels_;
  RandomState state_;
  double buffer_[random_lanes];
  int used_ = random_lanes;
  std::unique_ptr<std::mt19937> numpy_;
};

}  // namespace ikbench::numerics
