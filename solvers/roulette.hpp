// A roulette wheel, which picks an entry with a chance in proportion to the entry's share.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace ikbench::solvers {

class Roulette {
 public:
  void reserve(std::size_t entries) { sums_.reserve(entries); }
  void clear() { sums_.clear(); }
  void add(double share) { sums_.push_back(sums_.empty() ? share : sums_.back() + share); }

  // Writes the entries that `count` numbers in [0, 1) pick. There must be at least one entry.
  template <class Index>
  void pick(std::ptrdiff_t count, const double* chances, Index* picked) const {
    // Finds the first entry whose sum exceeds a number's part of all: bisection without a branch to predict, a step for
    // all numbers before the next, since a number's steps wait for each other.
    std::fill_n(picked, count, Index{0});
    for (std::size_t left = sums_.size(); left > 1; left -= left / 2) {
      const double* const last = sums_.data() + left / 2 - 1;
      for (std::ptrdiff_t i = 0; i < count; ++i) {
        picked[i] += static_cast<Index>(left / 2) * Index{last[picked[i]] <= chances[i] * sums_.back()};
      }
    }
  }
  std::size_t pick(double chance) const {
    std::size_t picked = 0;
    pick(1, &chance, &picked);
    return picked;
  }

 private:
  std::vector<double> sums_;
};

}  // namespace ikbench::solvers
