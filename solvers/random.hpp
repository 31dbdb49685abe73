// Random numbers, the same wherever the C library has the same log, sin and cos: xoshiro256++ (Blackman and Vigna 2019)
// in eight interleaved lanes, seeded by splitmix64 from a key. A stream is a pure function of its key.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "robots/chain.hpp"

namespace ikbench {

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

class Random {
 public:
  explicit Random(Key key);

  double uniform();                                // [0, 1), 52 bits
  double uniform(double from, double to);          // [from, to)
  int index(int count);                            // 0 ... count - 1
  void uniforms(Eigen::Ref<Eigen::VectorXd> out);  // each in [0, 1)
  void uniforms(Candidates& out);                  // each in [0, 1)
  void normals(Candidates& out);                   // each standard normal (Box-Muller)

 private:
  static constexpr std::size_t lanes = 8;
  using Block = std::array<double, lanes>;
  Block next_block();  // one number in [0, 1) of each lane

  std::array<std::array<std::uint64_t, lanes>, 4> state_;
  Block buffer_{};
  std::size_t used_ = lanes;
};

}  // namespace ikbench
