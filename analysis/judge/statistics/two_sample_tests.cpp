#include "analysis/judge/statistics/two_sample_tests.hpp"

#include <algorithm>
#include <bit>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>

namespace ikbench::judge {
namespace {

namespace bm = boost::math;

// Without this policy Boost computes in long double, and takes several times as long.
using Plain = bm::policies::policy<bm::policies::promote_double<false>>;
using StudentsT = bm::students_t_distribution<double, Plain>;

constexpr std::size_t exact_unpaired = 100, exact_paired = 1000;

double number(auto count) { return static_cast<double>(count); }
int sign_of(double value) { return (value > 0) - (value < 0); }

// A mean or a difference of means.
struct MeanEstimate {
  double value;
  double error;  // standard error
  double df;     // degrees of freedom of the error
};

// Returns Student's t test of an estimate. If the error is 0, p is the smallest that permutations give.
UnadjustedTest t_of(const MeanEstimate& estimate, double smallest_p, double alpha) {
  UnadjustedTest outcome{.estimate = estimate.value, .direction = sign_of(estimate.value)};
  if (estimate.error == 0) {
    outcome.p = estimate.value == 0 ? 1 : smallest_p;
    return outcome;
  }
  const StudentsT t(estimate.df);
  outcome.p = 2 * bm::cdf(bm::complement(t, std::abs(estimate.value) / estimate.error));
  const double half = bm::quantile(bm::complement(t, alpha / 2)) * estimate.error;
  outcome.interval = Interval{estimate.value - half, estimate.value + half};
  return outcome;
}

// Returns Satterthwaite's degrees of freedom of a sum of two estimated variances. A single value has no degrees of
// freedom.
double df_of(double u, double m, double v, double n) {
  return (u + v) * (u + v) / (u * u / std::max(1.0, m - 1) + v * v / std::max(1.0, n - 1));
}

// Returns the two-sided p of `k` of `n` trials, where each succeeds with a chance of one half.
double two_sided_binomial(double k, double n) {
  return n == 0 ? 1 : std::min(1.0, 2 * bm::cdf(bm::binomial(n, 0.5), std::min(k, n - k)));
}

std::vector<double> sorted(Values values) {
  std::vector<double> order(values.begin(), values.end());
  if (!std::ranges::is_sorted(order)) std::ranges::sort(order);
  return order;
}

// The ranks of values from 1, the smallest. Equal values share the mean of their ranks.
struct Ranks {
  std::vector<double> ranks;  // in the order of the values
  double tie_sum = 0;         // sum of t^3 - t over the ties
};

Ranks midranks(Values values) {
  const std::vector<IndexedValue> order = sorted_with_index(values);
  Ranks result{.ranks = std::vector<double>(values.size())};
  for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
    end = first + 1;  // not from `first`, since a NaN does not equal itself
    while (end < order.size() && order[end].first == order[first].first) ++end;
    for (std::size_t i = first; i < end; ++i) result.ranks[order[i].second] = number(first + 1 + end) / 2;
    const double ties = number(end - first);
    result.tie_sum += ties * ties * ties - ties;
  }
  return result;
}

// The null distribution of a sum of ranks.
struct RankSum {
  double mean = 0, variance = 0;
  std::vector<double> probabilities = {};  // exact, by the sum times `times`; empty: normal approximation
  double times = 1;                        // 2 where ties make halves

  // Returns twice the tail on the side of the sum.
  double two_sided(double sum) const {
    if (probabilities.empty()) {
      const double distance = std::max(0.0, std::abs(sum - mean) - 0.5);
      return variance > 0 ? std::erfc(distance / std::sqrt(2 * variance)) : 1;
    }
    const auto seen = probabilities.begin() + std::lround(times * sum);
    const bool is_low = sum <= mean;
    const double tail =
        std::accumulate(is_low ? probabilities.begin() : seen, is_low ? seen + 1 : probabilities.end(), 0.0);
    return std::min(1.0, 2 * tail);
  }

  // Returns the largest r with P(sum - least < r) <= alpha / 2. A confidence interval goes from the r-th smallest
  // candidate to the r-th largest.
  std::size_t critical(double least, double alpha) const {
    if (probabilities.empty()) {
      const double rank = std::floor(mean - least - critical_z(alpha) * std::sqrt(variance) + 0.5);
      return rank > 0 ? static_cast<std::size_t>(rank) : 0;
    }
    auto next = probabilities.begin() + std::lround(least);
    std::size_t rank = 0;
    for (double below = *next; below <= alpha / 2; below += *++next) ++rank;
    return rank;
  }
};

// Returns the null distribution of the sum of `chosen` ranks (Mann-Whitney), or of any subset if `chosen` is 0
// (Wilcoxon). All choices are equally likely.
RankSum sum_of(const Ranks& ranks, std::size_t chosen) {
  const double n = number(ranks.ranks.size()), m = number(chosen);
  RankSum sum{.mean = n * (n + 1) / 4, .variance = n * (n + 1) * (2 * n + 1) / 24 - ranks.tie_sum / 48};
  if (chosen > 0) sum = {m * (n + 1) / 2, m * (n - m) / 12 * (n + 1 - ranks.tie_sum / (n * (n - 1)))};
  if (ranks.ranks.size() > (chosen > 0 ? exact_unpaired : exact_paired)) return sum;
  sum.times = ranks.tie_sum > 0 ? 2 : 1;
  // Sums of any subset above the mean mirror those below, so only half of the sums are needed.
  const auto most = static_cast<std::size_t>(sum.times * (chosen > 0 ? n * n : sum.mean));
  std::vector<std::vector<double>> ways(chosen + 1);  // by the number chosen, and the sum
  ways[0] = {1};
  for (const double rank : sorted(ranks.ranks)) {
    const auto more = static_cast<std::size_t>(std::lround(sum.times * rank));
    if (more > most) continue;
    for (std::size_t k = std::max<std::size_t>(chosen, 1); k-- > 0;) {
      std::vector<double>&from = ways[k], &to = ways[chosen > 0 ? k + 1 : 0];
      const std::size_t reached = std::min(from.size(), most + 1 - more);
      if (reached == 0) continue;
      to.resize(std::max(to.size(), reached + more));
      for (std::size_t i = reached; i-- > 0;) to[i + more] += from[i];
    }
  }
  sum.probabilities = std::move(ways[chosen]);
  const double choices =
      chosen > 0 ? std::accumulate(sum.probabilities.begin(), sum.probabilities.end(), 0.0) : std::exp2(n);
  for (double& share : sum.probabilities) share /= choices;
  return sum;
}

// Returns the distribution for ranks without ties, which depends only on the sizes and is kept for later calls.
const RankSum& without_ties(std::size_t n, std::size_t chosen) {
  thread_local std::map<std::pair<std::size_t, std::size_t>, RankSum> known;
  if (known.size() > 100) known.clear();
  const auto [at, is_new] = known.try_emplace({n, chosen});
  Ranks ranks{.ranks = std::vector<double>(is_new ? n : 0)};
  std::iota(ranks.ranks.begin(), ranks.ranks.end(), 1.0);
  if (is_new) at->second = sum_of(ranks, chosen);
  return at->second;
}

double two_sided(const Ranks& ranks, std::size_t chosen, double sum) {
  if (ranks.tie_sum == 0) return without_ties(ranks.ranks.size(), chosen).two_sided(sum);
  return sum_of(ranks, chosen).two_sided(sum);
}

// Returns the summary of the placements of `own`: for each value less the shift, how many of `others` are below, where
// an equal value counts half. Both lists must be ascending. Differences are compared with the shift, because the shift
// would vanish in a huge value. Sums of halves are exact, so no placement has to be stored.
SummaryStatistics placements(Values own, Values others, double shift) {
  std::size_t below = 0, up_to = 0;
  double first = 0, sum = 0, squares = 0;  // first placement; sums over distances to the first
  for (const double& value : own) {
    while (below < others.size() && value - others[below] > shift) ++below;
    for (up_to = std::max(below, up_to); up_to < others.size() && value - others[up_to] >= shift;) ++up_to;
    const double count = number(below + up_to) / 2;
    if (&value == own.data()) first = count;
    sum += count - first;
    squares += (count - first) * (count - first);
  }
  const double n = number(own.size());
  const double sd = n > 1 ? std::sqrt(std::max(0.0, squares - sum * sum / n) / (n - 1)) : 0;
  return {.n = static_cast<int>(own.size()), .mean = first + sum / n, .sd = sd};
}

// Returns the lower end of Newcombe's interval of a share of m n pairs.
double newcombe_low(double share, double m, double n, double alpha) {
  const double z = critical_z(alpha), others = (m + n) / 2 - 1;
  const auto is_below = [&](double end) {
    const double pairs = 1 + others * ((1 - end) / (2 - end) + end / (1 + end));
    return share - end > z * std::sqrt(end * (1 - end) * pairs / (m * n));
  };
  double low = 0, high = share;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (is_below(middle) ? low : high) = middle;
  }
  return low;
}

// Maps the bits of doubles to whole numbers in the same order, and back. Bisection of the whole numbers ends at a
// double after at most 64 steps, whatever the sizes. Halving the values would stop beside the double, or would take a
// thousand steps down to a tiny one.
std::int64_t in_order(std::int64_t bits) {
  return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits - 1 : bits;
}
std::int64_t index_of(double value) { return in_order(std::bit_cast<std::int64_t>(value)); }
double value_at(std::int64_t place) { return std::bit_cast<double>(in_order(place)); }

// Returns the median of all sums x_i + y_j, with the interval from the rank-th smallest to the rank-th largest. If y is
// x, only sums with i <= j count. The sums are not stored: those up to a bound are counted, and the bound closes in
// from one sum to another.
UnadjustedTest of_sums(std::vector<double> x, std::vector<double> y, bool are_same, std::size_t rank) {
  for (std::vector<double>* const values : {&x, &y})
    if (!std::ranges::is_sorted(*values)) std::ranges::sort(*values);
  const std::size_t all = are_same ? x.size() * (x.size() + 1) / 2 : x.size() * y.size();
  const auto smallest = [&](std::size_t at) {  // from 1
    std::int64_t low = index_of(x.front() + y.front()), high = index_of(x.back() + y.back());
    while (low < high) {
      const std::int64_t middle = std::midpoint(low, high);
      const double bound = value_at(middle);
      double below = x.front() + y.front(), above = x.back() + y.back();  // the sums beside the bound
      std::size_t count = 0, left = y.size();
      for (const double value : x) {
        for (; left > 0 && value + y[left - 1] > bound; --left) above = std::min(above, value + y[left - 1]);
        if (left > 0) below = std::max(below, value + y[left - 1]);
        count += left;
      }
      const auto twice = [&](double value) { return value + value <= bound; };
      if (are_same) count = (count + static_cast<std::size_t>(std::ranges::count_if(x, twice))) / 2;
      if (count >= at)
        high = std::min(middle, index_of(below));
      else
        low = std::max(middle + 1, index_of(above));
    }
    return value_at(low) + 0.0;  // turns -0 into 0
  };
  UnadjustedTest outcome{.estimate = (smallest((all + 1) / 2) + smallest(all / 2 + 1)) / 2};
  if (rank >= 1 && rank <= all) outcome.interval = Interval{smallest(rank), smallest(all + 1 - rank)};
  return outcome;
}

}  // namespace

double critical_z(double alpha) { return bm::quantile(bm::complement(bm::normal(), alpha / 2)); }

SummaryStatistics summarise(Values values) {
  const double shift = values.front(), n = number(values.size());
  double sum = 0, shifted_mean = 0, largest = 0;
  for (const double value : values) {
    sum += value - shift;
    shifted_mean += (value - shift) / n;
    largest = std::max(largest, std::abs(value));
  }
  double squares = 0, rest = 0;  // rest: rounding of the mean (Chan, Golub, LeVeque 1983)
  for (const double value : values) {
    const double deviation = (value - shift) - shifted_mean;
    squares += deviation * deviation;
    rest += deviation;
  }
  const double sd = n > 1 ? std::sqrt((squares - rest * rest / n) / (n - 1)) : 0;
  const bool is_rounding = sd <= 4 * std::numeric_limits<double>::epsilon() * largest;
  return {.n = static_cast<int>(values.size()), .mean = shift + sum / n, .sd = is_rounding ? 0 : sd};
}

std::vector<IndexedValue> sorted_with_index(Values values) {
  std::vector<IndexedValue> order;
  order.reserve(values.size());
  for (const double value : values) order.emplace_back(value, order.size());
  // Two ascending groups, one after the other, need no sort: merging them is faster.
  const auto end = std::ranges::is_sorted_until(order, {}, &IndexedValue::first);
  if (std::ranges::is_sorted(end, order.end(), {}, &IndexedValue::first))
    std::ranges::inplace_merge(order, end, {}, &IndexedValue::first);
  else
    std::ranges::sort(order, {}, &IndexedValue::first);
  return order;
}

double min_p_unpaired(std::size_t m, std::size_t n) {
  if (m > n) std::swap(m, n);  // so that both orders of the sizes give the same bits
  double p = 2;
  for (std::size_t i = 1; i <= m; ++i) p *= number(i) / number(n + i);
  return std::min(1.0, p);
}

double min_p_paired(std::size_t n) { return std::min(1.0, std::exp2(1 - number(n))); }

std::optional<Interval> quantile_interval(Values sorted, double share, double alpha) {
  const double n = number(sorted.size());
  const bm::binomial below(n, share);  // number of values below the quantile; Boost rounds outwards
  const double low = bm::quantile(below, alpha / 2), high = bm::quantile(bm::complement(below, alpha / 2));
  if (high >= n || bm::cdf(below, low) > alpha / 2) return {};
  return Interval{sorted[static_cast<std::size_t>(low)], sorted[static_cast<std::size_t>(high)]};
}

double brunner_munzel(Values first, Values second, double shift) {
  const SummaryStatistics of_first = placements(first, second, shift), of_second = placements(second, first, -shift);
  const double m = of_first.n, n = of_second.n;
  const double u = of_first.sd * of_first.sd / m / (n * n), v = of_second.sd * of_second.sd / n / (m * m);
  const double distance = std::abs(of_first.mean / n - 0.5);
  if (u + v == 0) return distance == 0 ? 1 : 0;
  return 2 * bm::cdf(bm::complement(StudentsT(df_of(u, m, v, n)), distance / std::sqrt(u + v)));
}

double mann_whitney(Values first, Values second) {
  if (first.size() > second.size()) std::swap(first, second);
  std::vector<double> both(first.begin(), first.end());
  both.insert(both.end(), second.begin(), second.end());
  const Ranks all = midranks(both);
  const auto end = all.ranks.begin() + std::ssize(first);
  return two_sided(all, first.size(), std::accumulate(all.ranks.begin(), end, 0.0));
}

UnadjustedTest rank_test(Values first, Values second, double alpha) {
  const std::size_t few = std::min(first.size(), second.size());
  const RankSum& sum = without_ties(first.size() + second.size(), few);
  const std::vector<double> first_rising = sorted(first), second_rising = sorted(second);
  std::vector<double> negative;
  for (std::size_t i = second_rising.size(); i-- > 0;) negative.push_back(-second_rising[i]);
  const std::size_t rank = sum.critical(number(few) * number(few + 1) / 2, alpha);
  UnadjustedTest outcome = of_sums(first_rising, std::move(negative), false, rank);
  // Moves an end of Mann-Whitney's interval as far as Brunner-Munzel's test keeps the shift. The bisection ends at a
  // double, however large the largest difference is.
  const auto reached = [&](double from, double beyond) {
    std::int64_t kept = index_of(from), out = index_of(beyond);
    for (auto next = std::midpoint(kept, out); next != kept; next = std::midpoint(kept, out)) {
      if (brunner_munzel(first_rising, second_rising, value_at(next)) >= alpha)
        kept = next;
      else
        out = next;
    }
    // An end at 0 is only approached, so the bisection stops at a subnormal number beside 0.
    return std::abs(value_at(kept)) < std::numeric_limits<double>::min() ? 0 : value_at(kept);
  };
  if (const auto interval = outcome.interval)
    outcome.interval = Interval{reached(interval->low, first_rising.front() - second_rising.back()),
                                reached(interval->high, first_rising.back() - second_rising.front())};
  outcome.p = std::max(brunner_munzel(first_rising, second_rising), mann_whitney(first_rising, second_rising));
  outcome.direction = sign_of(placements(first_rising, second_rising, 0).mean - number(second.size()) / 2);
  return outcome;
}

Interval a12_interval(Values first, Values second, double alpha) {
  const std::vector<double> a = sorted(first), b = sorted(second);
  const double m = number(a.size()), n = number(b.size());
  const SummaryStatistics of_first = placements(a, b, 0), of_second = placements(b, a, 0);
  const double a12 = of_first.mean / n;
  Interval interval{newcombe_low(a12, m, n, alpha), 1 - newcombe_low(1 - a12, m, n, alpha)};
  const double u = of_first.sd * of_first.sd / (n * n * m), v = of_second.sd * of_second.sd / (m * m * n);
  if (!(u + v > 0)) return interval;  // separate samples, or values that are no numbers
  const double t = bm::quantile(bm::complement(StudentsT(df_of(u, m, v, n)), alpha / 2));
  const double odds = a12 / (1 - a12), reach = std::exp(t * std::sqrt(u + v) / (a12 * (1 - a12)));
  interval.low = std::min(interval.low, odds / (odds + reach));
  interval.high = std::max(interval.high, odds / (odds + 1 / reach));
  return interval;
}

UnadjustedTest welch(const SummaryStatistics& first, const SummaryStatistics& second, double alpha, double worth) {
  const double m = first.n, n = second.n;
  const double u = first.sd * first.sd / m, v = second.sd * second.sd / n;
  const double smallest = min_p_unpaired(static_cast<std::size_t>(first.n), static_cast<std::size_t>(second.n));
  return t_of({.value = first.mean - second.mean,
               .error = std::sqrt(u + v),
               .df = df_of(u, std::min(m, worth), v, std::min(n, worth))},
              smallest, alpha);
}

UnadjustedTest signed_rank_test(Values differences, double alpha) {
  std::vector<double> half(differences.begin(), differences.end()), sizes;
  for (double& difference : half) {
    if (difference != 0) sizes.push_back(std::abs(difference));
    difference /= 2;
  }
  UnadjustedTest outcome = of_sums(half, half, true, without_ties(half.size(), 0).critical(0, alpha));
  const Ranks ranks = midranks(sizes);
  const double total = std::accumulate(ranks.ranks.begin(), ranks.ranks.end(), 0.0);
  double above = 0;
  auto rank = ranks.ranks.begin();
  for (const double difference : differences) {
    if (difference == 0) continue;
    if (difference > 0) above += *rank;
    ++rank;
  }
  outcome.direction = sign_of(above - total / 2);
  outcome.p = two_sided(ranks, 0, std::min(above, total - above));
  return outcome;
}

UnadjustedTest t_test(Values differences, double alpha, double worth) {
  const SummaryStatistics summary = summarise(differences);
  const double n = summary.n;
  return t_of({.value = summary.mean, .error = summary.sd / std::sqrt(n), .df = std::max(1.0, std::min(n, worth) - 1)},
              min_p_paired(differences.size()), alpha);
}

UnadjustedTest sign_test(Values differences, double alpha) {
  const std::vector<double> order = sorted(differences);
  const std::size_t n = order.size();
  const double above = number(std::ranges::count_if(order, [](double each) { return each > 0; }));
  const double below = number(std::ranges::count_if(order, [](double each) { return each < 0; }));
  return {.estimate = order[(n - 1) / 2] / 2 + order[n / 2] / 2,
          .p = two_sided_binomial(above, above + below),
          .direction = sign_of(above - below),
          .interval = quantile_interval(order, 0.5, alpha)};
}

Interval wilson_interval(const Proportion& proportion, double alpha) {
  const double share = proportion.share;
  const double z = critical_z(alpha), zz = z * z / proportion.n;
  const double centre = (share + zz / 2) / (1 + zz);
  const double half = std::sqrt((share * (1 - share) + zz / 4) * zz) / (1 + zz);
  return {share == 0 ? 0 : centre - half, share == 1 ? 1 : centre + half};
}

Interval clopper_pearson_interval(const Proportion& proportion, double alpha) {
  const double successes = proportion.share * proportion.n, failures = proportion.n - successes;
  return {successes > 0 ? bm::ibeta_inv(successes, failures + 1, alpha / 2) : 0,
          failures > 0 ? bm::ibeta_inv(successes + 1, failures, 1 - alpha / 2) : 1};
}

Interval newcombe_interval(const Proportion& first, const Proportion& second, double alpha, double correlation) {
  const Interval of_first = wilson_interval(first, alpha);
  const Interval of_second = wilson_interval(second, alpha);
  const auto reach = [phi = correlation](double a, double b) {
    return std::sqrt(std::max(0.0, a * a - 2 * phi * a * b + b * b));
  };
  return {first.share - second.share - reach(first.share - of_first.low, of_second.high - second.share),
          first.share - second.share + reach(of_first.high - first.share, second.share - of_second.low)};
}

UnadjustedTest fisher(Values first, Values second, double alpha) {
  const double m = number(first.size()), n = number(second.size());
  const double seen = number(std::ranges::count(first, 1.0)), all = seen + number(std::ranges::count(second, 1.0));
  // The weights of all tables, by the successes of the first group, relative to the table that was seen. Each weight
  // follows from its neighbour, because Boost's hypergeometric distribution takes a minute for groups of 20 000.
  const auto odds_of_next = [&](double x) { return (m - x) * (all - x) / ((x + 1) * (n - all + x + 1)); };
  double total = 1, as_rare = 1;
  const auto add = [&](double weight) {
    total += weight;
    if (weight <= 1 + 1e-7) as_rare += weight;  // equal up to rounding, as in R
  };
  double weight = 1;
  for (double x = seen; x < std::min(m, all); ++x) add(weight *= odds_of_next(x));
  weight = 1;
  for (double x = seen; x > std::max(0.0, all - n); --x) add(weight /= odds_of_next(x - 1));
  const double share = seen / m, other = (all - seen) / n;
  return {.estimate = share - other,
          .p = std::min(1.0, as_rare / total),
          .direction = sign_of(share - other),
          .interval = newcombe_interval({.share = share, .n = m}, {.share = other, .n = n}, alpha)};
}

UnadjustedTest mcnemar(Values first, Values second, double alpha) {
  const double n = number(first.size());
  double a = 0, b = 0, c = 0;  // successes of both, of the first only, of the second only
  for (std::size_t i = 0; i < first.size(); ++i) {
    a += first[i] == 1 && second[i] == 1;
    b += first[i] == 1 && second[i] != 1;
    c += first[i] != 1 && second[i] == 1;
  }
  const double d = n - a - b - c, margins = (a + b) * (c + d) * (a + c) * (b + d), excess = a * d - b * c;
  const double corrected = excess > 0 ? std::max(0.0, excess - n / 2) : excess;
  const double phi = margins > 0 ? corrected / std::sqrt(margins) : 0;
  return {.estimate = (b - c) / n,
          .p = two_sided_binomial(b, b + c),
          .direction = sign_of(b - c),
          .interval = newcombe_interval({.share = (a + b) / n, .n = n}, {.share = (a + c) / n, .n = n}, alpha, phi)};
}

}  // namespace ikbench::judge
