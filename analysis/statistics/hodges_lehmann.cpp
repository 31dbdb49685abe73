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

  // The rank-th smallest, counted from 1. Two differences close in on it by three steps in turn: interpolation at the
  // rank; as far beyond as the nearer of the two now falls short; and half way between them, counted in doubles, which
  // alone would end too.
  double smallest(std::uint64_t rank) const {
    End low{.at = difference(first_.front(), second_.front()), .count = 0};
    End high{.at = difference(first_.back(), second_.back()), .count = static_cast<double>(size())};
    for (const double near : around(rank)) {
      if (near >= low.at && near < high.at) close_in(near, rank, low, high);
    }
    const auto wanted = static_cast<double>(rank);
    for (int step = 1; low.at < high.at; ++step) {
      close_in(step % 3 == 1   ? interpolated(low, high, wanted)
               : step % 3 == 2 ? interpolated(low, high, beyond(low, high, wanted))
                               : half_way(low, high),
               rank, low, high);
    }
    return low.at;
  }

  // The rank-th smallest if `before` is the one before it.
  double smallest_after(double before, std::uint64_t rank) const {
    const Split split = split_at(before);
    return split.within >= rank ? before : split.least_above;
  }

 private:
  // One of the two. `count`: for the higher, the number of differences not above it; for the lower, the number below
  // it.
  struct End {
    double at;
    double count;
  };

  void close_in(double bound, std::uint64_t rank, End& low, End& high) const {
    const Split split = split_at(bound);
    const auto count = static_cast<double>(split.within);
    if (split.within >= rank) {
      high = {.at = split.largest_within, .count = count};
    } else {
      low = {.at = split.least_above, .count = count};
    }
  }

  // Two differences that likely enclose the rank-th of large samples: differences of a few of their values.
  std::vector<double> around(std::uint64_t rank) const {
    constexpr std::size_t few = 2000;
    if (std::min(first_.size(), second_.size()) < 2 * few) return {};
    const auto thinned = [](const std::vector<double>& values) {
      std::vector<double> result;
      for (std::size_t i = 0; i < few; ++i) result.push_back(values[(2 * i + 1) * values.size() / (2 * few)]);
      return result;
    };
    const AllDifferences of_few(thinned(first_), thinned(second_));
    const auto all = static_cast<double>(of_few.size());
    const double there = static_cast<double>(rank) / static_cast<double>(size()) * all;
    constexpr double room = 2 * few;  // twice what each of the few stands for
    return {of_few.smallest(static_cast<std::uint64_t>(std::max(there - room, 1.0))),
            of_few.smallest(static_cast<std::uint64_t>(std::min(there + room, all)))};
  }

  // The doubles in order as integers, with only one gap: -0 is just below 0.
  static std::int64_t place_of(double value) {
    const auto bits = std::bit_cast<std::int64_t>(value);
    return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits - 1 : bits;
  }
  static double double_at(std::int64_t place) {
    return std::bit_cast<double>(place < 0 ? std::numeric_limits<std::int64_t>::min() - place - 1 : place);
  }

  // A double at or above the low end and below the high one.
  static double half_way(const End& low, const End& high) {
    const auto from = static_cast<std::uint64_t>(place_of(low.at)), to = static_cast<std::uint64_t>(place_of(high.at));
    const double middle = double_at(static_cast<std::int64_t>(from + (to - from) / 2));
    return middle < high.at ? middle : low.at;  // -0 is not below 0
  }

  // Likewise, by interpolation; half way if the ends are too far apart.
  static double interpolated(const End& low, const End& high, double rank) {
    const double found = low.at + (high.at - low.at) * ((rank - low.count) / (high.count - low.count));
    return found >= low.at && found < high.at ? found : half_way(low, high);
  }

  static double beyond(const End& low, const End& high, double rank) {
    const double from_low = rank - low.count, from_high = high.count - rank;
    return from_low < from_high ? rank + std::min(from_low, from_high / 2) : rank - std::min(from_high, from_low / 2);
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
