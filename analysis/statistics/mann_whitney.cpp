#include "analysis/statistics/mann_whitney.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>

#include "analysis/statistics/tails.hpp"

namespace ikbench::statistics {
namespace {

constexpr std::size_t exact_below = 50;

// The probabilities of U for n1 and n2 different values, by the sample that has the largest of all:
// (n1 + n2) P(n1, n2, u) = n1 P(n1 - 1, n2, u - n2) + n2 P(n1, n2 - 1, u).
std::vector<double> probabilities(std::size_t n1, std::size_t n2) {
  std::vector<std::vector<double>> by_first(n1 + 1);  // for n2 = 0 at first
  for (std::size_t a = 0; a <= n1; ++a) by_first[a].resize(a * n2 + 1);
  for (auto& distribution : by_first) distribution[0] = 1;
  for (std::size_t b = 1; b <= n2; ++b) {
    for (std::size_t a = 1; a <= n1; ++a) {
      const double in_first = static_cast<double>(a) / static_cast<double>(a + b);
      const std::vector<double>& before = by_first[a - 1];
      std::vector<double>& now = by_first[a];
      for (std::size_t u = 0; u < b; ++u) now[u] *= 1 - in_first;
      for (std::size_t u = b; u <= a * b; ++u) now[u] = in_first * before[u - b] + (1 - in_first) * now[u];
    }
  }
  return by_first[n1];
}

}  // namespace

double RankDistribution::two_sided(double statistic) const {
  if (probabilities.empty()) {
    return normal_two_sided(std::max(0.0, std::abs(statistic - mean) - 0.5) / standard_deviation);
  }
  const double nearer_zero = std::min(statistic, 2 * mean - statistic);
  double tail = 0;
  for (std::size_t i = 0; static_cast<double>(i) <= nearer_zero; ++i) tail += probabilities[i];
  return std::min(1.0, 2 * tail);
}

std::uint64_t RankDistribution::interval_rank(double level) const {
  if (probabilities.empty()) {
    const double rank = std::floor(mean - normal_critical(level) * standard_deviation + 0.5);
    return rank > 0 ? static_cast<std::uint64_t>(rank) : 0;
  }
  check_level(level);
  std::uint64_t rank = 0;
  for (double below = probabilities[0]; below <= (1 - level) / 2; below += probabilities[rank]) ++rank;
  return rank;
}

RankDistribution distribution_of_u(std::size_t n1, std::size_t n2, const Ranking& ranking) {
  const auto m = static_cast<double>(n1), n = static_cast<double>(n2);
  RankDistribution distribution{.mean = m * n / 2};
  if (ranking.ties.empty() && n1 < exact_below && n2 < exact_below) {
    distribution.probabilities = probabilities(n1, n2);
  } else {
    const double all = m + n;
    distribution.standard_deviation = std::sqrt(m * n / 12 * (all + 1 - ranking.tie_sum() / (all * (all - 1))));
  }
  return distribution;
}

Test mann_whitney(std::span<const double> first, std::span<const double> second) {
  Test test;
  if (first.empty() || second.empty()) {
    test.undefined = "a sample has no values";
    return test;
  }
  const Ranking ranking = midranks(first, second);
  test.undefined = ranking.all_equal() ? "all values are equal" : ranking.undefined;
  if (!ranking.undefined.empty()) return test;
  const auto n1 = static_cast<double>(first.size());
  double rank_sum = 0;
  for (std::size_t i = 0; i < first.size(); ++i) rank_sum += ranking.ranks[i];
  test.statistic = rank_sum - n1 * (n1 + 1) / 2;
  if (!test.undefined.empty()) return test;
  const RankDistribution distribution = distribution_of_u(first.size(), second.size(), ranking);
  test.p = distribution.two_sided(test.statistic);
  test.direction = sign_of(test.statistic - distribution.mean);
  return test;
}

namespace {

// For each value, the number of values of the other sample below it, equal ones half: its rank among all less its rank
// in its own.
std::vector<double> placements(std::span<const double> own, std::span<const double> among_all) {
  std::vector<double> result = midranks(own).ranks;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = among_all[i] - result[i];
  return result;
}

double chance_of_no_overlap(double n1, double n2) {
  return std::min(1.0, 2 * std::exp(std::lgamma(n1 + 1) + std::lgamma(n2 + 1) - std::lgamma(n1 + n2 + 1)));
}

}  // namespace

Test brunner_munzel(std::span<const double> first, std::span<const double> second) {
  Test test;
  if (first.size() < 2 || second.size() < 2) {
    test.undefined = "a sample has fewer than two values";
    return test;
  }
  const Ranking ranking = midranks(first, second);
  test.undefined = ranking.undefined;
  if (!test.undefined.empty()) return test;

  const auto n1 = static_cast<double>(first.size()), n2 = static_cast<double>(second.size());
  const std::span<const double> ranks(ranking.ranks);
  const GroupSummary one = summarise(placements(first, ranks.first(first.size())));
  const GroupSummary other = summarise(placements(second, ranks.last(second.size())));
  if (ranking.all_equal()) {
    test.undefined = "all values are equal";
    return test;
  }
  // The chance that a value of `first` is above one of `second`, equal ones half; and the two parts of its variance.
  const double above = one.mean / n2;
  const double v1 = one.std * one.std / (n1 * n2 * n2), v2 = other.std * other.std / (n2 * n1 * n1);
  if (v1 + v2 == 0) {
    test.statistic = std::copysign(std::numeric_limits<double>::infinity(), above - 0.5);
    test.p = chance_of_no_overlap(n1, n2);
    return test;
  }
  test.statistic = (above - 0.5) / std::sqrt(v1 + v2);
  test.df = (v1 + v2) * (v1 + v2) / (v1 * v1 / (n1 - 1) + v2 * v2 / (n2 - 1));
  test.p = 2 * t_upper_tail(std::abs(test.statistic), test.df);
  return test;
}

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
