#include "tests/judge/studies.hpp"

namespace {

using Lists = std::vector<std::vector<double>>;
using Names = std::vector<std::string>;

// Groups A, B, C, ...
Observations groups_of(const Lists& groups, Scale scale = Scale::ratio) {
  Observations of{.metric = "error", .quantity = "position error", .unit = "cm", .scale = scale};
  if (scale == Scale::share) of.better = Better::larger;
  for (const auto& values : groups)
    of.groups.push_back(
        {.name = std::string(1, static_cast<char>('A' + of.groups.size())), .sample = Measured{values}});
  return of;
}

Observations paired(Observations of) {
  of.is_paired = true;
  return of;
}

const Plan by_ranks{}, by_means{.test = Plan::Test::means};

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

Seen only(const std::vector<Seen>& findings) {
  REQUIRE(findings.size() == 1);
  return findings.front();
}

std::string verdicts(const std::vector<Seen>& findings) {
  std::string result;
  for (const Seen& each : findings)
    result += each.first + each.second + " " + std::string(name_of(each.verdict)) + "; ";
  return result;
}

// The smallest n at which k separated groups can be told apart.
int fewest(int k, bool is_paired, const std::string& control) {
  for (int n = 2;; ++n) {
    Lists groups;
    for (int g = 0; g < k; ++g) groups.push_back(ramp(n, 1 + 100 * g, 1));
    Observations of = groups_of(groups);
    of.is_paired = is_paired;
    const std::vector<Seen> findings = compared(of, {.control = control});
    const auto is_tested = [](const Seen& each) { return each.why == Why::tested; };
    if (std::ranges::all_of(findings, is_tested)) {
      CHECK(std::ranges::all_of(findings, [](const Seen& each) { return each.verdict == Verdict::better; }));
      return n;
    }
    CHECK(std::ranges::none_of(findings, is_tested));
  }
}

}  // namespace

// The rules of ranks.

TEST_CASE("twenty values all below twenty others are better, whatever their spread", "[compare]") {
  const double spread = GENERATE(1e-9, 1.0, 1e6);
  const Seen found = only(compared(groups_of({ramp(20, 1, 1e-3), ramp(20, 2, spread)}), by_ranks));
  CHECK(found.verdict == Verdict::better);
  CHECK(*found.p == Approx(2 / 137846528820.0).epsilon(1e-12));  // C(40, 20)
  CHECK(found.effect == 1);
  CHECK(found.scale == Scale::ratio);
  CHECK(found.interval->high < 1);
  CHECK(found.test == "Brunner-Munzel and Mann-Whitney");
}

TEST_CASE("too few is a formula of sizes, pairs and significance", "[compare]") {
  for (int k = 2; k <= 6; ++k) {
    const auto at = static_cast<std::size_t>(k - 2);
    CHECK(fewest(k, false, "") == std::vector{4, 5, 5, 6, 6}[at]);
    CHECK(fewest(k, true, "") == std::vector{6, 7, 8, 9, 10}[at]);
    CHECK(fewest(k, false, "A") == std::vector{4, 5, 5, 5, 5}[at]);
    CHECK(fewest(k, true, "A") == std::vector{6, 7, 7, 8, 8}[at]);
  }
  const Observations six = paired(groups_of({ramp(6, 1, 0.1), ramp(6, 9, 0.1)}));  // p = 2 / 64, which has to be below
  CHECK(only(compared(six, {.significance = 1 / 32.0})).why == Why::too_few);
}

TEST_CASE("a pair that is not tested says how many it takes, and nothing of its few values", "[compare]") {
  const Seen found = only(compared(groups_of({{1, 2, 3}, {4, 8, 12}}), by_ranks));
  CHECK(found.verdict == Verdict::not_tested);
  CHECK(found.why == Why::too_few);
  CHECK(found.needed == 4);
  CHECK_FALSE(found.p);
  CHECK_FALSE(found.interval);
  CHECK_FALSE(found.estimate);
}

TEST_CASE("pairs without a p count neither in p nor in the level", "[compare]") {
  Observations of = groups_of({ramp(5, 1, 1), ramp(5, 3.5, 1.1)});
  const Seen alone = only(compared(of, by_ranks));
  of.groups.push_back({.name = "lost", .sample = Untold{.lost = 1, .values = ramp(5, 1, 3)}});
  of.groups.push_back({.name = "short", .sample = Measured{{1.5}}});
  const std::vector<Seen> findings = compared(of, by_ranks);
  CHECK(findings.size() == 6);
  CHECK(*findings[0].p == *alone.p);
  CHECK(findings[0].interval->low == alone.interval->low);
  CHECK(findings[1].why == Why::lost);
  CHECK_FALSE(findings[1].estimate);
  CHECK(findings[2].why == Why::too_few);
  CHECK(std::ranges::count(findings, Verdict::not_tested, &Seen::verdict) == 5);
}

TEST_CASE("the least able pairs leave first, together", "[compare]") {
  // 2 / C(8, 4) = 0.0286 alone is below 0.05. Beside two pairs of (4, 20), of p 0.0002, 0.05 / 3 is too small for it.
  CHECK(verdicts(compared(groups_of({ramp(4, 1, 1), ramp(4, 10, 1), ramp(20, 100, 1)}), by_ranks)) ==
        "AB not tested; AC better; BC better; ");
  // A group of two takes nothing from the others.
  CHECK(verdicts(compared(groups_of({ramp(4, 1, 1), ramp(4, 10, 1), ramp(2, 100, 1)}), by_ranks)) ==
        "AB better; AC not tested; BC not tested; ");
}

TEST_CASE("p is times the pairs, and with a control times those of the control", "[compare]") {
  const Observations of = groups_of({ramp(20, 1, 0.1), ramp(20, 1.53, 0.101), ramp(20, 2.21, 0.103)});
  const auto p_of = [&](std::size_t a, std::size_t b) {
    return rank_test(values_of(of.groups[a]), values_of(of.groups[b]), 0.05).p;
  };
  const std::vector<double> all{p_of(0, 1), p_of(0, 2), p_of(1, 2)}, of_b{p_of(0, 1), p_of(1, 2)};
  const std::vector<Seen> findings = compared(of, by_ranks), with_b = compared(of, {.control = "B"});
  for (std::size_t i = 0; i < 3; ++i) CHECK(*findings[i].p == std::min(1.0, 3 * all[i]));
  REQUIRE(with_b.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) CHECK(*with_b[i].p == std::min(1.0, 2 * of_b[i]));
  CHECK(with_b[0].interval->low > findings[0].interval->low);  // 0.05 / 2 and 0.05 / 3
  CHECK_THROWS_AS(compared(of, {.control = "D"}), std::invalid_argument);
}

// The same.

TEST_CASE("equal groups of small spread are the same", "[compare]") {
  const Seen found = only(compared(groups_of({lognormal(20, 1, 0.02, 1), lognormal(20, 1, 0.02, 2)}), by_ranks));
  CHECK(found.verdict == Verdict::same);
  CHECK(found.is_within_margin);
}

TEST_CASE("rare failures in one group keep it from being the same", "[compare]") {
  std::vector<double> failing = lognormal(20, 1, 0.02, 2);
  failing[3] *= 100;
  const Seen found = only(compared(groups_of({lognormal(20, 1, 0.02, 1), failing}), by_ranks));
  CHECK(found.verdict == Verdict::undecided);  // Hodges and Lehmann's interval does not see it; the t interval does
  CHECK(found.interval->high < 1.05);
  CHECK(found.interval->low > 1 / 1.05);
  const Seen in_blocks = only(compared(paired(groups_of({lognormal(20, 1, 0.02, 1), failing})), by_ranks));
  CHECK(in_blocks.verdict == Verdict::undecided);
}

TEST_CASE("values at the tolerance are no evidence of the same while others are far from it", "[compare]") {
  std::vector<double> all_but_two(20, 0.01);
  all_but_two[4] = 3, all_but_two[9] = 5;
  const Seen found = only(compared(groups_of({std::vector<double>(20, 0.01), all_but_two}), by_ranks));
  CHECK_FALSE(found.interval);  // it would be from 1 to 1
  CHECK(found.verdict == Verdict::undecided);
}

TEST_CASE("where most are equal and p decides, no estimate of 1 stands beside it", "[compare]") {
  std::vector<double> some(60, 0.01);
  for (std::size_t i = 0; i < 15; ++i) some[i] = 1 + static_cast<double>(i);
  const Seen found = only(compared(groups_of({std::vector<double>(60, 0.01), some}), by_ranks));
  CHECK(found.verdict == Verdict::better);
  CHECK_FALSE(found.estimate);
  CHECK_FALSE(found.interval);
  CHECK(*found.effect == 0.625);  // a half of 45 in 60, and 15
  CHECK_FALSE(found.is_within_margin);
}

TEST_CASE("all values equal are the same from 73, 109, 164 observations on for 1, 3, 15 pairs", "[compare]") {
  const bool is_paired = GENERATE(false, true);
  for (const auto& [k, n] : {std::pair(2u, 73u), std::pair(3u, 109u), std::pair(6u, 164u)}) {
    for (const auto& [scale, value] : {std::pair(Scale::ratio, 3.0), std::pair(Scale::share, 1.0)}) {
      for (const bool is_enough : {false, true}) {
        Observations of = groups_of(Lists(k, std::vector<double>(is_enough ? n : n - 1, value)), scale);
        of.is_paired = is_paired;
        for (const Seen& each : compared(of, by_ranks)) {
          CAPTURE(k, is_enough, is_paired, value);
          CHECK(each.are_all_equal);
          CHECK(each.p == 1);
          CHECK(each.verdict == (is_enough ? Verdict::same : Verdict::undecided));
        }
      }
    }
  }
}

TEST_CASE("an interval without width stands only beside what it decides", "[compare]") {
  for (const std::size_t n : {40u, 80u}) {
    Lists lists(2, std::vector<double>(n, 2.0));
    lists[0][0] = 3;
    const Seen found = only(compared(paired(groups_of(lists)), by_ranks));
    CHECK(*found.estimate == 1);
    CHECK(found.verdict == (found.interval ? Verdict::same : Verdict::undecided));
    CHECK(found.interval.has_value() == (n == 80));
  }
}

TEST_CASE("better by less than the margin needs both intervals within", "[compare]") {
  const Seen found = only(compared(groups_of({lognormal(60, 1, 0.01, 1), lognormal(60, 1.02, 0.01, 2)}), by_ranks));
  CHECK(found.verdict == Verdict::better);
  CHECK(found.is_within_margin);
  std::vector<double> failing = lognormal(60, 1.02, 0.01, 2);
  failing[3] *= 100;  // of which ranks see little, and means much
  const Seen usual = only(compared(groups_of({lognormal(60, 1, 0.01, 1), failing}), by_ranks));
  CHECK(usual.verdict == Verdict::better);
  CHECK_FALSE(usual.is_within_margin);
  const Seen far = only(compared(groups_of({lognormal(60, 1, 0.01, 1), lognormal(60, 1.2, 0.01, 2)}), by_ranks));
  CHECK(far.verdict == Verdict::better);
  CHECK_FALSE(far.is_within_margin);
  Lists some_without(2);  // an answer; a share of their means says nothing
  for (int i = 0; i < 20; ++i) {
    for (const double offset : {0, 100})
      some_without[offset > 0].push_back(i == 0 ? std::numeric_limits<double>::infinity() : offset + i);
  }
  const Seen by_100 = only(compared(groups_of(some_without, Scale::difference), by_ranks));
  CHECK_FALSE(by_100.is_within_margin);
}

TEST_CASE("few constant values are not the same because they have no spread", "[compare]") {
  Observations of = groups_of({{1, 1, 1}, {1.01, 1.01, 1.01}});
  CHECK(only(compared(of, by_means)).verdict == Verdict::undecided);
  CHECK(only(compared(paired(of), by_means)).verdict == Verdict::undecided);
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
  for (const Plan& plan : {by_ranks, by_means}) {
    for (const bool is_paired : {false, true}) {
      for (const double ratio : {1.01, 1.0505}) {
        Observations of = groups_of({std::vector<double>(20, 1.0), std::vector<double>(20, ratio)});
        of.is_paired = is_paired;
        const Seen found = only(compared(of, plan));
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
  for (const Plan::Test test : {Plan::Test::ranks, Plan::Test::means}) {
    const auto within = [&](double margin, const Lists& lists, Scale scale, double relative = 0) {
      Observations of = groups_of(lists, scale);
      of.absolute_margin = margin;
      return only(compared(of, {.test = test, .margin = relative}));
    };
    CHECK(within(1, {negative[0], negative[0]}, Scale::difference).verdict == Verdict::same);
    CHECK(within(1, negative, Scale::difference).is_within_margin);
    CHECK(within(0.01, negative, Scale::difference).verdict != Verdict::same);
    CHECK_FALSE(within(0.01, negative, Scale::difference).is_within_margin);
    // 0.001 cm and 0.002 cm differ by a factor of two, and by less than 0.01 cm.
    const Lists small{lognormal(20, 0.001, 0.1, 1), lognormal(20, 0.002, 0.1, 2)};
    const Seen hair = within(0.01, small, Scale::ratio, 0.05);
    CHECK(hair.verdict == Verdict::better);
    CHECK(hair.is_within_margin);
    CHECK_FALSE(only(compared(groups_of(small), {.test = test})).is_within_margin);
  }
  const Seen relative = only(compared(groups_of({negative[0], negative[0]}, Scale::difference), by_means));
  CHECK(relative.verdict == Verdict::same);  // 0.25 of -5
}

// Blocks.

TEST_CASE("blocks of different scales are judged by the logarithms of their ratios", "[compare]") {
  std::vector<double> a, b;
  for (int i = 0; i < 10; ++i) {
    a.push_back(std::pow(10.0, i / 2.0));
    b.push_back(2 * a.back() * (1 + 0.01 * i));
  }
  const Seen found = only(compared(paired(groups_of({a, b})), by_ranks));
  CHECK(*found.p == 2 / 1024.0);
  CHECK(found.verdict == Verdict::better);
  CHECK(*found.estimate == Approx(0.5).epsilon(0.1));
  CHECK(found.effect == 1);
  CHECK(only(compared(groups_of({a, b}), by_ranks)).verdict == Verdict::undecided);
  CHECK(only(compared(paired(groups_of({a, b})), by_means)).verdict == Verdict::undecided);
}

TEST_CASE("values below the floor are raised to it, and 0 to 0 is the ratio 1", "[compare]") {
  Observations of = paired(groups_of({{0, 1e-9, 3, 3, 3, 3, 3, 3}, {1e-12, 0, 6, 6.1, 6.2, 6.3, 6.4, 6.5}}));
  of.floor = 1e-7;
  const Seen found = only(compared(of, by_ranks));
  CHECK(*found.p == 2 / 64.0);      // two pairs are equal, six ranks are left
  CHECK(*found.effect == 7.0 / 8);  // equal pairs count half
  CHECK(*found.estimate == Approx(0.5).epsilon(0.1));
  for (Group& group : of.groups) std::ranges::fill(values_in(group), 0.0);
  CHECK(only(compared(of, by_ranks)).are_all_equal);
}

TEST_CASE("the share of blocks ahead is shown, and p and the ratio decide", "[compare]") {
  // Six of ten a little behind, four far ahead: ranks 1 to 6 against 7 to 10.
  std::vector<double> a(10, 1.0), b{0.99, 0.98, 0.97, 0.96, 0.95, 0.94, 20, 30, 40, 50};
  const Seen found = only(compared(paired(groups_of({a, b})), by_ranks));
  CHECK(*found.effect == Approx(0.4));
  CHECK(*found.p == Approx(signed_rank_test(std::vector<double>{1, 2, 3, 4, 5, 6, -7, -8, -9, -10}, 0.05).p));
  CHECK(*found.estimate < 1);
}

TEST_CASE("differences that rounding alone keeps apart are equal", "[compare]") {
  // 0.3 - 0.1 and 0.4 - 0.2 differ in the last bit.
  const Seen found = only(
      compared(paired(groups_of({{0.3, 0.4, 0.5, 0.6, 0.7, 0.8}, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}}, Scale::difference)),
               by_ranks));
  CHECK(*found.p == 2 / 64.0);
  CHECK(found.interval->low == found.interval->high);
  const Seen far = only(  // and so in larger numbers, which round more
      compared(
          paired(groups_of({{100.3, 200.4, 300.5, 400.6, 500.7, 600.8}, {100.1, 200.2, 300.3, 400.4, 500.5, 600.6}},
                           Scale::difference)),
          by_ranks));
  CHECK(far.interval->low == far.interval->high);
  Observations of = groups_of({ramp(6, 1, 1e-10), ramp(6, 1 + 1e-11, 1e-10)});
  CHECK_FALSE(only(compared(of, by_ranks)).are_all_equal);
  of.rounding = 1e-9;
  CHECK(only(compared(of, by_ranks)).are_all_equal);
}

TEST_CASE("one huge block makes nothing small that is large in the others, nor equal that differs", "[compare]") {
  const std::vector<double> one{0,     1.37,  1.626, 1.013, 1.259, 1.996, 1.836, 1.639, 1.635, 1.523,
                                1.671, 1.758, 1.301, 1.866, 1.719, 1.714, 1.395, 1.445, 1.879};
  const std::vector<double> other{2.01,  2.172, 2.159, 1.932, 1.876, 2.731, 2.574, 2.214, 2.569, 2.394,
                                  2.203, 2.554, 1.817, 2.602, 2.658, 2.675, 2.295, 2.413, 2.428};
  const auto found = [&](double block, bool is_paired, const Plan& plan, double unit = 1) {
    Lists lists{one, other};
    for (std::vector<double>& values : lists) {
      for (double& value : values) value *= unit;
      values.push_back(block);
    }
    Observations of = groups_of(lists, Scale::difference);
    of.is_paired = is_paired;
    return only(compared(of, plan));
  };
  for (const double block : {1000.0, 1e12, 1e30}) {
    const Seen in_blocks = found(block, true, by_ranks);
    CHECK(*in_blocks.p == std::exp2(-18));  // as SciPy's wilcoxon, exact; the normal approximation has 0.00013
    CHECK(in_blocks.verdict == Verdict::better);
    CHECK(*in_blocks.effect == 19.5 / 20);
    CHECK_FALSE(in_blocks.is_within_margin);
    const Seen unpaired = found(block, false, by_ranks);
    CHECK(unpaired.verdict == Verdict::better);
    CHECK_FALSE(unpaired.is_within_margin);
    CHECK(found(block, true, by_means).why == Why::few_decide);
    CHECK(*found(block, true, by_means).estimate == Approx(-0.78155).epsilon(1e-12));
  }
  CHECK(found(1e12, true, by_ranks, 1e-4).verdict == Verdict::better);
  CHECK(found(1e12, true, by_ranks, 1e-4).p == found(1000, true, by_ranks).p);
  // Medians 56 % apart, and an interval that is wider.
  const Lists wide{
      {1000, 0.7748, 0.6108, 2.535, 1.412, 2.046, 0.5603, 0.8586, 2.377, 0.4169, 0.5043, 1.638, 0.7504, 1.776, 0},
      {1000, 1.234, 0.3959, 1.6, 1.561, 1.135, 0.7438, 1.345, 2.113, 0.3311, 1.532, 4.174, 1.327, 2.379, 0}};
  CHECK(only(compared(paired(groups_of(wide, Scale::difference)), by_ranks)).verdict == Verdict::undecided);
}

// Means.

TEST_CASE("a plan by means has Welch's and the paired t, of differences", "[compare]") {
  const Lists sleep{{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0},
                    {1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4}};
  const Seen unpaired = only(compared(groups_of(sleep, Scale::difference), by_means));
  CHECK(unpaired.scale == Scale::difference);
  CHECK(unpaired.test == "Welch's t");
  const Seen in_blocks = only(compared(paired(groups_of(sleep, Scale::difference)), by_means));
  CHECK(in_blocks.verdict == Verdict::better);
  CHECK(in_blocks.interval->low == Approx(-2.4598858).epsilon(1e-7));  // R, t.test
  CHECK(*in_blocks.effect == 0.95);                                    // nine of ten smaller, one equal
}

TEST_CASE("by means nothing is better while one value is more than half of its group's sum", "[compare]") {
  std::vector<double> one = ramp(20, 5, 0.01), failing = ramp(20, 1, 0.01);
  failing[7] = 22;  // of 43.0
  const Seen found = only(compared(groups_of({failing, one}), by_means));
  CHECK(found.why == Why::few_decide);
  CHECK(found.verdict == Verdict::undecided);
  CHECK(found.estimate);
  CHECK_FALSE(found.p);
  CHECK_FALSE(found.interval);
  failing[7] = 20;
  CHECK(only(compared(groups_of({failing, one}), by_means)).verdict == Verdict::better);
  failing[7] = 22;
  CHECK(only(compared(groups_of({failing, one}), by_ranks)).why == Why::tested);
}

TEST_CASE("means need three values: of two the larger is more than half of their sum", "[compare]") {
  for (const bool is_paired : {false, true}) {
    for (int n = 1; n <= 3; ++n) {
      Observations of = groups_of({ramp(n, 1, 0.001), ramp(n, 50, 0.01)});
      of.is_paired = is_paired;
      const Seen found = only(compared(of, by_means));
      CHECK(found.verdict == (n < 3 ? Verdict::not_tested : Verdict::better));
      CHECK(found.needed == (n < 3 ? 3 : 0));
    }
  }
}

TEST_CASE("published summaries are judged by Welch's t, of differences", "[compare]") {
  // The error of Table 3: Welch's t by hand, (1.6849 - 0.0019) / (0.9069 / sqrt 20) = 8.299 on 19 degrees of freedom.
  Observations of = groups_of({});
  of.groups = {{.name = "IK-BA", .sample = Summary{20, 0.0019, 1.7824e-4}},
               {.name = "BA", .sample = Summary{20, 1.6849, 0.9069}},
               {.name = "DE", .sample = Summary{20, 0.3653, 0.2929}},
               {.name = "K-ABC", .sample = Summary{20, 0.2318, 0.0722}}};
  for (const Plan& plan : {by_ranks, by_means}) {
    const std::vector<Seen> findings = compared(of, plan);
    CHECK(verdicts(findings) ==
          "IK-BABA better; IK-BADE better; IK-BAK-ABC better; BADE worse; BAK-ABC worse; DEK-ABC not decided; ");
    CHECK(findings[0].scale == Scale::difference);
    CHECK(*findings[0].estimate == Approx(-1.683));
    CHECK_FALSE(findings[0].effect);
    CHECK(*findings[5].p == 6 * welch({20, 0.3653, 0.2929}, {20, 0.2318, 0.0722}, 0.05).p);
    CHECK(headline(of, findings).best == Names{"IK-BA"});
  }
}

// Shares.

TEST_CASE("shares of one trial are judged by Fisher and Newcombe, in blocks by McNemar", "[compare]") {
  const Observations of = groups_of({solved(100, 100), solved(88, 100), solved(54, 100)}, Scale::share);
  const std::vector<Seen> findings = compared(of, by_ranks);
  CHECK(verdicts(findings) == "AB better; AC better; BC better; ");
  CHECK(*findings[0].p == Approx(3 * 0.0003439665141949307).epsilon(1e-9));
  CHECK(*findings[0].estimate == Approx(0.12));
  // At 1 - 0.05 / 3.
  CHECK(std::lround(100 * findings[0].interval->low) == 4);
  CHECK(std::lround(100 * findings[0].interval->high) == 22);
  CHECK(std::lround(100 * findings[1].interval->low) == 33);
  CHECK(std::lround(100 * findings[1].interval->high) == 58);
  CHECK(findings[0].test == "Fisher's exact");
  const std::vector<Seen> in_blocks = compared(paired(of), by_ranks);
  CHECK(*in_blocks[0].p == 3 * 2 / 4096.0);  // twelve of twelve, of three pairs
  CHECK(in_blocks[0].test == "McNemar's exact");
}

TEST_CASE("several trials a target are one share, judged by t in points", "[compare]") {
  // Five runs a target. Differences .2 .4 .2 .4 .2 .4: mean .3, deviation .1095, t = 6.708 on 5 degrees of freedom.
  Observations of = paired(groups_of({{1, 1, .8, .8, 1, 1}, {.8, .6, .6, .4, .8, .6}}, Scale::share));
  of.trials = 5;
  const Seen found = only(compared(of, by_ranks));
  CHECK(found.test == "paired t");
  CHECK(*found.estimate == Approx(0.3));
  CHECK(*found.p == Approx(0.001114).epsilon(0.005));
  CHECK(found.verdict == Verdict::better);
  of.is_paired = false;
  CHECK(only(compared(of, by_ranks)).test == "Welch's t");
}

TEST_CASE("two constant shares have Newcombe's interval of that many targets if they are equal, else none",
          "[compare]") {
  for (const bool is_paired : {false, true}) {
    Observations of = groups_of({std::vector<double>(20, 0.8), std::vector<double>(20, 0.8)}, Scale::share);
    of.trials = 5;
    of.is_paired = is_paired;
    const Interval expected = newcombe(0.8, 20, 0.8, 20, 0.05), found = *only(compared(of, by_ranks)).interval;
    CHECK(found.low == Approx(expected.low));
    CHECK(found.high == Approx(expected.high));
    std::ranges::fill(values_in(of.groups[0]), 1.0);
    CHECK(only(compared(of, by_ranks)).verdict == Verdict::better);  // p of the permutations
    CHECK_FALSE(only(compared(of, by_ranks)).interval);
  }
}

TEST_CASE("an interval of shares ends at 1", "[compare]") {
  Observations of = groups_of({{1, 1, 0.8}, {0, 0, 0.2}}, Scale::share);
  of.trials = 5;
  for (const bool is_paired : {false, true}) {
    of.is_paired = is_paired;
    CHECK(only(compared(of, by_ranks)).interval->high == 1);
    std::swap(values_in(of.groups[0]), values_in(of.groups[1]));
    CHECK(only(compared(of, by_ranks)).interval->low == -1);
    std::swap(values_in(of.groups[0]), values_in(of.groups[1]));
  }
}

TEST_CASE("Fisher's smallest p is one table of groups of two sizes, two of equal ones", "[compare]") {
  const Observations unequal = groups_of({solved(3, 3), solved(0, 4)}, Scale::share);
  CHECK(*only(compared(unequal, by_ranks)).p == Approx(1 / 35.0));
  CHECK(only(compared(unequal, {.significance = 0.0285})).why == Why::too_few);
  const Observations equal = groups_of({solved(4, 4), solved(0, 4)}, Scale::share);
  CHECK(*only(compared(equal, by_ranks)).p == Approx(2 / 70.0));
  CHECK(only(compared(equal, {.significance = 0.0285})).why == Why::too_few);
}

TEST_CASE("one target solved among many does not keep shares from a verdict", "[compare]") {
  Observations of = groups_of({solved(1, 40), solved(40, 40)}, Scale::share);
  of.trials = 5;
  CHECK(only(compared(of, by_means)).verdict == Verdict::worse);
}

// Solvers that repeat themselves.

TEST_CASE("two solvers that repeat themselves differ by a fact", "[compare]") {
  Observations of = groups_of({{2}, {4}});
  for (Group& group : of.groups) group.sample = Copies{values_of(group).front(), 20};
  const Seen found = only(compared(of, by_ranks));
  CHECK(found.why == Why::fact);
  CHECK(found.verdict == Verdict::better);
  CHECK(*found.estimate == Approx(0.5));
  CHECK_FALSE(found.p);
  of.rounding = 4;  // of the metric, which tells no two values that are nearer
  CHECK(only(compared(of, by_ranks)).verdict == Verdict::same);
}

TEST_CASE("runs are compared with the value of a solver that repeats itself by their signs", "[compare]") {
  Observations of = groups_of({{1}, {2, 3, 4, 5, 6, 7}});
  of.groups[0].sample = Copies{values_of(of.groups[0]).front(), 20};
  const Seen found = only(compared(of, by_ranks));
  CHECK(found.test == "sign test");
  CHECK(*found.p == 2 / 64.0);
  CHECK(found.verdict == Verdict::better);
  CHECK(*found.estimate == Approx(1 / std::sqrt(20.0)));  // the median of logarithms: between 4 and 5
  CHECK(found.effect == 1);
  values_in(of.groups[1]).push_back(1);  // equal to the value: dropped
  CHECK(*only(compared(of, by_ranks)).p == 2 / 64.0);
  values_in(of.groups[1]) = {1, 1, 2, 3, 4, 5, 6};
  const Seen few = only(compared(of, by_ranks));
  CHECK(few.why == Why::too_few);
  CHECK(few.n == 5);
  CHECK(few.needed == 6);
  values_in(of.groups[1]) = {1, 1, 1};
  CHECK(only(compared(of, by_ranks)).n == 0);
}

TEST_CASE("a solver that repeats itself differs in shares by the difference of the shares", "[compare]") {
  // Ten runs of ten targets; one always solves all, the other 17 of 100.
  Observations of = groups_of({{1}, {.1, .2, .3, .1, .2, .1, .2, .3, .1, .1}}, Scale::share);
  of.groups[0].sample = Copies{1, 10};
  of.trials = 10;
  const Seen found = only(compared(of, by_ranks));
  CHECK(found.test == "paired t");
  CHECK(*found.estimate == Approx(0.83));
  CHECK(found.n == 10);
  CHECK(found.interval->low == Approx(0.83 - 2.262157 * 0.0823273 / std::sqrt(10.0)).epsilon(1e-4));  // t of 9
  std::swap(of.groups[0], of.groups[1]);
  CHECK(*only(compared(of, by_ranks)).estimate == Approx(-0.83));
}

TEST_CASE("values of fifteen decades differ by their ratios from one that repeats itself", "[compare]") {
  Observations of =
      groups_of({{}, {4e-16, 5e-16, 6e-16, 7e-16, 8e-16, 4.5e-16, 5.5e-16, 6.5e-16, 7.5e-16, 8.5e-16, .9}});
  of.groups[0].sample = Copies{1e-16, 10};
  of.floor = 1e-300;
  const Seen found = only(compared(of, by_ranks));
  CHECK(found.n == 11);
  CHECK(*found.p == 2 / 2048.0);
  CHECK(found.verdict == Verdict::better);
}

TEST_CASE("an absolute margin leaves equal values the same from as many on as a share does", "[compare]") {
  for (const int n : {72, 200}) {
    Observations of = groups_of(Lists(2, std::vector<double>(static_cast<std::size_t>(n), 5)));
    of.absolute_margin = 0.1;
    CHECK(only(compared(of, {.margin = 0})).verdict == (n == 200 ? Verdict::same : Verdict::undecided));
  }
}

TEST_CASE("as many more observations as it says would about decide what is not decided", "[compare]") {
  // 55 of 100 ahead: McNemar at 0.05 with a chance of 0.8 takes 783 pairs, all of which differ (Lehr's 8 / 0.1^2).
  Observations of = paired(groups_of({solved(55, 100), solved(45, 100)}, Scale::share));
  std::ranges::reverse(values_in(of.groups[1]));
  const Seen found = only(compared(of, by_ranks));
  CHECK(found.verdict == Verdict::undecided);
  CHECK(std::get<Tested>(found.what).enough > 650);
  CHECK(std::get<Tested>(found.what).enough < 1100);  // the exact p is larger than the normal one
  const Seen near = only(compared(groups_of({lognormal(20, 1, 0.1, 1), lognormal(20, 1, 0.1, 2)}), by_ranks));
  CHECK(near.verdict == Verdict::undecided);
  CHECK(std::get<Tested>(near.what).enough > 20);
  CHECK(std::get<Tested>(only(compared(groups_of({ramp(20, 1, 0.1), ramp(20, 9, 0.1)}), by_ranks)).what).enough == 0);
}

// p, interval and verdict.

TEST_CASE("an interval of unpaired ranks has what either test keeps, of five and twenty values", "[compare]") {
  const Observations of =
      groups_of({{1.75981412952897, 55.4688216820432, 1.46609659157177, 1.04159158081134, 10.741577261979},
                 {1.01185006213213,  0.989261839158649, 0.831280497453605, 1.0451044302842,  1.35461925927757,
                  0.858446003620109, 0.810877603883547, 1.09024115887056,  1.24228974916032, 0.807378838800918,
                  1.07192113404207,  0.811566791462305, 1.22013371231482,  1.00980167730198, 0.780670740047111,
                  1.1834369413162,   0.821657375540992, 1.16814254935747,  1.2718826241216,  1.21931070327248}});
  const Seen found = better_first(only(compared(of, by_ranks)), "");
  CHECK(found.first == "B");
  CHECK(*found.p == Approx(0.0144).epsilon(0.005));
  CHECK(found.interval->low == Approx(0.0211).epsilon(0.005));
  CHECK(found.interval->high == Approx(0.847).epsilon(0.001));
  CHECK_FALSE(found.interval->excludes_high);
}

TEST_CASE("an interval holds no difference where p does not decide, and excludes it where it does", "[compare]") {
  const auto points = [](double share) { return std::round(1000 * share) / 10; };
  const Seen open = only(compared(groups_of({solved(100, 100), solved(95, 100)}, Scale::share), by_ranks));
  CHECK(*open.p == Approx(0.0594).epsilon(0.001));
  CHECK(open.verdict == Verdict::undecided);
  CHECK(points(*open.estimate) == 5);
  CHECK(open.interval->low == 0);
  CHECK(points(open.interval->high) == 11.2);

  const Observations five_to_none = paired(groups_of({solved(5, 20), solved(0, 20)}, Scale::share));
  const Seen pairs = only(compared(five_to_none, by_ranks));
  CHECK(*pairs.p == 0.0625);
  CHECK(*pairs.estimate == 0.25);
  CHECK(pairs.interval->low == 0);
  CHECK(points(pairs.interval->high) == 46.9);

  const Seen none = only(compared(groups_of({solved(0, 20), solved(33, 200)}, Scale::share), by_ranks));
  CHECK(*none.p == Approx(0.0496).epsilon(0.001));
  CHECK(none.verdict == Verdict::worse);
  CHECK(points(*none.estimate) == -16.5);
  CHECK(points(none.interval->low) == -22.3);
  CHECK(none.interval->high == 0);
  CHECK(none.interval->excludes_high);
  const Seen turned = better_first(none, "");
  CHECK(turned.interval->low == 0);
  CHECK(turned.interval->excludes_low);
  CHECK_FALSE(turned.interval->excludes_high);

  const std::vector<double> differences{0.5, 0.6, 0.7, 0.8, 0.9, 1, 0, 0, 0, 0};
  const Seen blocks =
      only(compared(paired(groups_of({differences, std::vector<double>(10)}, Scale::difference)), by_ranks));
  CHECK(*blocks.p == 0.03125);
  CHECK(*blocks.estimate == Approx(0.45));
  CHECK(blocks.interval->low == 0);
  CHECK(blocks.interval->excludes_low);
  CHECK(blocks.interval->high == Approx(0.8));
}

TEST_CASE("of equal values that may be copies the larger p of two readings decides", "[compare]") {
  const auto found_of = [](std::vector<double> equal, std::vector<double> others) {
    const bool are_both_equal = std::ranges::count(others, others.front()) == std::ssize(others);
    Observations of = groups_of({std::move(equal), std::move(others)});
    measured(of.groups[0]).may_repeat = true;
    measured(of.groups[1]).may_repeat = are_both_equal;
    return only(compared(of, by_ranks));
  };
  std::vector<double> most_equal(94, 0.01);
  for (int i = 1; i <= 6; ++i) most_equal.push_back(0.01 + 0.01 * i);
  const Seen few_against_many = found_of(std::vector(6, 0.01), most_equal);
  CHECK(*few_against_many.p == Approx(0.550).epsilon(0.001));  // Mann-Whitney; the sign test alone says 0.031
  CHECK(few_against_many.verdict == Verdict::undecided);
  std::vector<double> spread;
  for (int i = 0; i < 20; ++i) spread.push_back(1.5 + 0.1 * i);
  CHECK(*found_of(std::vector(20, 1.0), spread).p == Approx(1.91e-6).epsilon(0.002));  // the sign test
  CHECK(*found_of(std::vector(10, 1.0), std::vector(10, 2.0)).p == Approx(1.08e-5).epsilon(0.003));
  CHECK(found_of(std::vector(3, 1.0), std::vector(3, 2.0)).why == Why::too_few);
}

// Properties.

namespace {

// A design and values of any kind: ties, zeros, failures, constants, copies, shares of 0 and 1.
struct DrawnSet {
  Observations of;
  Plan plan;
};

DrawnSet drawn_set(std::mt19937_64& engine) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(engine() % n); };
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  const bool is_large = below(50) == 0;
  const std::size_t k = below(20) == 0 ? 2 + below(13) : 2 + below(2);
  const std::size_t n = 2 + below(is_large && k < 5 ? 199 : 14);
  DrawnSet drawn{.of = {.scale = std::array{Scale::ratio, Scale::difference, Scale::share}[below(3)]}, .plan = {}};
  Observations& of = drawn.of;
  of.better = below(2) == 0 ? Better::smaller : Better::larger;
  of.is_paired = below(2) == 0;
  of.trials = below(2) == 0 ? 1 : 4;
  of.floor = of.scale == Scale::ratio ? 1e-3 : 0;
  of.absolute_margin = below(4) == 0 ? 0.1 : 0;
  drawn.plan.test = below(3) == 0 ? Plan::Test::means : Plan::Test::ranks;
  drawn.plan.significance = std::array{0.05, 0.05, 0.01, 0.3}[below(4)];
  drawn.plan.control = below(4) == 0 ? "A" : "";
  const std::size_t kind = below(6);
  const bool lack_blocks = below(3) == 0;
  for (std::size_t g = 0; g < k; ++g) {
    Measured group;
    std::optional<Copies> copies;
    group.values.resize(of.is_paired || below(2) == 0 ? n : 2 + below(n));
    const double middle = std::array{1.0, 1.02, 1.5, 5.0}[below(4)], share = std::array{0.0, 0.1, 0.8, 1.0}[below(4)];
    std::normal_distribution<double> normal(0, below(2) == 0 ? 1 : 0.02);
    for (double& value : group.values) {
      value = middle * std::exp(normal(engine));
      if (kind == 1) value = std::round(2 * value) / 2;            // ties, and zeros
      if (kind == 2 && uniform() < 0.7) value = 0;                 // at the floor
      if (kind == 3 && uniform() < 0.1) value *= 1000;             // failures
      if (kind == 4) value = middle;                               // constant
      if (kind == 5) value = std::round(value) + (below(2) == 0);  // ties of few values
      if (of.scale == Scale::difference && kind == 0) value -= 1;  // of either sign
      if (of.scale != Scale::share) continue;
      int solved = 0;
      for (int trial = 0; trial < of.trials; ++trial) solved += uniform() < share;
      value = solved / static_cast<double>(of.trials);
    }
    if (!of.is_paired) group.may_repeat = std::ranges::count(group.values, group.values[0]) == std::ssize(group.values);
    if (!of.is_paired && below(5) == 0) {
      copies = Copies{group.values.front(), static_cast<int>(n)};
    }
    if (of.is_paired && lack_blocks) {
      group.blocks.resize(n);
      std::iota(group.blocks.begin(), group.blocks.end(), 0);
      group.blocks.erase(group.blocks.begin() + static_cast<std::ptrdiff_t>(below(n)));
      group.values.pop_back();
    }
    of.groups.push_back({.name = std::string(1, static_cast<char>('A' + g)), .sample = group});
    if (copies) of.groups.back().sample = *copies;
  }
  return drawn;
}

// What p, estimate, interval and verdict say of a difference; empty if it is one thing.
std::string disagreement(const Seen& found, const Plan& plan, Better better) {
  const double none = found.scale == Scale::ratio ? 1 : 0;
  const auto& [low, high, excludes_low, excludes_high] = found.interval.value_or(Interval{});
  if (found.interval && found.estimate && !(low <= *found.estimate && *found.estimate <= high))
    return "the estimate is outside the interval";
  if (found.interval && !found.estimate) return "an interval of no estimate";
  if (found.why == Why::fact) return found.estimate && !found.interval ? "" : "a fact without its amount";
  if (!found.p) return is_difference(found.verdict) || found.interval ? "a verdict or an interval without p" : "";
  if ((*found.p < plan.significance) != is_difference(found.verdict)) return "p and verdict";
  if (found.verdict == Verdict::same && !found.is_within_margin) return "the same outside the margin";
  if (!is_difference(found.verdict)) {
    if (!found.estimate) return "no estimate";
    return found.interval && !(low <= none && none <= high && !excludes_low && !excludes_high) ? "none is left out"
                                                                                               : "";
  }
  const bool is_larger = (found.verdict == Verdict::better) == (better == Better::larger);
  if (found.estimate && (is_larger ? *found.estimate <= none : *found.estimate >= none)) return "the estimate";
  const bool is_none_out =
      is_larger ? low > none || (low == none && excludes_low) : high < none || (high == none && excludes_high);
  return found.interval && !is_none_out ? "none is held" : "";
}

}  // namespace

TEST_CASE("p, interval, estimate and verdict of no pair disagree", "[compare][property]") {
  std::mt19937_64 engine(11);
  int decided = 0, excluded = 0, ahead = 0, same = 0, open = 0;
  for (int set = 0; set < 10'000; ++set) {
    const auto [of, plan] = drawn_set(engine);
    for (const Seen& found : compared(of, plan)) {
      const Seen turned = better_first(found, plan.control);
      decided += is_difference(found.verdict);
      ahead += is_difference(found.verdict) && !found.estimate;
      excluded += found.interval && (found.interval->excludes_low || found.interval->excludes_high);
      same += found.verdict == Verdict::same;
      open += found.verdict == Verdict::undecided;
      const std::string one = disagreement(found, plan, of.better), other = disagreement(turned, plan, of.better);
      if (one.empty() && other.empty()) continue;
      CAPTURE(set, found.first, found.second, found.test, one, other);
      FAIL();
    }
  }
  CAPTURE(decided, excluded, ahead, same, open);
  CHECK(std::min({decided, excluded, ahead, same, open}) > 30);
}

// The headline.

TEST_CASE("best is better than every other", "[compare]") {
  Observations of = groups_of({ramp(10, 5, 0.1), ramp(10, 1, 0.1), ramp(10, 5.05, 0.1)});
  CHECK(headline(of, compare(of, by_ranks)).best == Names{"B"});
  values_in(of.groups[2]) = ramp(10, 2.5, 0.1);  // worse than B, and better than A
  CHECK(headline(of, compare(of, by_ranks)).best == Names{"B"});
  values_in(of.groups[2]) = ramp(10, 1.05, 0.1);  // not told from B, and better than A
  CHECK(headline(of, compare(of, by_ranks)).best == Names{"B", "C"});
  CHECK(headline(of, compare(of, {.control = "A"})).best.empty());  // B and C were not compared
  values_in(of.groups[0]) = ramp(10, 1.4, 0.1);                     // worse than B alone
  const Headline none = headline(of, compare(of, by_ranks));
  CHECK(none.best.empty());
  CHECK_FALSE(none.is_circle);
  CHECK(headline(groups_of({{1, 2}}), std::vector<Finding>()).best.empty());
  of = groups_of({solved(99, 100), solved(50, 100)}, Scale::share);
  CHECK(headline(of, compare(of, by_ranks)).best == Names{"A"});
}

TEST_CASE("verdicts that form a circle have no best", "[compare]") {
  // A third of the values of each is far below, between or above those of the next: P = 5 / 9 all round (Efron's dice).
  const auto dice = [](std::vector<double> faces) {
    std::vector<double> values;
    for (int i = 0; i < 200; ++i) {
      for (const double face : faces) values.push_back(face + 1e-5 * i);
    }
    return values;
  };
  Observations of = groups_of({dice({2, 4, 9}), dice({1, 6, 8}), dice({3, 5, 7})}, Scale::difference);
  const std::vector<Seen> findings = compared(of, by_ranks);
  CHECK(verdicts(findings) == "AB worse; AC better; BC worse; ");
  const Headline none = headline(of, findings);
  CHECK(none.best.empty());
  CHECK(none.is_circle);
}

TEST_CASE("a winner by ranks whose mean or median lies the other way is warned of", "[compare]") {
  const auto warned_of = [](const Observations& of, const Plan& plan = {}) {
    const JudgedMetric all = judge(of, plan);
    CHECK(all.headline.best == Names{"A"});
    return all.observations.doubts.empty() ? "" : all.observations.doubts.front().what;
  };
  // A usually has 0.0001, and once in ten 0.3; B always has 0.0005.
  std::vector<double> a = ramp(20, 0.0001, 1e-6);
  a[3] = a[11] = 0.3;
  Observations of = groups_of({a, ramp(20, 0.0005, 1e-6)});
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
  Observations of = paired(groups_of({ramp(12, 1, 0.1), ramp(9, 20, 0.1), ramp(3, 30, 0.1)}));
  measured(of.groups[0]).blocks = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  measured(of.groups[1]).blocks = {2, 4, 6, 8, 10, 12, 14, 16, 18};
  measured(of.groups[2]).blocks = {14, 16, 18};
  const auto findings = compared(of, by_ranks);
  CHECK(findings[0].n == 6);
  CHECK(*findings[0].p == 2 / 64.0);
  CHECK(*findings[0].estimate == Approx(0.0776131597));
  CHECK(findings[1].why == Why::too_few);
  CHECK(findings[1].n == 0);
  CHECK_FALSE(findings[1].estimate);
  CHECK(findings[2].why == Why::too_few);
  CHECK(findings[2].n == 3);
  CHECK_FALSE(findings[2].estimate);  // of so few it would say more than it can
}
