// The roulette wheel picks an entry with a chance in proportion to its share.
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

  // The entry that a number in [0, 1) picks; there must be one.
  std::size_t pick(double chance) const {
    const double wanted = chance * sums_.back();
    std::size_t first = 0;  // the first entry whose sum exceeds `wanted`; bisection without a branch to predict
    for (std::size_t left = sums_.size(); left > 1; left -= left / 2) {
      first += sums_[first + left / 2 - 1] <= wanted ? left / 2 : 0;
    }
    return first;
  }

 private:
  std::vector<double> sums_;
};

}  // namespace ikbench::solvers
