#include <numbers>
#include <random>

#include "analysis/judge/statistics/pair_data.hpp"
#include "tests/judge/studies.hpp"

namespace {

using SomeValues = std::vector<double>;

// R's help pages: wilcox.test (Hollander and Wolfe 1973, p. 69; airquality, months 5 and 8), PlantGrowth, sleep.
const SomeValues term{0.80, 0.83, 1.89, 1.04, 1.45, 1.38, 1.91, 1.64, 0.73, 1.46}, week{1.15, 0.88, 0.90, 0.74, 1.21};
const SomeValues may{41, 36, 12, 18, 28, 23, 19, 8, 7,  16, 11, 14,  18,
                     14, 34, 6,  30, 11, 1,  11, 4, 32, 23, 45, 115, 37};
const SomeValues august{39, 9,  16, 78, 35, 66, 122, 89,  110, 44, 28,  65, 22,
                        59, 23, 31, 44, 21, 9,  45,  168, 73,  76, 118, 84, 85};
const SomeValues control{4.17, 5.58, 5.18, 6.11, 4.50, 4.61, 5.17, 4.53, 5.33, 5.14};
const SomeValues treated{6.31, 5.12, 5.54, 5.50, 5.37, 5.29, 4.92, 6.15, 5.80, 5.26};
const SomeValues drug_1{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
const SomeValues drug_2{1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};
// Darwin's maize, crossed less self-fertilized (Fisher, The Design of Experiments (1935), section 17).
const SomeValues maize{49, -67, 8, 16, 6, 23, 28, 41, 14, 29, 56, 24, 75, 60, -48};

SomeValues upto(int n, double from = 1, double step = 1) {
  SomeValues values;
  for (int i = 0; i < n; ++i) values.push_back(from + step * i);
  return values;
}

SomeValues of_ones(int ones, int all) {
  SomeValues values(static_cast<std::size_t>(all));
  std::fill_n(values.begin(), ones, 1.0);
  return values;
}

SomeValues minus(const SomeValues& a, const SomeValues& b) {
  SomeValues result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b[i]);
  return result;
}

void check_interval(const std::optional<Interval>& interval, double low, double high, double margin = 1e-9) {
  REQUIRE(interval);
  CHECK(interval->low == Approx(low).margin(margin));
  CHECK(interval->high == Approx(high).margin(margin));
}

double of_sorted(SomeValues first, SomeValues second) {
  std::ranges::sort(first);
  std::ranges::sort(second);
  return brunner_munzel(first, second);
}

}  // namespace

TEST_CASE("above a hundred values Mann and Whitney's p is normal, with ties and continuity", "[tests_of_two]") {
  // 1 to 60 and 11 to 70: 11 to 60 are there twice.
  const SomeValues a = upto(60), b = upto(60, 11);
  double u = 0;
  for (const double x : a)
    for (const double y : b) u += x > y ? 1 : x == y ? 0.5 : 0;
  const double variance = 3600.0 / 12 * (121 - 50 * 6 / (120.0 * 119));  // 2^3 - 2 for each of 50 ties
  const double z = (std::abs(u - 1800) - 0.5) / std::sqrt(variance);
  CHECK(mann_whitney(a, b) == Approx(std::erfc(z / std::sqrt(2.0))).epsilon(1e-12));
  // R's normal p of the ozone is 0.0001208; the exact one is near.
  CHECK(mann_whitney(may, august) == Approx(0.0001208).epsilon(0.5));
}

TEST_CASE("Brunner and Munzel's p is that of SciPy", "[tests_of_two]") {
  // SciPy 1.10.1, brunnermunzel: the pain scores of their paper, PlantGrowth, the ozone.
  const SomeValues first{1, 2, 1, 1, 1, 1, 1, 1, 1, 1, 2, 4, 1, 1}, second{3, 3, 4, 3, 1, 2, 3, 1, 1, 5, 4};
  CHECK(of_sorted(first, second) == Approx(0.005786208666151538).epsilon(1e-11));
  CHECK(of_sorted(control, treated) == Approx(0.044718863185473134).epsilon(1e-11));
  CHECK(of_sorted(august, may) == Approx(5.869131577851405e-06).epsilon(1e-10));
  // By hand: t = -1 / sqrt 2 on two degrees of freedom.
  CHECK(of_sorted(SomeValues{1, 3}, SomeValues{2, 4}) == Approx(1 - 1 / std::sqrt(5.0)).epsilon(1e-12));
}

TEST_CASE("Hodges and Lehmann's shift is that of R", "[tests_of_two]") {
  const UnadjustedTest permeability = rank_test(term, week, 0.05);  // R: -0.15 .. 0.76, 0.305
  CHECK(permeability.estimate == Approx(0.305));
  check_interval(permeability.interval, -0.15, 0.76);
  CHECK(rank_test(may, august, 0.05).estimate == -32);  // the median of 676 differences
}

TEST_CASE("Wilcoxon's p and interval of Darwin's maize", "[tests_of_two]") {
  // All 2^15 signs in whole numbers: 169 / 4096. Of 120 means the 60th and 61st are 24.5 and 25.5, the 26th from either
  // end 4 and 41.5.
  const UnadjustedTest test = signed_rank_test(maize, 0.05);
  CHECK(test.p == Approx(169.0 / 4096).epsilon(1e-13));
  CHECK(test.estimate == 25);
  CHECK(test.direction == 1);
  check_interval(test.interval, 4, 41.5);
}

TEST_CASE("one recursion reaches a thousand blocks", "[tests_of_two]") {
  CHECK(signed_rank_test(upto(1000), 0.05).p == std::ldexp(1.0, -999));
  // All but the smallest agree: of rank sums 0 and 1 one arrangement each.
  SomeValues differences = upto(60);
  differences[0] = -1;
  CHECK(signed_rank_test(differences, 0.05).p == 2 * 2 / std::ldexp(1.0, 60));
  SomeValues half = upto(1001);  // above, the normal approximation
  for (int i = 0; i < 1001; i += 2) half[static_cast<std::size_t>(i)] *= -1;
  const double mean = 1001 * 1002 / 4.0, variance = mean * 2003 / 6, sum = 500 * 501;
  const double z = (mean - sum - 0.5) / std::sqrt(variance);
  CHECK(signed_rank_test(half, 0.05).p == Approx(std::erfc(z / std::sqrt(2.0))).epsilon(1e-12));
}

TEST_CASE("a spread of the last bit alone is none") {
  CHECK(summarise(std::vector{0.3, 0.1 + 0.2}).sd == 0);
  CHECK(summarise(std::vector{0.3, 0.3 + 1e-14}).sd > 0);
}

TEST_CASE("Welch's and the paired t are those of R", "[tests_of_two]") {
  // R's help page of t.test, sleep: p 0.07939, -3.3654832 to 0.2054832; paired 0.002833, -2.4598858 to -0.7001142.
  const UnadjustedTest unpaired = welch(summarise(drug_1), summarise(drug_2), 0.05);
  CHECK(unpaired.estimate == Approx(-1.58));
  CHECK(unpaired.p == Approx(0.07939414).epsilon(1e-6));
  check_interval(unpaired.interval, -3.3654832, 0.2054832, 1e-7);
  const UnadjustedTest paired = t_test(minus(drug_1, drug_2), 0.05);
  CHECK(paired.p == Approx(0.002832890).epsilon(1e-6));
  CHECK(paired.direction == -1);
  check_interval(paired.interval, -2.4598858, -0.7001142, 1e-7);
  // A constant group against one with spread: t = 1 on 3 degrees of freedom.
  CHECK(welch({4, 2, 2}, {20, 1, 0}, 0.05).p == Approx(0.391002).epsilon(1e-5));
}

TEST_CASE("without spread means have the p of the permutations", "[tests_of_two]") {
  CHECK(welch({5, 1, 0}, {5, 2, 0}, 0.05).p == Approx(2.0 / 252));
  CHECK(welch({5, 2, 0}, {5, 2, 0}, 0.05).p == 1);
  CHECK(t_test(SomeValues(6, -3.0), 0.05).p == 2.0 / 64);
  CHECK(t_test(SomeValues(6, 0.0), 0.05).p == 1);
  CHECK_FALSE(t_test(SomeValues(6, -3.0), 0.05).interval);
}

TEST_CASE("the sign test leaves equal values out, and has the median's interval", "[tests_of_two]") {
  CHECK(sign_test(SomeValues{1, 2, 3, 4, 5, -6, 0}, 0.05).p == Approx(2 * 7.0 / 64));
  CHECK(sign_test(SomeValues{0, 0}, 0.05).p == 1);
  const UnadjustedTest test = sign_test(upto(20), 0.05);
  CHECK(test.estimate == 10.5);
  check_interval(test.interval, 6, 15);  // P(at most 5 of 20) = 0.0207, order statistics 6 and 15
}

TEST_CASE("Wilson's and Newcombe's intervals are those published", "[tests_of_two]") {
  check_interval(wilson_interval({0.9, 20}, 0.05), 0.6989663548,
                 0.9721335188);  // R, prop.test(18, 20, correct = FALSE)
  const double zz = 1.959963984540054 * 1.959963984540054;
  check_interval(wilson_interval({0, 20}, 0.05), 0, zz / (20 + zz));
  check_interval(wilson_interval({1, 20}, 0.05), 20 / (20 + zz), 1);
  // Newcombe, Statistics in Medicine 17 (1998) 873, Table II, method 10.
  check_interval(newcombe_interval({56 / 70.0, 70}, {48 / 80.0, 80}, 0.05), 0.0524, 0.3339, 5.1e-5);
  check_interval(newcombe_interval({9 / 10.0, 10}, {3 / 10.0, 10}, 0.05), 0.1705, 0.8090, 5.1e-5);
  check_interval(newcombe_interval({5 / 56.0, 56}, {0, 29}, 0.05), -0.0381, 0.1926, 5.1e-5);
  check_interval(newcombe_interval({1, 10}, {0, 10}, 0.05), 0.6075, 1, 5.1e-5);
}

TEST_CASE("Clopper and Pearson's interval of a share counts ties half", "[tests_of_two]") {
  check_interval(clopper_pearson_interval({0, 10}, 0.05), 0, 1 - std::pow(0.025, 0.1));
  check_interval(clopper_pearson_interval({1, 10}, 0.05), std::pow(0.025, 0.1), 1);
  check_interval(clopper_pearson_interval({0.5, 10}, 0.05), 0.1871, 0.8129, 5e-5);  // R, binom.test(5, 10)
  check_interval(clopper_pearson_interval({0.05, 20}, 0.05), 0.00127, 0.24873, 5e-6);
}

TEST_CASE("the interval of A12 solves Newcombe's equation for separate samples, and mirrors", "[tests_of_two]") {
  const Interval separate = a12_interval(upto(5, 10), upto(8), 0.05);
  const double low = separate.low, pairs = 1 + 5.5 * ((1 - low) / (2 - low) + low / (1 + low));
  CHECK(1 - low == Approx(1.959963984540054 * std::sqrt(low * (1 - low) * pairs / 40)));
  CHECK(separate.high == 1);
  const Interval first = a12_interval(may, august, 0.01), second = a12_interval(august, may, 0.01);
  check_interval(first, 1 - second.high, 1 - second.low);
  CHECK(second.low > 0.5);
  check_interval(a12_interval(SomeValues(4, 1), SomeValues(9, 1), 0.05),
                 1 - a12_interval(SomeValues(9, 1), SomeValues(4, 1), 0.05).high,
                 a12_interval(SomeValues(4, 1), SomeValues(9, 1), 0.05).high);
}

TEST_CASE("a drawn interval of A12 has the true one in about 95 % of sets, or in more", "[tests_of_two]") {
  std::mt19937_64 engine(1);
  const auto normal = [&] {  // the same numbers on every machine
    const auto uniform = [&] { return (static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53; };
    return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform());
  };
  struct Case {
    double shift, spread;
    bool has_ties;
    double least;  // that the share of sets has to have
  };
  for (const Case& of : {Case{0, 1, false, 0.94},
                         {1, 1, false, 0.94},
                         {3, 1, false, 0.94},
                         {0, 1, true, 0.94},
                         {2, 1, true, 0.94},
                         {1, 3, false, 0.91}}) {
    const auto drawn = [&](double shift, double spread, std::size_t n) {
      SomeValues values(n);
      for (double& value : values) {
        value = std::exp(shift + spread * normal());
        if (of.has_ties) value = std::round(value);
      }
      return values;
    };
    const auto share_above = [](const SomeValues& first, SomeValues second) {
      std::ranges::sort(second);
      double above = 0;
      for (const double value : first) {
        const auto [low, high] = std::equal_range(second.begin(), second.end(), value);
        above += static_cast<double>((low - second.begin()) + (high - second.begin())) / 2;
      }
      return above / static_cast<double>(first.size() * second.size());
    };
    const double truth = share_above(drawn(of.shift, of.spread, 100'000), drawn(0, 1, 100'000));
    constexpr int sets = 1000;
    for (const auto& [m, n] :
         {std::pair<std::size_t, std::size_t>{5, 5}, {10, 10}, {20, 20}, {50, 50}, {5, 20}, {50, 10}}) {
      int hits = 0, paired_hits = 0;
      for (int i = 0; i < sets; ++i) {
        const SomeValues first = drawn(of.shift, of.spread, m), second = drawn(0, 1, n);
        const Interval interval = a12_interval(first, second, 0.05);
        hits += interval.low <= truth && truth <= interval.high;
        double share = 0;
        for (std::size_t block = 0; block < std::min(m, n); ++block)
          share += share_above({first[block]}, {second[block]}) / static_cast<double>(std::min(m, n));
        const Interval paired = clopper_pearson_interval({share, static_cast<double>(std::min(m, n))}, 0.05);
        paired_hits += paired.low <= truth && truth <= paired.high;
      }
      INFO(of.shift << ' ' << of.spread << ' ' << of.has_ties << ' ' << m << ' ' << n);
      CHECK(hits >= of.least * sets);
      CHECK(paired_hits >= 0.95 * sets);
    }
  }
}

TEST_CASE("Fisher's p sums the tables that are no more probable", "[tests_of_two]") {
  CHECK(fisher(of_ones(3, 4), of_ones(1, 4), 0.05).p == Approx(34.0 / 70));  // the tea: weights 1 16 36 16 1
  CHECK(fisher(of_ones(2, 12), of_ones(15, 18), 0.05).p == Approx(0.0005367241191434358).epsilon(1e-11));  // R, twins
  CHECK(fisher(of_ones(180, 200), of_ones(150, 200), 0.05).p == Approx(0.00011278172795779367).epsilon(1e-10));
  CHECK(fisher(of_ones(100, 100), of_ones(88, 100), 0.05).p == Approx(0.0003439665141949307).epsilon(1e-10));
  CHECK(fisher(of_ones(1000, 1000), of_ones(0, 1000), 0.05).p < 1e-300);
  CHECK(fisher(of_ones(10, 10), of_ones(20, 20), 0.05).p == 1);
  CHECK(fisher(of_ones(0, 10), of_ones(0, 20), 0.05).p == 1);
}

TEST_CASE("McNemar's p is exact, with Newcombe's paired interval", "[tests_of_two]") {
  const auto paired = [](int both, int first, int second, int neither) {
    SomeValues a = of_ones(both + first, both + first), b = of_ones(both, both + first);
    a.resize(static_cast<std::size_t>(both + first + second + neither));
    b.insert(b.end(), static_cast<std::size_t>(second), 1.0);
    b.resize(a.size());
    return mcnemar(a, b, 0.05);
  };
  // Statistics in Medicine 17 (1998) 2635, method 10, by an independent script with SciPy 1.10.1.
  const UnadjustedTest first = paired(36, 12, 2, 0);
  CHECK(first.p == Approx(2 * (1 + 14 + 91) / 16384.0));  // 2 P(at most 2 of 14)
  CHECK(first.estimate == Approx(0.2));
  check_interval(first.interval, 0.05692958400323875, 0.3404276029749407);
  check_interval(paired(1, 1, 7, 12).interval, -0.506920226686141, -0.02555912416485978);
  check_interval(paired(0, 30, 0, 0).interval, 0.8394678198623838, 1);
  CHECK(paired(12, 9, 2, 21).p == Approx(0.0654296875));  // SciPy 1.10.1, binomtest(2, 11)
  CHECK(paired(7, 0, 0, 3).p == 1);
}

TEST_CASE("a hundred thousand values a group have a shift and its interval", "[tests_of_two]") {
  // Of 0 .. n - 1 and the same plus 1/4 there are n - |d| differences d - 1/4; up to d < 0 are (n + d)(n + d + 1) / 2.
  constexpr double n = 100'000;
  const UnadjustedTest test = rank_test(upto(100'000, 0), upto(100'000, 0.25), 0.05);
  CHECK(test.estimate == -0.25);
  const double rank = std::floor(n * n / 2 - 1.959963984540054 * std::sqrt(n * n * (2 * n + 1) / 12) + 0.5);
  double d = 1 - n;
  while ((n + d) * (n + d + 1) / 2 < rank) ++d;
  check_interval(test.interval, d - 0.25, -d - 0.25, 2);  // Brunner-Munzel reaches a little farther
}

TEST_CASE("what is no number keeps nothing from its end", "[tests_of_two]") {
  const SomeValues values{1, std::nan(""), 2, 2}, others{std::nan(""), 3, 3, std::nan("")};
  const double p = mann_whitney(values, others);
  CHECK((0 <= p && p <= 1));
  const Group first{.name = "A", .sample = Sample{.values = values}};
  const Group second{.name = "B", .sample = Sample{.values = others}};
  const PairData numbers = make_pair_data(first, second, {.metric = "m", .quantity = "m"}, true, false);
  REQUIRE(numbers.differences.size() == 4);
  CHECK(numbers.differences[3] != numbers.differences[3]);
}
