#include "analysis/statistics/hodges_lehmann.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "analysis/statistics/mann_whitney.hpp"
#include "analysis/statistics/ranks.hpp"
#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {
namespace {

// Two equal infinite values differ by 0.
double difference(double a, double b) { return a == b ? 0.0 : a - b; }

// All differences of two sorted samples, as a matrix that is never made. Rounding is monotone, so each row and each
// column of it is sorted.
class AllDifferences {
 public:
  AllDifferences(std::span<const double> first, std::span<const double> second)
      : first_(first.begin(), first.end()), second_(second.begin(), second.end()) {
    std::ranges::sort(first_);
    std::ranges::sort(second_, std::greater{});  // the differences of a value ascend
  }

  std::uint64_t size() const { return std::uint64_t{first_.size()} * second_.size(); }

  // The rank-th smallest, counted from 1: two differences close in on it, half way between them in turn, counted in
  // doubles. So some 60 steps end everywhere.
  double smallest(std::uint64_t rank) const {
    double low = difference(first_.front(), second_.front()), high = difference(first_.back(), second_.back());
    while (low < high) {
      const Split split = split_at(half_way(low, high));
      (split.within >= rank ? high : low) = split.within >= rank ? split.largest_within : split.least_above;
    }
    return low;
  }

  // The rank-th smallest if `before` is the one before it.
  double smallest_after(double before, std::uint64_t rank) const {
    const Split split = split_at(before);
    return split.within >= rank ? before : split.least_above;
  }

 private:
  // The doubles in order as integers, with only one gap: -0 is just below 0.
  static std::int64_t place_of(double value) {
    const auto bits = std::bit_cast<std::int64_t>(value);
    return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits - 1 : bits;
  }
  static double double_at(std::int64_t place) {
    return std::bit_cast<double>(place < 0 ? std::numeric_limits<std::int64_t>::min() - place - 1 : place);
  }

  // A double at or above the low end and below the high one.
  static double half_way(double low, double high) {
    const auto from = static_cast<std::uint64_t>(place_of(low)), to = static_cast<std::uint64_t>(place_of(high));
    const double middle = double_at(static_cast<std::int64_t>(from + (to - from) / 2));
    return middle < high ? middle : low;  // -0 is not below 0
  }

  struct Split {
    std::uint64_t within = 0;  // number of differences not above the bound
    double largest_within = -std::numeric_limits<double>::infinity();
    double least_above = std::numeric_limits<double>::infinity();
  };

  // Walks along the border between differences above the bound and the others.
  Split split_at(double bound) const {
    Split split;
    std::size_t columns = second_.size();
    for (const double value : first_) {
      while (columns > 0 && difference(value, second_[columns - 1]) > bound) --columns;
      split.within += columns;
      if (columns > 0) split.largest_within = std::max(split.largest_within, difference(value, second_[columns - 1]));
      if (columns < second_.size())
        split.least_above = std::min(split.least_above, difference(value, second_[columns]));
    }
    return split;
  }

  std::vector<double> first_, second_;
};

}  // namespace

Estimate hodges_lehmann(std::span<const double> first, std::span<const double> second, double level) {
  check_level(level);
  if (first.empty() || second.empty()) return {};
  const Ranking ranking = midranks(first, second);
  if (!ranking.undefined.empty() || ranking.all_equal()) return {};
  const AllDifferences differences(first, second);
  const std::uint64_t n = differences.size();
  const double lower = differences.smallest((n + 1) / 2);
  const double upper = n % 2 == 1 ? lower : differences.smallest_after(lower, n / 2 + 1);
  Estimate shift{.value = lower == upper ? lower : lower / 2 + upper / 2};
  const std::uint64_t rank = distribution_of_u(first.size(), second.size(), ranking).interval_rank(level);
  if (rank < 1 || rank > n) return shift;
  shift.low = differences.smallest(rank);
  shift.high = differences.smallest(n + 1 - rank);
  return shift;
}

}  // namespace ikbench::statistics
