// A sum of many numbers of which few change.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ikbench::solvers {

// Sums non-negative numbers from the first to the last, always to the same bits, without adding all of them again when
// some change. A sum in [2^k, 2^(k + 1)) is a multiple of its last bit. While it stays there, a further number rounds
// to the same amount whatever the sum is, except for ties, which depend on that bit. So a block of numbers adds one
// amount to every even sum, and one to every odd sum.
class OrderedSum {
 public:
  // Starts a sum of `count` unknown numbers.
  void begin(Eigen::Index count) {
    blocks_.assign(static_cast<std::size_t>((count + size - 1) / size), Block());
    first_ = 0;
  }

  void changed(Eigen::Index i) {
    const auto b = static_cast<std::size_t>(i / size);
    blocks_[b].power = 0;
    first_ = std::min(first_, b);
  }

  double of(const Eigen::RowVectorXd& numbers) {
    double sum = blocks_[first_].before;
    for (std::size_t b = first_; b < blocks_.size(); ++b) {
      const auto begin = static_cast<Eigen::Index>(b) * size;
      const Part part = numbers.segment(begin, std::min(size, numbers.size() - begin));
      blocks_[b].before = sum;
      sum = b == first_ ? added(sum, part) : after(blocks_[b], part);  // a block that changed may change again soon
    }
    first_ = blocks_.size() - 1;
    return sum;
  }

 private:
  using Part = Eigen::Ref<const Eigen::RowVectorXd>;
  static constexpr Eigen::Index size = 256;
  struct Block {
    double before = 0;               // sum of all numbers before it
    double power = 0;                // 2^k of the sums for which to_even and to_odd hold; 0: none
    double to_even = 0, to_odd = 0;  // the block's amount
  };

  static double added(double sum, const Part& part) {
    for (const double number : part) sum += number;
    return sum;
  }

  static double after(Block& block, const Part& part) {
    const auto bits = std::bit_cast<std::uint64_t>(block.before);
    constexpr std::uint64_t exponent = 0x7FF0000000000000;
    const auto power = std::bit_cast<double>(bits & exponent);
    if (power == 0) return added(block.before, part);
    if (block.power != power) {
      const auto odd = std::bit_cast<double>((bits & exponent) + 1);
      block.power = power;
      block.to_even = added(power, part) - power;
      block.to_odd = added(odd, part) - odd;
    }
    const double sum = block.before + (bits % 2 == 0 ? block.to_even : block.to_odd);
    return sum < 2 * power ? sum : added(block.before, part);
  }

  std::vector<Block> blocks_;
  std::size_t first_ = 0;  // the first block that may have changed; the last if none has
};

}  // namespace ikbench::solvers
