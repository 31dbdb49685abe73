#include "tests/judge/studies.hpp"

namespace {

using Lists = std::vector<std::vector<double>>;
using Names = std::vector<std::string>;

// Sets the attempts of each value, where shares are compared.
void set_trials(MetricSamples& of, int trials) {
  if (is_proportion(of)) of.kind = Proportions{.trials_per_value = trials};
}

// Groups A, B, C, ...
MetricSamples groups_of(const Lists& groups, EffectScale scale = EffectScale::ratio) {
  MetricSamples of{.metric = "error", .quantity = "position error", .unit = "cm", .kind = kind_with(scale)};
  if (scale == EffectScale::share) of.better = Better::larger;
  for (const auto& values : groups)
    of.groups.push_back({.name = std::string(1, static_cast<char>('A' + of.groups.size())), .sample = Sample{values}});
  return of;
}

MetricSamples paired(MetricSamples of) {
  of.is_paired = true;
  return of;
}

const AnalysisPlan by_ranks{}, by_means{.test = AnalysisPlan::Test::means};

std::vector<double> ramp(int n, double from, double step) {
  std::vector<double> values;
  for (int i = 0; i < n; ++i) values.push_back(from + step * i);
  return values;
}

// Quantiles of a lognormal distribution, times `median`: the same for all groups but for a small step that avoids ties.
std::vector<double> lognormal(int n, double median, double sigma, double shift = 0) {
  std::mt19937_64 engine(static_cast<std::uint64_t>(1000 * shift) + 11);
  std::normal_distribution<double> normal;
  std::vector<double> values;
  for (int i = 0; i < n; ++i) values.push_back(median * std::exp(sigma * normal(engine)));
  return values;
}

std::vector<double> solved(int ones, int all) {
  std::vector<double> values(static_cast<std::size_t>(all));
  std::fill_n(values.begin(), ones, 1.0);
  return values;
}

FlatComparison only(const std::vector<FlatComparison>& comparisons) {
  REQUIRE(comparisons.size() == 1);
  return comparisons.front();
}

std::string verdicts(const std::vector<FlatComparison>& comparisons) {
  std::string result;
  for (const FlatComparison& each : comparisons)
    result += each.first + each.second + " " + std::string(name_of(each.verdict)) + "; ";
  return result;
}

// The smallest n at which k separated groups can be told apart.
int fewest(int k, bool is_paired, const std::string& control) {
  for (int n = 2;; ++n) {
    Lists groups;
    for (int g = 0; g < k; ++g) groups.push_back(ramp(n, 1 + 100 * g, 1));
    MetricSamples of = groups_of(groups);
    of.is_paired = is_paired;
    const std::vector<FlatComparison> comparisons = compared(of, {.control = control});
    const auto is_tested = [](const FlatComparison& each) { return each.why == ResultKind::tested; };
    if (std::ranges::all_of(comparisons, is_tested)) {
      CHECK(
          std::ranges::all_of(comparisons, [](const FlatComparison& each) { return each.verdict == Verdict::better; }));
      return n;
    }
    CHECK(std::ranges::none_of(comparisons, is_tested));
  }
}

}  // namespace

// The rules of ranks.

TEST_CASE("too few is a formula of sizes, pairs and significance", "[compare]") {
  for (int k = 2; k <= 6; ++k) {
    const auto at = static_cast<std::size_t>(k - 2);
    CHECK(fewest(k, false, "") == std::vector{4, 5, 5, 6, 6}[at]);
    CHECK(fewest(k, true, "") == std::vector{6, 7, 7, 7, 7}[at]);
    CHECK(fewest(k, false, "A") == std::vector{4, 5, 5, 5, 5}[at]);
    CHECK(fewest(k, true, "A") == std::vector{6, 7, 7, 7, 7}[at]);
  }
  const MetricSamples six = paired(groups_of({ramp(6, 1, 0.1), ramp(6, 9, 0.1)}));  // p = 2 / 64, which has to be below
  CHECK(only(compared(six, {.significance = 1 / 32.0})).why == ResultKind::too_few);
}

TEST_CASE("a pair that is not tested says how many it takes, and nothing of its few values", "[compare]") {
  const FlatComparison found = only(compared(groups_of({{1, 2, 3}, {4, 8, 12}}), by_ranks));
  CHECK(found.verdict == Verdict::not_tested);
  CHECK(found.why == ResultKind::too_few);
  CHECK(found.needed == 4);
  CHECK_FALSE(found.p);
  CHECK_FALSE(found.interval);
  CHECK_FALSE(found.estimate);
}

TEST_CASE("p is times the pairs, and with a control times those of the control", "[compare]") {
  const MetricSamples of = groups_of({ramp(20, 1, 0.1), ramp(20, 1.53, 0.101), ramp(20, 2.21, 0.103)});
  const auto p_of = [&](std::size_t a, std::size_t b) {
    return rank_test(values_of(of.groups[a]), values_of(of.groups[b]), 0.05).p;
  };
  const std::vector<double> all{p_of(0, 1), p_of(0, 2), p_of(1, 2)}, of_b{p_of(0, 1), p_of(1, 2)};
  const std::vector<FlatComparison> comparisons = compared(of, by_ranks), with_b = compared(of, {.control = "B"});
  for (std::size_t i = 0; i < 3; ++i) CHECK(*comparisons[i].p == std::min(1.0, 3 * all[i]));
  REQUIRE(with_b.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) CHECK(*with_b[i].p == std::min(1.0, 2 * of_b[i]));
  CHECK(with_b[0].interval->low > comparisons[0].interval->low);  // 0.05 / 2 and 0.05 / 3
  CHECK_THROWS_AS(compared(of, {.control = "D"}), std::invalid_argument);
}

// The same.

TEST_CASE("values at the tolerance are no evidence of the same while others are far from it", "[compare]") {
  std::vector<double> all_but_two(20, 0.01);
  all_but_two[4] = 3, all_but_two[9] = 5;
  const FlatComparison found = only(compared(groups_of({std::vector<double>(20, 0.01), all_but_two}), by_ranks));
  CHECK_FALSE(found.interval);  // it would be from 1 to 1
  CHECK(found.verdict == Verdict::inconclusive);
}

TEST_CASE("where most are equal and p decides, no estimate of 1 stands beside it", "[compare]") {
  std::vector<double> some(60, 0.01);
  for (std::size_t i = 0; i < 15; ++i) some[i] = 1 + static_cast<double>(i);
  const FlatComparison found = only(compared(groups_of({std::vector<double>(60, 0.01), some}), by_ranks));
  CHECK(found.verdict == Verdict::better);
  CHECK_FALSE(found.estimate);
  CHECK_FALSE(found.interval);
  CHECK(*found.effect == 0.625);  // a half of 45 in 60, and 15
  CHECK_FALSE(found.is_within_margin);
}

TEST_CASE("all values equal are the same from 73, 109, 164 observations on for 1, 3, 15 pairs", "[compare]") {
  const bool is_paired = GENERATE(false, true);
  for (const auto& [k, n] : {std::pair(2u, 73u), std::pair(3u, 109u), std::pair(6u, 164u)}) {
    for (const auto& [scale, value] : {std::pair(EffectScale::ratio, 3.0), std::pair(EffectScale::share, 1.0)}) {
      for (const bool is_enough : {false, true}) {
        MetricSamples of = groups_of(Lists(k, std::vector<double>(is_enough ? n : n - 1, value)), scale);
        of.is_paired = is_paired;
        for (const FlatComparison& each : compared(of, by_ranks)) {
          CAPTURE(k, is_enough, is_paired, value);
          CHECK(each.are_all_equal);
          CHECK(each.p == 1);
          CHECK(each.verdict == (is_enough ? Verdict::equivalent : Verdict::inconclusive));
        }
      }
    }
  }
}

TEST_CASE("of two sizes the smaller decides whether equal values are the same", "[compare]") {
  for (const auto& [scale, value] : {std::pair(EffectScale::ratio, 3.0), std::pair(EffectScale::share, 1.0)}) {
    for (const std::size_t n : {72u, 73u}) {
      for (const bool is_first : {false, true}) {
        Lists groups{std::vector<double>(n, value), std::vector<double>(400, value)};
        if (!is_first) std::swap(groups[0], groups[1]);
        CAPTURE(n, is_first, value);
        CHECK(only(compared(groups_of(groups, scale), by_ranks)).verdict ==
              (n == 73 ? Verdict::equivalent : Verdict::inconclusive));
      }
    }
  }
}

TEST_CASE("of several reasons against a test the first of the enum is told, whichever group has it", "[compare]") {
  const Group infinite{.name = "A", .sample = Sample{{1, 2, 3, std::numeric_limits<double>::infinity(), 5}}};
  for (const auto& [excluded, told] : {std::pair(ExclusionReason::missing_values, NotTestedReason::missing_values),
                                       std::pair(ExclusionReason::not_comparable, NotTestedReason::infinite_values)}) {
    const Group without{.name = "B", .sample = ExcludedSample{.reason = excluded, .values = {1, 2, 3, 4, 5}}};
    MetricSamples of = groups_of({}, EffectScale::difference);
    for (const auto& groups : {std::vector{infinite, without}, std::vector{without, infinite}}) {
      of.groups = groups;
      const std::vector<Comparison> comparisons = compare_pairs(of, by_means, 1);
      REQUIRE(comparisons.size() == 1);
      CHECK(std::get<NotTested>(comparisons.front().result).reason == told);
    }
  }
}

TEST_CASE("an interval without width stands only beside what it decides", "[compare]") {
  for (const std::size_t n : {40u, 80u}) {
    Lists lists(2, std::vector<double>(n, 2.0));
    lists[0][0] = 3;
    const FlatComparison found = only(compared(paired(groups_of(lists)), by_ranks));
    CHECK(*found.estimate == 1);
    CHECK(found.verdict == (found.interval ? Verdict::equivalent : Verdict::inconclusive));
    CHECK(found.interval.has_value() == (n == 80));
  }
}

TEST_CASE("few constant values are not the same because they have no spread", "[compare]") {
  MetricSamples of = groups_of({{1, 1, 1}, {1.01, 1.01, 1.01}});
  CHECK(only(compared(of, by_means)).verdict == Verdict::inconclusive);
  CHECK(only(compared(paired(of), by_means)).verdict == Verdict::inconclusive);
  // An interval that ends at the margin, whatever the last bit of a unit.
  std::vector<double> a(20, 10), b(20, 10);
  std::fill_n(a.begin(), 7, 10.5), std::fill_n(b.begin(), 12, 10.5);
  const Verdict in_cm = only(compared(groups_of({a, b}), by_ranks)).verdict;
  for (std::vector<double>* const all : {&a, &b}) {
    for (double& value : *all) value *= 10;
  }
  CHECK(only(compared(groups_of({a, b}), by_ranks)).verdict == in_cm);
}

TEST_CASE("a constant ratio within the margin is no plain better", "[compare]") {
  for (const AnalysisPlan& plan : {by_ranks, by_means}) {
    for (const bool is_paired : {false, true}) {
      for (const double ratio : {1.01, 1.0505}) {
        MetricSamples of = groups_of({std::vector<double>(20, 1.0), std::vector<double>(20, ratio)});
        of.is_paired = is_paired;
        const FlatComparison found = only(compared(of, plan));
        CHECK(found.verdict == Verdict::better);
        CHECK(found.is_within_margin == (ratio < 1.05));
      }
    }
  }
  std::vector<double> some{3, 4, 5, 6, 7, 8, 9, 10}, more = some;
  for (double& value : more) value *= 1.01;
  CHECK(only(compared(paired(groups_of({some, more})), by_ranks)).is_within_margin);
}

TEST_CASE("an absolute margin holds for ranks and for means, of differences and of ratios", "[compare]") {
  const Lists negative{ramp(20, -5.1, 0.01), ramp(20, -5.15, 0.01)};
  for (const AnalysisPlan::Test test : {AnalysisPlan::Test::ranks, AnalysisPlan::Test::means}) {
    const auto within = [&](double margin, const Lists& lists, EffectScale scale, double relative = 0) {
      MetricSamples of = groups_of(lists, scale);
      of.absolute_margin = margin;
      return only(compared(of, {.test = test, .margin = relative}));
    };
    CHECK(within(1, {negative[0], negative[0]}, EffectScale::difference).verdict == Verdict::equivalent);
    CHECK(within(1, negative, EffectScale::difference).is_within_margin);
    CHECK(within(0.01, negative, EffectScale::difference).verdict != Verdict::equivalent);
    CHECK_FALSE(within(0.01, negative, EffectScale::difference).is_within_margin);
    // 0.001 cm and 0.002 cm differ by a factor of two, and by less than 0.01 cm.
    const Lists small{lognormal(20, 0.001, 0.1, 1), lognormal(20, 0.002, 0.1, 2)};
    const FlatComparison hair = within(0.01, small, EffectScale::ratio, 0.05);
    CHECK(hair.verdict == Verdict::better);
    CHECK(hair.is_within_margin);
    CHECK_FALSE(only(compared(groups_of(small), {.test = test})).is_within_margin);
  }
  const FlatComparison relative =
      only(compared(groups_of({negative[0], negative[0]}, EffectScale::difference), by_means));
  CHECK(relative.verdict == Verdict::equivalent);  // 0.25 of -5
}

TEST_CASE("no share of medians is a margin where a value is no answer", "[compare]") {
  Lists lists(2);
  for (int i = 0; i < 20; ++i) {
    for (const double offset : {0, 100})
      lists[offset > 0].push_back(i == 0 ? std::numeric_limits<double>::infinity() : offset + i);
  }
  CHECK_FALSE(only(compared(groups_of(lists, EffectScale::difference), by_ranks)).is_within_margin);
}

// Blocks.

TEST_CASE("values below the floor are raised to it, and 0 to 0 is the ratio 1", "[compare]") {
  MetricSamples of = paired(groups_of({{0, 1e-9, 3, 3, 3, 3, 3, 3}, {1e-12, 0, 6, 6.1, 6.2, 6.3, 6.4, 6.5}}));
  of.kind = Ratios{.floor = 1e-7};
  const FlatComparison found = only(compared(of, by_ranks));
  CHECK(*found.p == 2 / 64.0);      // two pairs are equal, six ranks are left
  CHECK(*found.effect == 7.0 / 8);  // equal pairs count half
  CHECK(*found.estimate == Approx(0.5).epsilon(0.1));
  for (Group& group : of.groups) std::ranges::fill(values_in(group), 0.0);
  CHECK(only(compared(of, by_ranks)).are_all_equal);
}

TEST_CASE("differences that rounding alone keeps apart are equal", "[compare]") {
  // 0.3 - 0.1 and 0.4 - 0.2 differ in the last bit.
  const FlatComparison found = only(compared(
      paired(groups_of({{0.3, 0.4, 0.5, 0.6, 0.7, 0.8}, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}}, EffectScale::difference)),
      by_ranks));
  CHECK(*found.p == 2 / 64.0);
  CHECK(found.interval->low == found.interval->high);
  const FlatComparison far = only(  // and so in larger numbers, which round more
      compared(
          paired(groups_of({{100.3, 200.4, 300.5, 400.6, 500.7, 600.8}, {100.1, 200.2, 300.3, 400.4, 500.5, 600.6}},
                           EffectScale::difference)),
          by_ranks));
  CHECK(far.interval->low == far.interval->high);
  MetricSamples of = groups_of({ramp(6, 1, 1e-10), ramp(6, 1 + 1e-11, 1e-10)});
  CHECK_FALSE(only(compared(of, by_ranks)).are_all_equal);
  of.resolution = 1e-9;
  CHECK(only(compared(of, by_ranks)).are_all_equal);
}

// Means.

TEST_CASE("a plan by means has Welch's and the paired t, of differences", "[compare]") {
  const Lists sleep{{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0},
                    {1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4}};
  const FlatComparison unpaired = only(compared(groups_of(sleep, EffectScale::difference), by_means));
  CHECK(unpaired.scale == EffectScale::difference);
  CHECK(unpaired.test == "Welch's t");
  const FlatComparison in_blocks = only(compared(paired(groups_of(sleep, EffectScale::difference)), by_means));
  CHECK(in_blocks.verdict == Verdict::better);
  CHECK(in_blocks.interval->low == Approx(-2.4598858).epsilon(1e-7));  // R, t.test
  CHECK(*in_blocks.effect == 0.95);                                    // nine of ten smaller, one equal
}

TEST_CASE("means need three values, because two say too little of a spread", "[compare]") {
  for (const bool is_paired : {false, true}) {
    for (int n = 1; n <= 3; ++n) {
      MetricSamples of = groups_of({ramp(n, 1, 0.001), ramp(n, 50, 0.01)});
      of.is_paired = is_paired;
      const FlatComparison found = only(compared(of, by_means));
      CHECK(found.verdict == (n < 3 ? Verdict::not_tested : Verdict::better));
      CHECK(found.needed == (n < 3 ? 3 : 0));
    }
  }
}

TEST_CASE("a common value added to all changes no verdict of means", "[compare]") {
  const auto verdict = [](const Lists& lists, bool is_paired, double shift) {
    Lists shifted = lists;
    for (std::vector<double>& values : shifted)
      for (double& value : values) value += shift;
    MetricSamples of = groups_of(shifted);
    of.is_paired = is_paired;
    return only(compared(of, by_means));
  };
  Lists far = {ramp(40, 0, 0.0001), ramp(40, 0.2, 0.0001)}, near = far;
  far[0][39] = 1;      // lies farther than the means lie apart
  near[0][39] = 0.05;  // lies farther from the median than all others together, but decides nothing
  for (const double shift : {0.0, 10.0, 1000.0}) {
    CHECK(verdict(far, false, shift).why == ResultKind::few_decide);
    CHECK(verdict(near, false, shift).verdict == Verdict::better);
    CHECK(verdict(near, true, shift).verdict == Verdict::better);
  }
  // A hard block that both have decides nothing of their differences.
  Lists hard = {{1, 1.1, 1.2, 1.3, 900}, {2, 2.2, 2.1, 2.4, 901.2}};
  CHECK(verdict(hard, true, 0).verdict == Verdict::better);
  CHECK(verdict(hard, false, 0).verdict == Verdict::inconclusive);
}

TEST_CASE("published summaries are judged by Welch's t, of differences", "[compare]") {
  // The error of Table 3: Welch's t by hand, (1.6849 - 0.0019) / (0.9069 / sqrt 20) = 8.299 on 19 degrees of freedom.
  MetricSamples of = groups_of({});
  of.groups = {{.name = "IK-BA", .sample = SummaryStatistics{20, 0.0019, 1.7824e-4}},
               {.name = "BA", .sample = SummaryStatistics{20, 1.6849, 0.9069}},
               {.name = "DE", .sample = SummaryStatistics{20, 0.3653, 0.2929}},
               {.name = "K-ABC", .sample = SummaryStatistics{20, 0.2318, 0.0722}}};
  for (const AnalysisPlan& plan : {by_ranks, by_means}) {
    const std::vector<FlatComparison> comparisons = compared(of, plan);
    CHECK(verdicts(comparisons) ==
          "IK-BABA better; IK-BADE better; IK-BAK-ABC better; BADE worse; BAK-ABC worse; DEK-ABC inconclusive; ");
    CHECK(comparisons[0].scale == EffectScale::difference);
    CHECK(*comparisons[0].estimate == Approx(-1.683));
    CHECK_FALSE(comparisons[0].effect);
    CHECK(*comparisons[5].p == 6 * welch({20, 0.3653, 0.2929}, {20, 0.2318, 0.0722}, 0.05).p);
  }
}

// Shares.

TEST_CASE("two constant shares have Newcombe's interval of that many targets if they are equal, else none",
          "[compare]") {
  for (const bool is_paired : {false, true}) {
    MetricSamples of = groups_of({std::vector<double>(20, 0.8), std::vector<double>(20, 0.8)}, EffectScale::share);
    set_trials(of, 5);
    of.is_paired = is_paired;
    const Interval expected = newcombe_interval({0.8, 20}, {0.8, 20}, 0.05),
                   found = *only(compared(of, by_ranks)).interval;
    CHECK(found.low == Approx(expected.low));
    CHECK(found.high == Approx(expected.high));
    std::ranges::fill(values_in(of.groups[0]), 1.0);
    CHECK(only(compared(of, by_ranks)).verdict == Verdict::better);  // p of the permutations
    CHECK_FALSE(only(compared(of, by_ranks)).interval);
  }
}

TEST_CASE("an interval of shares ends at 1", "[compare]") {
  MetricSamples of = groups_of({{1, 1, 0.8}, {0, 0, 0.2}}, EffectScale::share);
  set_trials(of, 5);
  for (const bool is_paired : {false, true}) {
    of.is_paired = is_paired;
    CHECK(only(compared(of, by_ranks)).interval->high == 1);
    std::swap(values_in(of.groups[0]), values_in(of.groups[1]));
    CHECK(only(compared(of, by_ranks)).interval->low == -1);
    std::swap(values_in(of.groups[0]), values_in(of.groups[1]));
  }
}

TEST_CASE("Fisher's smallest p is one table of groups of two sizes, two of equal ones", "[compare]") {
  const MetricSamples unequal = groups_of({solved(3, 3), solved(0, 4)}, EffectScale::share);
  CHECK(*only(compared(unequal, by_ranks)).p == Approx(1 / 35.0));
  CHECK(only(compared(unequal, {.significance = 0.0285})).why == ResultKind::too_few);
  const MetricSamples equal = groups_of({solved(4, 4), solved(0, 4)}, EffectScale::share);
  CHECK(*only(compared(equal, by_ranks)).p == Approx(2 / 70.0));
  CHECK(only(compared(equal, {.significance = 0.0285})).why == ResultKind::too_few);
}

TEST_CASE("one target solved among many does not keep shares from a verdict", "[compare]") {
  MetricSamples of = groups_of({solved(1, 40), solved(40, 40)}, EffectScale::share);
  set_trials(of, 5);
  CHECK(only(compared(of, by_means)).verdict == Verdict::worse);
}

// Solvers that repeat themselves.

TEST_CASE("two solvers that repeat themselves differ by a fact", "[compare]") {
  MetricSamples of = groups_of({{2}, {4}});
  for (Group& group : of.groups) group.sample = Sample{.values = {values_of(group).front()}, .is_deterministic = true};
  const FlatComparison found = only(compared(of, by_ranks));
  CHECK(found.why == ResultKind::deterministic);
  CHECK(found.verdict == Verdict::better);
  CHECK(*found.estimate == Approx(0.5));
  CHECK_FALSE(found.p);
  of.resolution = 4;  // of the metric, which tells no two values that are nearer
  CHECK(only(compared(of, by_ranks)).verdict == Verdict::equivalent);
}

TEST_CASE("which group stands first changes no p", "[compare]") {
  const auto p_of = [](const Group& first, const Group& second, EffectScale scale) {
    MetricSamples of = groups_of({{}, {}}, scale);
    of.groups = {first, second};
    set_trials(of, 5);
    return *only(compared(of, by_ranks)).p;
  };
  const Group one{.name = "A", .sample = Sample{.values = {1}, .is_deterministic = true}},
      equal{.name = "B", .sample = Sample{.values = std::vector(12, 2.0)}},
      no_share{.name = "B", .sample = Sample{.values = std::vector(12, 0.0)}},
      copies{.name = "A", .sample = Sample{.values = std::vector(20, 1.5), .is_constant = true}},
      without{.name = "B", .sample = Sample{.values = std::vector(8, ikbench::infinity)}};
  CHECK(p_of(one, equal, EffectScale::ratio) == 2 / 4096.0);
  CHECK(p_of(equal, one, EffectScale::ratio) == 2 / 4096.0);
  CHECK(p_of(one, no_share, EffectScale::share) < 0.001);
  CHECK(p_of(no_share, one, EffectScale::share) == p_of(one, no_share, EffectScale::share));
  CHECK(p_of(copies, without, EffectScale::ratio) == 2 / 256.0);
  CHECK(p_of(without, copies, EffectScale::ratio) == 2 / 256.0);
  // Three signs decide nothing, however many copies they stand against.
  for (const bool are_first : {true, false}) {
    const std::vector<double> copied(45, 1), others{2, 3, 4};
    MetricSamples of = groups_of({are_first ? copied : others, are_first ? others : copied});
    sample_of(of.groups[are_first ? 0 : 1]).is_constant = true;
    CHECK(only(compared(of, by_ranks)).why == ResultKind::too_few);
  }
}

TEST_CASE("runs are compared with the value of a solver that repeats itself by their signs", "[compare]") {
  MetricSamples of = groups_of({{1}, {2, 3, 4, 5, 6, 7}});
  of.groups[0].sample = Sample{.values = {values_of(of.groups[0]).front()}, .is_deterministic = true};
  const FlatComparison found = only(compared(of, by_ranks));
  CHECK(found.test == "sign test");
  CHECK(*found.p == 2 / 64.0);
  CHECK(found.verdict == Verdict::better);
  CHECK(*found.estimate == Approx(1 / std::sqrt(20.0)));  // the median of logarithms: between 4 and 5
  CHECK(found.effect == 1);
  values_in(of.groups[1]).push_back(1);  // equal to the value: dropped
  CHECK(*only(compared(of, by_ranks)).p == 2 / 64.0);
  values_in(of.groups[1]) = {1, 1, 2, 3, 4, 5, 6};
  CHECK(only(compared(of, by_ranks)).verdict == Verdict::inconclusive);
  values_in(of.groups[1]) = {2, 3, 4, 5, 6};
  const FlatComparison few = only(compared(of, by_ranks));
  CHECK(few.why == ResultKind::too_few);
  CHECK(few.n == 5);
  CHECK(few.needed == 6);
}

TEST_CASE("a solver that repeats itself differs in shares by the difference of the shares", "[compare]") {
  // Ten runs of ten targets; one always solves all, the other 17 of 100.
  MetricSamples of = groups_of({{1}, {.1, .2, .3, .1, .2, .1, .2, .3, .1, .1}}, EffectScale::share);
  of.groups[0].sample = Sample{.values = {1}, .is_deterministic = true};
  set_trials(of, 10);
  const FlatComparison found = only(compared(of, by_ranks));
  CHECK(found.test == "one-sample t");
  CHECK(*found.estimate == Approx(0.83));
  CHECK(found.n == 10);
  CHECK(found.interval->low == Approx(0.83 - 2.262157 * 0.0823273 / std::sqrt(10.0)).epsilon(1e-4));  // t of 9
  std::swap(of.groups[0], of.groups[1]);
  CHECK(*only(compared(of, by_ranks)).estimate == Approx(-0.83));
}

TEST_CASE("values of fifteen decades differ by their ratios from one that repeats itself", "[compare]") {
  MetricSamples of =
      groups_of({{}, {4e-16, 5e-16, 6e-16, 7e-16, 8e-16, 4.5e-16, 5.5e-16, 6.5e-16, 7.5e-16, 8.5e-16, .9}});
  of.groups[0].sample = Sample{.values = {1e-16}, .is_deterministic = true};
  of.kind = Ratios{.floor = 1e-300};
  const FlatComparison found = only(compared(of, by_ranks));
  CHECK(found.n == 11);
  CHECK(*found.p == 2 / 2048.0);
  CHECK(found.verdict == Verdict::better);
}

TEST_CASE("an absolute margin leaves equal values the same from as many on as a share does", "[compare]") {
  for (const int n : {72, 200}) {
    MetricSamples of = groups_of(Lists(2, std::vector<double>(static_cast<std::size_t>(n), 5)));
    of.absolute_margin = 0.1;
    CHECK(only(compared(of, {.margin = 0})).verdict == (n == 200 ? Verdict::equivalent : Verdict::inconclusive));
  }
}

TEST_CASE("as many more observations as it says would about decide what is inconclusive", "[compare]") {
  // 55 of 100 ahead: McNemar at 0.05 with a chance of 0.8 takes 783 pairs, all of which differ (Lehr's 8 / 0.1^2).
  MetricSamples of = paired(groups_of({solved(55, 100), solved(45, 100)}, EffectScale::share));
  std::ranges::reverse(values_in(of.groups[1]));
  const FlatComparison found = only(compared(of, by_ranks));
  CHECK(found.verdict == Verdict::inconclusive);
  CHECK(std::get<TestResult>(found.result).required_n > 650);
  CHECK(std::get<TestResult>(found.result).required_n < 1100);          // the exact p is larger than the normal one
  std::ranges::fill(std::span(values_in(of.groups[0])).first(6), 0.0);  // 49 against 45: p = 0.76
  CHECK(std::get<TestResult>(only(compared(of, by_ranks)).result).required_n == 0);
  CHECK(std::get<TestResult>(only(compared(groups_of({ramp(20, 1, 0.1), ramp(20, 9, 0.1)}), by_ranks)).result)
            .required_n == 0);
}

// p, interval and verdict.

TEST_CASE("of equal values that may be copies the larger p of two readings decides", "[compare]") {
  const auto found_of = [](std::vector<double> equal, std::vector<double> others) {
    const bool are_both_equal = std::ranges::count(others, others.front()) == std::ssize(others);
    MetricSamples of = groups_of({std::move(equal), std::move(others)});
    sample_of(of.groups[0]).is_constant = true;
    sample_of(of.groups[1]).is_constant = are_both_equal;
    return only(compared(of, by_ranks));
  };
  std::vector<double> most_equal(94, 0.01);
  for (int i = 1; i <= 6; ++i) most_equal.push_back(0.01 + 0.01 * i);
  const FlatComparison few_against_many = found_of(std::vector(6, 0.01), most_equal);
  CHECK(*few_against_many.p == Approx(0.550).epsilon(0.001));  // Mann-Whitney; the sign test alone says 0.031
  CHECK(few_against_many.verdict == Verdict::inconclusive);
  std::vector<double> spread;
  for (int i = 0; i < 20; ++i) spread.push_back(1.5 + 0.1 * i);
  CHECK(*found_of(std::vector(20, 1.0), spread).p == Approx(1.91e-6).epsilon(0.002));  // the sign test
  CHECK(*found_of(std::vector(10, 1.0), std::vector(10, 2.0)).p == Approx(1.08e-5).epsilon(0.003));
  CHECK(found_of(std::vector(3, 1.0), std::vector(3, 2.0)).why == ResultKind::too_few);
}

TEST_CASE("verdicts may form a circle", "[compare]") {
  // A third of the values of each is far below, between or above those of the next: P = 5 / 9 all round (Efron's dice).
  const auto dice = [](std::vector<double> faces) {
    std::vector<double> values;
    for (int i = 0; i < 200; ++i) {
      for (const double face : faces) values.push_back(face + 1e-5 * i);
    }
    return values;
  };
  MetricSamples of = groups_of({dice({2, 4, 9}), dice({1, 6, 8}), dice({3, 5, 7})}, EffectScale::difference);
  const std::vector<FlatComparison> comparisons = compared(of, by_ranks);
  CHECK(verdicts(comparisons) == "AB worse; AC better; BC worse; ");
}

TEST_CASE("a winner by ranks whose mean or median lies the other way is warned of", "[compare]") {
  const auto warned_of = [](const MetricSamples& of, const AnalysisPlan& plan = {}) {
    const JudgedMetric all = judge::judge(of, plan);
    return all.samples.warnings.empty() ? "" : all.samples.warnings.front().detail;
  };
  // A usually has 0.0001, and once in ten 0.3; B always has 0.0005.
  std::vector<double> a = ramp(20, 0.0001, 1e-6);
  a[3] = a[11] = 0.3;
  MetricSamples of = groups_of({a, ramp(20, 0.0005, 1e-6)});
  CHECK(warned_of(of) == "mean position error");
  of.absolute_margin = 0.1;
  CHECK(warned_of(of).empty());  // 0.03 does not matter
  Lists groups{ramp(48, 0.5, 0.001), ramp(55, 1, 0.001)};
  for (const double value : ramp(52, 5.48, 0.01)) groups[0].push_back(value);
  for (const double value : ramp(45, 10.55, 0.01)) groups[1].push_back(value);
  CHECK(warned_of(groups_of(groups)) == "median position error");
  CHECK(warned_of(groups_of(groups), by_means).empty());
}

TEST_CASE("A pair has the blocks that both groups have, and can decide what their number can") {
  MetricSamples of = paired(groups_of({ramp(12, 1, 0.1), ramp(9, 20, 0.1), ramp(3, 30, 0.1)}));
  sample_of(of.groups[0]).blocks = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  sample_of(of.groups[1]).blocks = {2, 4, 6, 8, 10, 12, 14, 16, 18};
  sample_of(of.groups[2]).blocks = {14, 16, 18};
  const auto comparisons = compared(of, by_ranks);
  CHECK(comparisons[0].n == 6);
  CHECK(*comparisons[0].p == 2 / 64.0);
  CHECK(*comparisons[0].estimate == Approx(0.0776131597));
  CHECK(comparisons[1].why == ResultKind::too_few);
  CHECK(comparisons[1].n == 0);
  CHECK_FALSE(comparisons[1].estimate);
  CHECK(comparisons[2].why == ResultKind::too_few);
  CHECK(comparisons[2].n == 3);
  CHECK_FALSE(comparisons[2].estimate);  // of so few it would say more than it can
}

TEST_CASE("an A12 that is not on the side of the verdict has no interval", "[compare]") {
  // Of 60 values 31 are a little worse, and 29 much better: signed ranks weigh how much.
  std::vector<double> first, second;
  for (int i = 0; i < 60; ++i) {
    first.push_back(1 + 0.01 * i);
    second.push_back(first.back() * (i < 31 ? 0.999 - 1e-5 * i : 2.0 + i));
  }
  const Comparison comparison = compare_pairs(paired(groups_of({first, second})), by_ranks, 1).front();
  const TestResult& tested = std::get<TestResult>(comparison.result);
  CHECK(tested.verdict == Verdict::better);
  REQUIRE(tested.dominance);
  CHECK(tested.dominance->a12() < 0.5);
  CHECK_FALSE(tested.dominance->interval);
}
