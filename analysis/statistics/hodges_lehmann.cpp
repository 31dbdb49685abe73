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

// Two equal infinite values differ by nothing.
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

  // The rank-th smallest, counted from 1: the least double that so many are not above, by halving the doubles between
  // the smallest difference and the largest.
  double smallest(std::uint64_t rank) const {
    std::int64_t low = place_of(difference(first_.front(), second_.front()));
    std::int64_t high = place_of(difference(first_.back(), second_.back()));
    while (low < high) {
      const std::int64_t middle =
          low + static_cast<std::int64_t>((static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low)) / 2);
      if (up_to(double_at(middle)) >= rank) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return double_at(low) + 0.0;  // never -0
  }

 private:
  // The doubles in their order as integers without gaps but one: -0 is just below 0.
  static std::int64_t place_of(double value) {
    const auto bits = std::bit_cast<std::int64_t>(value);
    return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits - 1 : bits;
  }
  static double double_at(std::int64_t place) {
    return std::bit_cast<double>(place < 0 ? std::numeric_limits<std::int64_t>::min() - place - 1 : place);
  }

  // How many are not above: along the border between those that are and those that are not.
  std::uint64_t up_to(double bound) const {
    std::uint64_t count = 0;
    std::size_t columns = second_.size();
    for (const double value : first_) {
      while (columns > 0 && difference(value, second_[columns - 1]) > bound) --columns;
      count += columns;
    }
    return count;
  }

  std::vector<double> first_, second_;
};

}  // namespace

Shift hodges_lehmann(std::span<const double> first, std::span<const double> second, double level) {
  check_level(level);
  Shift shift;
  if (first.empty() || second.empty()) {
    shift.undefined = "a sample has no values";
    return shift;
  }
  std::vector<double> all(first.begin(), first.end());
  all.insert(all.end(), second.begin(), second.end());
  const Ranking ranking = midranks(all);
  shift.undefined = ranking.undefined;
  if (ranking.ties.size() == 1 && ranking.ties.front() == all.size()) shift.undefined = "all values are equal";
  if (!shift.undefined.empty()) return shift;

  const AllDifferences differences(first, second);
  const std::uint64_t n = differences.size();
  const double lower = differences.smallest((n + 1) / 2);
  const double upper = n % 2 == 1 ? lower : differences.smallest(n / 2 + 1);
  shift.estimate = lower == upper ? lower : lower / 2 + upper / 2;
  const std::uint64_t rank = distribution_of_u(first.size(), second.size(), ranking).interval_rank(level);
  if (rank < 1 || rank > n) return shift;
  shift.low = differences.smallest(rank);
  shift.high = differences.smallest(n + 1 - rank);
  return shift;
}

}  // namespace ikbench::statistics
