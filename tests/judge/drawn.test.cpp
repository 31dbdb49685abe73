// Tables as users write them, drawn with what makes verdicts go wrong, and judged twice: by the program, and by counted
// permutations and formulas as their sources print them, which share no code with it.

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include "analysis/csv/user_csv.hpp"
#include "analysis/show/headline.hpp"
#include "analysis/show/phrases.hpp"
#include "analysis/show/text.hpp"
#include "tests/judge/studies.hpp"

namespace ikbench::second {

using Real = long double;
using Reals = std::vector<Real>;
using Names = std::vector<std::string>;
using Boundaries = std::pair<Real, Real>;

Real real(auto count) { return static_cast<Real>(count); }

// Values are in thousandths, by which sums and ties are exact.
struct Table {
  std::vector<Reals> groups;  // means of runs; in the order of blocks
  bool is_paired = false, is_share = false, is_larger = false, by_means = false, by_ranks = false;
  bool has_low = false, is_huge = false;  // a value of 0 or below; one beyond 1e60
  int runs = 1, lost = -1;                // lost: the group that lacks a value, of its first block
  std::string text = "solver,block,run,v\n";

  bool is_ratio() const { return by_ranks && !has_low; }
  std::string name(std::size_t group) const { return fmt::format("s{}", group + 1); }
  // The values of a group, in the blocks that it has in common with another.
  Reals common(std::size_t group, std::size_t other) const {
    const bool lacks_block = is_paired && runs == 1 && lost == static_cast<int>(other);
    return {groups[group].begin() + (lacks_block ? 1 : 0), groups[group].end()};
  }
  Real margin(Real a, Real b) const {  // of differences
    const auto has_negative = [](const Reals& values) { return std::ranges::min(values) < 0; };
    if (is_share) return 0.05L;
    return std::ranges::any_of(groups, has_negative) ? 0 : 0.05L * std::min(std::abs(a), std::abs(b));
  }
};

Table drawn_table(int number) {
  std::mt19937_64 engine(static_cast<std::uint64_t>(number));
  const auto below = [&](int n) { return static_cast<int>(engine() % static_cast<std::uint64_t>(n)); };
  const auto one_of = [&](std::vector<double> all) {
    return all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
  };
  const auto uniform = [&] { return (static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53; };
  const auto normal = [&] { return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform()); };
  enum {
    plain,
    ties,
    zeros,
    penalties,
    hard_block,
    shares,
    heavy,
    zero_and_penalty,
    narrow,
    constant,
    negative,
    decades
  };
  const int kind = number % 12, design = number / 12 % 4;
  const int k = below(3) > 0 ? 2 : below(3) > 0 ? 3 + below(2) : 5 + below(8);
  const bool is_large = k < 4 && (kind == narrow || below(kind == decades ? 2 : 6) == 0);
  Table table{
      .is_paired = design % 2 == 1, .is_larger = below(3) == 0, .by_means = below(4) == 0, .runs = 1 + design / 2};
  const int n = is_large ? (table.is_paired ? 30 + below(60) : 20 + below(26))
                         : (table.is_paired ? 5 : 3) + below(k > 4 ? 6 : 16);
  const double penalty = one_of({1e3, 1e6, 1e9, 1e30, 1e60, 1e300});
  const int hard = below(n), zero = below(n);
  table.lost = below(20) == 0 ? below(k) : -1;
  std::vector<double> of_block;
  while (std::ssize(of_block) < n) of_block.push_back(kind == decades ? std::pow(10, 3 * uniform()) : 1);
  table.is_share = true;
  for (int g = 0; g < k; ++g) {
    const double factor = one_of({1, 1, 1.02, 1.02, 1.3, 3}), failing = one_of({0, 0.05, 0.2});
    const double sigma = kind == heavy                       ? 2.5
                         : kind == narrow || kind == decades ? one_of({0.01, 0.03, 0.1})
                                                             : one_of({0.1, 0.5});
    Reals& means = table.groups.emplace_back();
    for (int i = 0, size = table.is_paired || below(2) == 0 ? n : std::max(2, n - below(4)); i < size; ++i) {
      Real sum = 0;
      int rows = 0;
      for (int run = 0; run < table.runs; ++run) {
        Real value = std::round(1000 * of_block[static_cast<std::size_t>(i)] * factor * std::exp(sigma * normal()));
        value = kind == ties ? 500 * std::max<Real>(1, std::round(value / 500)) : std::max<Real>(value, 1);
        if (kind == constant) value = table.is_paired ? 1000 * factor : 2000;
        if (kind == ties && i == 0 && !table.is_paired)
          value = 9000;  // of equal values nobody knows if they are copies
        if (kind == narrow && uniform() < failing / 8) value *= 100;
        if (kind == negative) value = std::round(1000 * normal() + 500 * factor);
        if (kind == shares) value = uniform() < factor / 3.2 ? 1000 : 0;
        if (kind == zeros && uniform() < 0.3) value = 0;
        if (kind == zero_and_penalty && i == zero && uniform() < 0.7) value = 0;
        if ((kind == zero_and_penalty || kind == penalties) && uniform() < failing) value = 1000 * penalty;
        if (kind == hard_block && i == hard) value = 1000 * penalty;
        if (kind == hard_block && i == zero && number % 5 < 2) value = 0;
        const bool is_missing = g == table.lost && i + run == 0;
        const std::string cell = is_missing ? "NA" : fmt::format("{}", static_cast<double>(value / 1000));
        table.text += fmt::format("s{},b{},r{},{}\n", g + 1, i, table.is_paired ? run : i, cell);
        if (is_missing) continue;
        sum += value;
        ++rows;
        table.has_low |= value <= 0;
        table.is_share &= value == 0 || value == 1000;
        table.is_huge |= value > 1e63L;
      }
      if (rows > 0) means.push_back(sum / rows);
    }
  }
  table.by_ranks = !table.is_share && !table.by_means;
  return table;
}

// The reference.

struct Found {
  Real p = 1, estimate = 0;
  int direction = 0;
  std::optional<Boundaries> interval = {};
};

int sign_of(Real value) { return (value > 0) - (value < 0); }
Real sum_of(const Reals& values) { return std::accumulate(values.begin(), values.end(), Real(0)); }
Real mean_of(const Reals& values) { return sum_of(values) / real(values.size()); }
Real median_of(Reals values) {
  std::ranges::sort(values);
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}
Real variance_of(const Reals& values) {
  const Real mean = mean_of(values);
  Real squares = 0;
  for (const Real value : values) squares += (value - mean) * (value - mean) / real(values.size() - 1);
  return squares <= 1e-30L * mean * mean ? 0 : squares;
}

// Twice the ranks. Logarithms in thousandths differ by far more, or are ties.
std::vector<std::size_t> twice_ranks(const Reals& values) {
  std::vector<std::size_t> ranks(values.size(), 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (const Real other : values) {
      const bool is_tie = std::abs(other - values[i]) <= 1e-14L * std::max(Real(1), std::abs(other));
      ranks[i] += is_tie ? 1 : other < values[i] ? 2 : 0;
    }
  }
  return ranks;
}

// How often each sum of so many of the ranks comes; chosen 0: of any number of them.
Reals ways_of(const std::vector<std::size_t>& ranks, std::size_t chosen) {
  const std::size_t most = std::accumulate(ranks.begin(), ranks.end(), std::size_t{1});
  std::vector<Reals> ways(chosen + 1, Reals(most));
  ways[0][0] = 1;
  for (const std::size_t rank : ranks)
    for (std::size_t c = chosen + 1; c-- > (chosen > 0 ? 1 : 0);)
      for (std::size_t s = most; s-- > rank;) ways[c][s] += ways[chosen > 0 ? c - 1 : c][s - rank];
  return ways.back();
}

// Twice the tail on the side of the mean.
Real tails(const Reals& ways, std::size_t statistic) {
  Real low = 0, high = 0, sum = 0;
  for (std::size_t s = 0; s < ways.size(); ++s) (s <= statistic ? low : high) += ways[s], sum += ways[s] * real(s);
  const Real tail = real(statistic) <= sum / (low + high) + 1e-9L ? low : high + ways[statistic];
  return std::min(Real(1), 2 * tail / (low + high));
}

// The median of these, and the interval from the r-th to the r-th last, of the largest r with P(sum < r) <= level / 2
// without ties.
Found of_sums(Reals sums, std::size_t n, std::size_t chosen, Real level) {
  std::vector<std::size_t> ranks(n);
  std::iota(ranks.begin(), ranks.end(), std::size_t{1});
  const Reals ways = ways_of(ranks, chosen);
  const std::size_t least = chosen * (chosen + 1) / 2;
  const Real most = level / 2 * sum_of(ways);
  std::size_t rank = 0;
  for (Real below = ways[least]; below <= most; below += ways[least + rank]) ++rank;
  std::ranges::sort(sums);
  Found found{.estimate = median_of(sums)};
  if (rank > 0) found.interval = {sums[rank - 1], sums[sums.size() - rank]};
  return found;
}

Found signed_ranks(const Reals& differences, Real level) {
  Reals sizes, sums;
  for (std::size_t i = 0; i < differences.size(); ++i) {
    if (differences[i] != 0) sizes.push_back(std::abs(differences[i]));
    for (std::size_t j = 0; j <= i; ++j) sums.push_back((differences[i] + differences[j]) / 2);
  }
  const std::vector<std::size_t> ranks = twice_ranks(sizes);
  std::size_t above = 0, below = 0, next = 0;
  for (const Real d : differences)
    if (d != 0) (d > 0 ? above : below) += ranks[next++];
  Found found = of_sums(sums, differences.size(), 0, level);
  found.p = tails(ways_of(ranks, 0), above), found.direction = sign_of(real(above) - real(below));
  return found;
}

Real t_tails(Real t, Real df) {
  const boost::math::students_t distribution(static_cast<double>(df));
  return 2 * boost::math::cdf(boost::math::complement(distribution, static_cast<double>(std::abs(t))));
}
Real welch_df(Real u, Real m, Real v, Real n) { return (u + v) * (u + v) / (u * u / (m - 1) + v * v / (n - 1)); }

// The share of the others that each value less the shift is above, equal ones half.
Reals placements(const Reals& own, const Reals& others, Real shift) {
  Reals all(own.size());
  for (std::size_t i = 0; i < own.size(); ++i)
    for (const Real y : others) all[i] += (1 + sign_of(own[i] - y - shift)) / (2 * real(others.size()));
  return all;
}
Real brunner_munzel_p(const Reals& a, const Reals& b, Real shift) {
  const Reals of_a = placements(a, b, shift), of_b = placements(b, a, -shift);
  const Real m = real(a.size()), n = real(b.size()), distance = std::abs(mean_of(of_a) - 0.5L);
  const Real u = variance_of(of_a) / m, v = variance_of(of_b) / n;
  if (u + v == 0) return distance < 1e-12L ? 1 : 0;
  return t_tails(distance / std::sqrt(u + v), welch_df(u, m, v, n));
}

Found unpaired_ranks(const Reals& a, const Reals& b, Real level) {
  Reals sums, all = a;
  all.insert(all.end(), b.begin(), b.end());
  for (const Real x : a)
    for (const Real y : b) sums.push_back(x - y);
  std::ranges::sort(sums);
  const std::vector<std::size_t> ranks = twice_ranks(all);
  const auto of_a = std::accumulate(ranks.begin(), ranks.begin() + std::ssize(a), std::size_t{0});
  Found found = of_sums(sums, all.size(), a.size(), level);
  found.p = std::max(tails(ways_of(ranks, a.size()), of_a), brunner_munzel_p(a, b, 0));
  found.direction = sign_of(real(of_a) - real(a.size() * (all.size() + 1)));
  // Out, from one difference to the next, as far as the other test keeps shifts.
  const auto reach = [&](Real end, auto from, auto to) {
    for (auto at = std::find(from, to, end); std::next(at) != to; ++at)
      if (*at != *std::next(at) && brunner_munzel_p(a, b, (*at + *std::next(at)) / 2) < level) return *at;
    return *std::prev(to);
  };
  if (const auto interval = found.interval)
    found.interval = {reach(interval->first, sums.rbegin(), sums.rend()),
                      reach(interval->second, sums.begin(), sums.end())};
  return found;
}

Real choose(std::size_t n, std::size_t k) {
  Real ways = 1;
  for (std::size_t i = 1; i <= std::min(k, n - k) && k <= n; ++i) ways *= real(n + 1 - i) / real(i);
  return k > n ? 0 : ways;
}

Found of_t(Real estimate, Real variance, Real df, Real smallest, Real level) {
  Found found{.p = estimate == 0 ? 1 : smallest, .estimate = estimate, .direction = sign_of(estimate)};
  if (variance == 0) return found;
  found.p = t_tails(estimate / std::sqrt(variance), df);
  const boost::math::students_t distribution(static_cast<double>(df));
  const Real t = boost::math::quantile(boost::math::complement(distribution, static_cast<double>(level / 2)));
  found.interval = {estimate - t * std::sqrt(variance), estimate + t * std::sqrt(variance)};
  return found;
}
Found welch_t(const Reals& a, const Reals& b, Real level) {
  const Real m = real(a.size()), n = real(b.size()), u = variance_of(a) / m, v = variance_of(b) / n;
  const Real smallest = 2 / choose(a.size() + b.size(), a.size());
  return of_t(mean_of(a) - mean_of(b), u + v, welch_df(u, m, v, n), smallest, level);
}
Found paired_t(const Reals& differences, Real level) {
  const Real n = real(differences.size());
  return of_t(mean_of(differences), variance_of(differences) / n, n - 1, std::pow(Real(2), 1 - n), level);
}

Boundaries wilson_ends(Real share, Real n, Real level) {
  const Real z = boost::math::quantile(boost::math::complement(boost::math::normal(), static_cast<double>(level / 2)));
  const Real root = z * std::sqrt(z * z + 4 * n * share * (1 - share)), middle = 2 * n * share + z * z;
  return {share == 0 ? 0 : (middle - root) / (2 * (n + z * z)), share == 1 ? 1 : (middle + root) / (2 * (n + z * z))};
}
Boundaries newcombe_ends(Real a, Real m, Real b, Real n, Real phi, Real level) {
  const auto [l1, u1] = wilson_ends(a, m, level);
  const auto [l2, u2] = wilson_ends(b, n, level);
  const auto root = [&](Real d, Real e) { return std::sqrt(std::max(Real(0), d * d - 2 * phi * d * e + e * e)); };
  return {a - b - root(a - l1, u2 - b), a - b + root(u1 - a, b - l2)};
}

Found solved_or_not(const Reals& a, const Reals& b, bool is_paired, Real level) {
  const auto x = static_cast<std::size_t>(sum_of(a)), both = x + static_cast<std::size_t>(sum_of(b));
  Found found{.p = 0, .estimate = mean_of(a) - mean_of(b), .direction = sign_of(mean_of(a) - mean_of(b))};
  Real phi = 0;
  if (is_paired) {
    std::size_t cells[2][2] = {};  // of the first, of the second
    for (std::size_t i = 0; i < a.size(); ++i) ++cells[a[i] == 1][b[i] == 1];
    const Real e = real(cells[1][1]), f = real(cells[1][0]), g = real(cells[0][1]), h = real(cells[0][0]);
    const std::size_t differing = cells[1][0] + cells[0][1];
    for (std::size_t i = 0; i <= std::min(cells[1][0], cells[0][1]); ++i) found.p += choose(differing, i);
    found.p = std::min(Real(1), 2 * found.p / std::pow(Real(2), real(differing)));
    const Real product = (e + f) * (g + h) * (e + g) * (f + h), excess = e * h - f * g;
    const Real corrected = excess > 0 ? std::max(Real(0), excess - real(a.size()) / 2) : excess;
    phi = product > 0 ? corrected / std::sqrt(product) : 0;
  } else {
    const auto ways = [&](std::size_t i) { return i > both ? 0 : choose(a.size(), i) * choose(b.size(), both - i); };
    for (std::size_t i = 0; i <= a.size(); ++i)
      if (ways(i) <= ways(x) * (1 + 1e-7L)) found.p += ways(i) / choose(a.size() + b.size(), both);
  }
  found.interval = newcombe_ends(mean_of(a), real(a.size()), mean_of(b), real(b.size()), phi, level);
  return found;
}

// What is right of a pair.
struct Right {
  Verdict verdict = Verdict::not_tested;
  bool is_small = false, few_decide = false;
  Real p = 1, none = 0, ahead = 0, behind = 0;
  std::optional<Real> estimate = {};
  std::optional<Boundaries> interval = {};
};
using Rights = std::map<std::pair<std::string, std::string>, Right>;  // of the first, by names

bool is_constant(const Reals& values) { return std::ranges::count(values, values[0]) == std::ssize(values); }
Real centre_of(const Table& table, const Reals& values) { return table.by_ranks ? median_of(values) : mean_of(values); }

// What closed tests add to the test of a pair: the largest scaled p of all sets of three and more that have both.
struct Closed {
  Real largest = 0, groups = 0;
};

Right right_of(const Table& table, const Reals& first, const Reals& second, Real tests,
               const std::optional<Closed>& closed) {
  const Real level = 0.05L / tests, m = real(first.size()), n = real(second.size());
  const auto scaled = [&](Real value) { return table.is_ratio() ? std::log(value / 1000) : value / 1000; };
  const auto shown = [&](Real value) { return table.is_ratio() ? std::exp(value) : value; };
  Reals a, b, differences;
  for (const Real value : first) a.push_back(scaled(value));
  for (const Real value : second) b.push_back(scaled(value));
  for (std::size_t i = 0; i < a.size() * b.size(); ++i)  // by block, or all
    if (!table.is_paired || i % (b.size() + 1) == 0) differences.push_back(a[i / b.size()] - b[i % b.size()]);
  const bool are_equal = std::ranges::count(differences, Real(0)) == std::ssize(differences);
  const Found t = table.is_paired ? paired_t(differences, level) : welch_t(a, b, level);
  Found found = table.is_share && table.runs == 1 ? solved_or_not(a, b, table.is_paired, level)
                : !table.by_ranks                 ? t
                : table.is_paired                 ? signed_ranks(differences, level)
                                                  : unpaired_ranks(a, b, level);
  if (!table.is_share && are_equal) found.interval.reset();
  if (table.is_share && is_constant(a) && are_equal && !found.interval)
    found.interval = newcombe_ends(a[0], m, b[0], n, 0, level);
  if (table.is_share && found.interval)
    found.interval = {std::max(Real(-1), found.interval->first), std::min(Real(1), found.interval->second)};
  const Real margin = table.is_ratio() ? std::log(1.05L) : table.margin(centre_of(table, a), centre_of(table, b));
  const auto is_inside = [&](const Boundaries& ends) {
    return ends.first >= -margin * (1 + 1e-9L) && ends.second <= margin * (1 + 1e-9L);
  };
  const auto held = [](const Found& result) {
    return result.interval.value_or(Boundaries(result.estimate, result.estimate));
  };
  const Real apart = centre_of(table, a) - centre_of(table, b);
  const Real adjusted = closed ? std::max(closed->largest, 1 - std::pow(1 - found.p, closed->groups / 2))
                               : std::min(Real(1), found.p * tests);
  const bool is_decided = adjusted < 0.05L, has_width = held(found).first < held(found).second;
  const bool could_fail =
      !has_width && (are_equal || !is_decided) && 1 - wilson_ends(1, std::min(m, n), level).first > 0.05L;
  const bool is_same = !closed && is_inside(held(found)) && is_inside({apart, apart}) && !could_fail &&
                       (!table.by_ranks || is_inside(held(t)));
  const auto share_of = [&](int sign) {
    return real(std::ranges::count(differences, sign, sign_of)) / real(differences.size());
  };
  const auto one_decides = [&](Reals values) {
    const Real middle = median_of(values);
    for (Real& value : values) value = std::abs(value - middle);
    const Real most = std::ranges::max(values) * (1 - 1e-9L);
    return most > sum_of(values) / 2 && most > 2 * std::abs(t.estimate);
  };
  const int good = table.is_larger ? 1 : -1;
  Right right{.p = adjusted, .none = shown(0), .ahead = share_of(good), .behind = share_of(-good)};
  const auto one_is_half = [](Reals values) {
    for (Real& value : values) value = std::abs(value);
    return std::ranges::max(values) > sum_of(values) / 2;
  };
  const bool are_means = !table.is_share && table.by_means;
  const bool is_margin_of_one = are_means && (one_is_half(a) || one_is_half(b));
  const bool rests_on_one = table.is_paired ? one_decides(differences) : one_decides(a) || one_decides(b);
  right.few_decide = is_decided ? are_means && rests_on_one : is_same && is_margin_of_one;
  right.estimate = shown(found.estimate);
  if (right.few_decide || (!is_decided && !is_same))
    right.verdict = Verdict::inconclusive;
  else if (!is_decided)
    right.verdict = Verdict::equivalent;
  else
    right.verdict = found.direction == good ? Verdict::better : Verdict::worse,
    right.is_small = is_same && !is_margin_of_one;
  if (right.few_decide || !found.interval || (right.verdict == Verdict::inconclusive && !has_width))
    found.interval.reset();
  const bool is_refuted = is_difference(right.verdict) && sign_of(found.estimate) != found.direction;
  if (is_refuted) right.estimate.reset(), found.interval.reset();
  if (!found.interval) return right;
  const Real low = shown(found.interval->first), high = shown(found.interval->second);
  right.interval = !is_decided           ? Boundaries(std::min(right.none, low), std::max(right.none, high))
                   : found.direction > 0 ? Boundaries(std::max(right.none, low), high)
                                         : Boundaries(low, std::min(right.none, high));
  return right;
}

// The smallest p of groups of these sizes.
Real smallest_of(const Table& table, std::size_t m, std::size_t n) {
  if (table.is_share ? table.runs > 1 : table.by_means) return std::min(m, n) < 3 ? 1 : 0;
  if (table.is_paired) return std::pow(Real(2), 1 - real(n));
  return (table.is_share && m != n ? 1 : 2) / choose(m + n, m);
}

// The p of Friedman's test of some groups, which have the same blocks, from the last one back.
Real friedman_tail(const Table& table, const std::vector<std::size_t>& set, std::size_t blocks) {
  const Real k = real(set.size()), n = real(blocks);
  Reals sums(set.size());
  Real squares = 0, mean = n * (k + 1) / 2;  // of all ranks from their mean
  for (std::size_t block = 1; block <= blocks; ++block) {
    Reals row;
    for (const std::size_t group : set) row.push_back(table.groups[group][table.groups[group].size() - block]);
    const std::vector<std::size_t> ranks = twice_ranks(row);
    for (std::size_t i = 0; i < set.size(); ++i) {
      sums[i] += real(ranks[i]) / 2;
      squares += (real(ranks[i]) - k - 1) * (real(ranks[i]) - k - 1) / 4;
    }
  }
  Real between = 0;
  for (const Real sum : sums) between += (sum - mean) * (sum - mean);
  if (squares == 0) return 1;
  return boost::math::gamma_q(static_cast<double>(k - 1) / 2, static_cast<double>((k - 1) * between / squares) / 2);
}

// The largest p of all sets that have both groups, each as (1 - p)^(groups / size) would have it.
Closed closed_of(const Table& table, std::size_t first, std::size_t second, std::size_t blocks) {
  const std::size_t k = table.groups.size();
  Closed closed{.groups = real(k)};
  for (std::size_t bits = 0; bits < (std::size_t{1} << k); ++bits) {
    std::vector<std::size_t> set;
    for (std::size_t group = 0; group < k; ++group)
      if ((bits >> group & 1U) != 0) set.push_back(group);
    if (set.size() < 3 || std::ranges::count(set, first) + std::ranges::count(set, second) < 2) continue;
    const Real power = set.size() + 1 < k ? real(k) / real(set.size()) : 1;
    closed.largest = std::max(closed.largest, 1 - std::pow(1 - friedman_tail(table, set, blocks), power));
  }
  return closed;
}

// Whether closed tests compare paired ranks where no pair could decide alone.
bool are_closed(const Table& table, std::size_t blocks) {
  const std::size_t k = table.groups.size();
  if (!table.is_paired || !table.by_ranks || k < 4 || k > 12) return false;
  return std::pow(Real(2), 1 - real(blocks)) < 1 - std::pow(0.95L, 2 / real(k));
}

// Pairs leave while the level that all share is too small for the least able of them.
Rights rights_of(const Table& table) {
  std::map<std::pair<std::size_t, std::size_t>, Real> family;
  Rights rights;
  for (std::size_t i = 0; i < table.groups.size(); ++i) {
    for (std::size_t j = i + 1; j < table.groups.size(); ++j) {
      rights[{table.name(i), table.name(j)}] = rights[{table.name(j), table.name(i)}] = {};
      family[{i, j}] = smallest_of(table, table.common(i, j).size(), table.common(j, i).size());
    }
  }
  const auto all = family;
  const auto p_of = [](const auto& member) { return member.second; };
  while (!family.empty()) {
    const Real worst = p_of(*std::ranges::max_element(family, {}, p_of));
    if (worst < 0.05L / real(family.size())) break;
    std::erase_if(family, [&](const auto& member) { return p_of(member) == worst; });
  }
  std::size_t blocks = table.groups[0].size();  // that all groups have
  for (const Reals& values : table.groups) blocks = std::min(blocks, values.size());
  const bool is_closed = family.empty() && are_closed(table, blocks);
  if (is_closed) family = all;
  for (const auto& [pair, p] : family) {
    const std::string one = table.name(pair.first), other = table.name(pair.second);
    const auto closed = is_closed ? std::optional(closed_of(table, pair.first, pair.second, blocks)) : std::nullopt;
    const Right right = right_of(table, table.common(pair.first, pair.second), table.common(pair.second, pair.first),
                                 real(family.size()), closed);
    rights[{one, other}] = rights[{other, one}] = right;
    rights[{other, one}].verdict = reversed(right.verdict);
  }
  return rights;
}

Names named_in(const std::string& text) {
  Names names;
  const std::regex name("s[0-9]+");
  for (std::sregex_iterator at(text.begin(), text.end(), name), end; at != end; ++at) names.push_back(at->str());
  return names;
}

// The first thing that a headline claims, or shows, and that is not so.
std::string untruth_in(const std::string& text, const Table& table, const show::ReportModel& answer,
                       const Rights& rights) {
  const JudgedMetric& judged = answer.primary();
  std::string untrue;
  const auto demand = [&](bool is_so, const std::string& what) {
    if (!is_so && untrue.empty()) untrue = what;
  };
  const auto number_of = [&](const std::string& name) {
    const Reals& values = table.groups[std::stoul(name.substr(1)) - 1];
    const Real unit = !table.is_share ? 1 : table.runs == 1 ? real(values.size()) : 100;
    return centre_of(table, values) / 1000 * unit;
  };
  const auto check_numbers = [&](const std::string& before, const std::string& whose) {
    const std::regex form(before + "((median |mean )?v )?(-?[0-9][0-9.]*(e[+-][0-9]+)?)");
    for (std::sregex_iterator at(text.begin(), text.end(), form), end; at != end; ++at) {
      const std::string name = whose.empty() ? at->str(1) : whose;
      if (whose.empty() || at->length(2) > 0)
        demand(std::abs(std::stod(at->str(4)) - number_of(name)) <= 0.0051L * std::abs(number_of(name)),
               "number of " + name);
    }
  };
  check_numbers("(s[0-9]+) [(]?", "");
  check_numbers("([:;]) ", answer.solvers()[0]);
  const auto all_pairs = [&](const Names& some, const Names& others, const std::string& what, auto is_so) {
    for (const std::string& one : some)
      for (const std::string& other : others)
        if (one != other) demand(is_so(one, other), what + " " + one + " " + other);
  };
  const auto of = [&](auto& one, auto& other) -> const Right& { return rights.at({one, other}); };
  const auto is_better = [&](auto& one, auto& other) { return of(one, other).verdict == Verdict::better; };
  const auto is_same = [&](auto& one, auto& other) { return of(one, other).verdict == Verdict::equivalent; };
  const auto is_open = [&](auto& one, auto& other) { return of(one, other).verdict == Verdict::inconclusive; };
  const auto is_ahead = [&](auto& one, auto& other) {  // by more than the margin, as is shown
    const Real by = (number_of(one) - number_of(other)) * (table.is_larger ? 1 : -1);
    return by > (table.is_share ? 5 : table.margin(number_of(one), number_of(other))) * (1 + 1e-9L);
  };
  const auto look_alike = [&](auto& one, auto& other) { return !is_ahead(one, other) && !is_ahead(other, one); };
  const auto demand_better = [&](const Names& some, const Names& others, bool is_little) {
    all_pairs(some, others, "better", is_better);
    if (std::ranges::count(judged.samples.warnings, WarningKind::ranks_disagree, &Warning::kind) == 0)
      all_pairs(some, others, "better beside numbers", [&](auto& one, auto& other) { return !is_ahead(other, one); });
    if (!is_little) return;
    all_pairs(some, others, "by less", [&](auto& one, auto& other) { return of(one, other).is_small; });
    all_pairs(some, others, "by less beside numbers", look_alike);
  };
  const std::set<std::string> losers = beaten_solvers(judged.comparisons);
  const Names others(losers.begin(), losers.end());
  Names best = answer.solvers();
  std::erase_if(best, [&](const std::string& name) { return losers.contains(name); });
  const std::string plain = std::regex_replace(text, std::regex("[(][^)]*[)]"), "");
  const std::regex clauses("([^;:.]|[.][0-9])+");
  for (std::sregex_iterator at(plain.begin(), plain.end(), clauses), end; at != end; ++at) {
    const std::string clause = at->str();
    std::smatch found;
    const auto says = [&](const char* form) { return std::regex_search(clause, found, std::regex(form)); };
    const auto names = [&](int part) { return named_in(found.str(static_cast<std::size_t>(part))); };
    if (says("but better than (.*) by less"))
      demand_better(best, names(1), true);
    else if (says("(.*) (is|are) better than ([^,]*)(, by less)?"))
      demand_better(names(1).empty() ? best : names(1), names(3), found.length(4) > 0);
    if (says("(.*) (is|are) worse than ([^,]*)(, by less)?")) demand_better(names(3), names(1), found.length(4) > 0);
    if (says("(is|are) best")) {
      demand_better(best, others, says("best, by less"));
      all_pairs(best, best, "best", [&](auto& one, auto& other) {
        return is_same(one, other) || of(one, other).ahead + of(one, other).behind == 0;
      });
    }
    if (says("(.*) are (best, )?the same within")) {
      all_pairs(names(1), names(1), "same", is_same);
      all_pairs(names(1), names(1), "same beside numbers", look_alike);
    }
    if (says("Not decided between (.*)")) all_pairs(names(1), names(1), "open", is_open);
  }
  return untrue;
}

// The same of the words of a pair, and of its numbers as they are printed.
std::string untruth_in(const Comparison& comparison, const JudgedMetric& judged, const Right& right) {
  const std::string words = show::comparison_text(comparison, judged);
  const std::optional<EffectEstimate>& its_amount = comparison.estimate;
  const std::set<double> ends = show::null_and_margin(comparison, judged);
  const std::string amount = its_amount && its_amount->interval
                                 ? fmt::format("{} ({})", show::number_text(its_amount->value),
                                               show::interval_text(*its_amount->interval, {ends.begin(), ends.end()}))
                                 : "";
  if (!words.starts_with(name_of(right.verdict))) return words;
  if (contains(words, "less than") != right.is_small) return words;
  if (contains(words, "equal") && right.ahead + right.behind > 0) return words;
  const std::regex form(R"((-?[0-9.e+]+)[^(]*\((above )?(-?[0-9.e+]+) to (below )?(-?[0-9.e+]+)\))");
  std::smatch numbers;
  if (!std::regex_match(amount, numbers, form)) return "";
  const double value = std::stod(numbers.str(1)), low = std::stod(numbers.str(3)), high = std::stod(numbers.str(5));
  const auto none = static_cast<double>(right.none);
  const bool is_out =
      low > none || high < none || (low == none && numbers.length(2) > 0) || (high == none && numbers.length(4) > 0);
  return low <= value && value <= high && is_out == is_difference(right.verdict) ? "" : amount;
}

// Whether the interval of A12 excludes 0.5 if and only if p decides, on the side of the verdict, and is mirrored if the
// pair is.
bool is_interval_of_a12(const judge::Comparison& comparison, const judge::Comparison& mirrored) {
  using namespace judge;
  const Interval of = *std::get<TestResult>(comparison.result).dominance->interval;
  const Interval back = *std::get<TestResult>(mirrored.result).dominance->interval;
  const bool is_mirrored = std::abs(of.low + back.high - 1) < 1e-12 && std::abs(of.high + back.low - 1) < 1e-12;
  const bool is_above = of.low > 0.5 || (of.low == 0.5 && of.excludes_low);
  const bool is_below = of.high < 0.5 || (of.high == 0.5 && of.excludes_high);
  const Verdict verdict = verdict_of(comparison);
  return is_mirrored && is_above == (verdict == Verdict::better) && is_below == (verdict == Verdict::worse);
}

}  // namespace ikbench::second

TEST_CASE("drawn tables are judged as a second reference judges them", "[drawn][property]") {
  using namespace ikbench;
  using namespace second;
  const char* const asked = std::getenv("IKBENCH_TABLES");
  const int wanted = asked ? std::atoi(asked) : 400;
  std::map<std::string, int> compared, said;
  std::vector<std::string> contradictions;
  int tables = 0;
  for (int number = 0; tables < wanted; ++number) {
    const Table table = drawn_table(number);
    const std::string run = table.runs > 1 ? "run" : table.is_paired ? "" : "row";
    const Names block(table.is_paired, "block"), better{table.is_larger ? "larger" : "smaller"};
    const csv::Request request{
        .values = {"v"}, .label = {"solver"}, .block = block, .run = run, .better = better, .missing = "drop"};
    const auto check = [&](const char* what, bool is_so, const std::string& more) {
      ++compared[what];
      if (!is_so) contradictions.push_back(fmt::format("table {}, {}: {}", number, what, more));
    };
    const auto read = [&] { return csv::read(table.text, "drawn.csv", request); };
    if (table.is_huge) check("refused", contains(complaint<std::invalid_argument>(read), "1e60"), "1e300");
    if (table.is_huge) continue;
    ++tables;
    MetricSamples samples = read().samples[0];
    const auto test = table.by_means ? AnalysisPlan::Test::means : AnalysisPlan::Test::ranks;
    const JudgedMetric judged = ikbench::judge::judge(samples, csv::with_margin({.test = test}, "", samples));
    const show::ReportModel answer = show::make_report_model({judged});
    const Rights rights = rights_of(table);
    const std::string text = show::headline(answer), untruth = untruth_in(text, table, answer, rights);
    check("sentence", untruth.empty(), untruth + ": " + text);
    for (const Comparison& comparison : answer.primary().comparisons) {
      const std::string untold =
          untruth_in(comparison, answer.primary(), rights.at({comparison.first, comparison.second}));
      check("words of a pair", untold.empty(), untold);
    }
    Real rounding = 0;  // of sums of two large differences
    for (const Reals& values : table.groups) rounding = std::max(rounding, std::ranges::max(values) * 1e-19L);
    const auto is_near = [&](double value, Real right) {
      return std::abs(value - right) <= 1e-7L * std::abs(right) + std::min(rounding, 1e-6L) + 1e-16L;
    };
    for (const Comparison& comparison : judged.comparisons) {
      const FlatComparison result = flat(comparison);
      const Right& right = rights.at({comparison.first, comparison.second});
      const auto check_pair = [&](const char* what, bool is_so) {
        const auto& [one, other] = std::pair(name_of(result.verdict), name_of(right.verdict));
        check(what, is_so, fmt::format("{} and {}: {}, right: {}", comparison.first, comparison.second, one, other));
      };
      ++said[std::string(name_of(right.verdict)) + (right.is_small ? " by little" : "")];
      const bool is_little = right.is_small || right.verdict == Verdict::equivalent;
      check_pair("verdict", result.verdict == right.verdict && result.is_within_margin == is_little);
      if (right.verdict == Verdict::not_tested || result.verdict == Verdict::not_tested) continue;
      const bool has_p = result.p.has_value(), has_end = result.interval.has_value(),
                 has_value = result.estimate.has_value();
      const Interval found = result.interval.value_or(Interval{});
      const auto [low, high] = right.interval.value_or(Boundaries(0, 0));
      check_pair("p", has_p != right.few_decide && (!has_p || is_near(*result.p / static_cast<double>(right.p), 1)));
      check_pair("estimate", has_value == right.estimate.has_value() &&
                                 is_near(result.estimate.value_or(0), right.estimate.value_or(0)));
      check_pair("interval",
                 has_end == right.interval.has_value() && is_near(found.low, low) && is_near(found.high, high));
      if (const auto* const tested = std::get_if<TestResult>(&comparison.result)) {
        check_pair("effect",
                   is_near(tested->dominance->better, right.ahead) && is_near(tested->dominance->worse, right.behind));
        if (tested->dominance->interval)
          check_pair("interval of A12", is_interval_of_a12(comparison, better_first(comparison, comparison.first)));
      }
    }
  }
  for (const auto& [what, count] : compared)
    if (asked) fmt::print("{}: {} compared\n", what, count);
  for (const auto& [verdict, count] : said) CHECK(count > 2);
  CHECK(said.size() == 7);
  if (asked) fmt::print("{} contradictions of {} tables\n", contradictions.size(), tables);
  contradictions.resize(std::min<std::size_t>(contradictions.size(), 20));
  CHECK(fmt::format("{}", fmt::join(contradictions, "\n")) == "");
}
