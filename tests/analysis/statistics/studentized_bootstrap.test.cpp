#include "analysis/statistics/studentized_bootstrap.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <stdexcept>

#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench::statistics;

namespace {

using Groups = std::vector<std::vector<double>>;

const Groups two{{1.2, 3.4, 0.7, 5.9, 2.2}, {6.1, 8.3, 7.2, 12.5}};
const Groups three{{1.2, 3.4, 0.7, 5.9}, {6.1, 8.3, 7.2, 7.6}, {4.0, 2.5, 4.4}};

std::vector<MeanDifference> compared(const Groups& groups, const PairFamily& family = {}) {
  return studentized_bootstrap(groups, family, {});
}

bool says(const MeanDifference& pair, std::string_view words) {
  return std::isnan(pair.p) && std::isnan(pair.difference.low) &&
         ikbench::samples::says(pair.undefined, std::string(words));
}

Groups in_units(Groups groups, double factor) {
  for (auto& group : groups) {
    for (double& value : group) value *= factor;
  }
  return groups;
}

double normal(std::mt19937_64& engine) {
  const auto uniform = [&] { return (static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53; };
  const double radius = std::sqrt(-2 * std::log(uniform()));
  return radius * std::cos(2 * 3.14159265358979 * uniform());
}

}  // namespace

// Shares of all resamples (800000 of two groups, 1769472 of three), enumerated by a script in Python; ten thousand
// drawn ones have a standard error of sqrt(p (1 - p) / 10000), four times which is allowed.
TEST_CASE("ten thousand resamples of two groups come close to all 800000", "[studentized_bootstrap]") {
  CHECK(compared(two)[0].p == Approx(0.038215).margin(0.0077));
  CHECK(compared(two)[0].difference.value == Approx(2.68 - 8.525));
  // 6.1 - 5.9 - 1.2 = -1.0: a value that is not positive, so the means themselves are compared.
  CHECK(compared({{-1.2, 3.4, 0.7, 5.9, 2.2}, two[1]})[0].p == Approx(0.01992125).margin(0.0056));
}

TEST_CASE("of three groups, p is of the most unusual deviation of any pair of the family", "[studentized_bootstrap]") {
  const auto pairs = compared(three);
  REQUIRE(pairs.size() == 3);
  CHECK(pairs[0].p == Approx(0.228242).margin(0.0168));
  CHECK(pairs[1].p == Approx(0.818627).margin(0.0154));
  CHECK(pairs[2].p == Approx(0.141448).margin(0.0139));
  const auto with_control = compared(three, {.control = 0});
  REQUIRE(with_control.size() == 2);
  CHECK(with_control[0].p == Approx(0.131732).margin(0.0135));
  CHECK(with_control[1].p == Approx(0.653852).margin(0.019));
  const auto shown = compared(three, {.only_with = 2});  // of all pairs
  REQUIRE(shown.size() == 2);
  CHECK(shown[0].p == pairs[1].p);
  CHECK(shown[1].p == pairs[2].p);
}

TEST_CASE("within blocks ten thousand resamples come close to all 46656 of six", "[studentized_bootstrap]") {
  // Enumerated by a script in Python: p of the difference of two groups, and of the three pairs of three together.
  const Groups blocks{{1.2, 3.4, 0.7, 5.9, 2.2, 4.1}, {1.9, 4.6, 0.9, 7.7, 2.4, 5.6}, {1.3, 3.1, 1.5, 6.4, 1.9, 5.0}};
  const auto alone = bootstrap_within_blocks(std::span(blocks).first(2), {}, {});
  REQUIRE(alone.size() == 1);
  CHECK(alone[0].p == Approx(0.036137).margin(0.0075));
  CHECK(alone[0].difference.value == Approx(-5.6 / 6));
  CHECK(alone[0].difference.high < 0);
  const auto together = bootstrap_within_blocks(blocks, {}, {});
  CHECK(together[0].p == Approx(0.091692).margin(0.0115));
  CHECK(together[1].p == Approx(0.464163).margin(0.02));
  CHECK(together[2].p == Approx(0.219264).margin(0.0166));
  CHECK(bootstrap_within_blocks(blocks, {.control = 0}, {}).size() == 2);
  CHECK(bootstrap_within_blocks(blocks, {.only_with = 2}, {})[1].p == together[2].p);
}

TEST_CASE("a pair that a rare value decides does not hide what others show", "[studentized_bootstrap]") {
  // The first two groups differ in one block of fifty, by much. The third is larger in every block.
  Groups groups(3, std::vector<double>(50, 1.0));
  for (std::size_t i = 0; i < 50; ++i) {
    const double wave = 0.01 * std::sin(static_cast<double>(i));
    for (Groups::value_type& group : groups) group[i] += wave * static_cast<double>(&group - groups.data());
    groups[2][i] += 0.1;
  }
  groups[1][7] += 40;
  const auto pairs = bootstrap_within_blocks(groups, {}, {});
  CHECK(pairs[1].p < 0.001);
  CHECK(pairs[1].difference.high < 0);
}

TEST_CASE("what is common to a block has no say in what is compared within it", "[studentized_bootstrap]") {
  const Groups plain{{1, 3, 2, 5, 4, 6, 2.5, 3.5}, {1.5, 3.25, 2.75, 5.75, 4.25, 6.5, 3.5, 3.75}};
  Groups shifted = plain;
  for (std::size_t i = 0; i < 8; ++i) {
    for (auto& group : shifted) group[i] += 64 * static_cast<double>(i);
  }
  const auto one = bootstrap_within_blocks(plain, {}, {}), other = bootstrap_within_blocks(shifted, {}, {});
  CHECK(one[0].p == other[0].p);
  CHECK(one[0].p < 0.05);
  CHECK(compared(plain)[0].p > 0.05);  // without the blocks
}

TEST_CASE("within blocks a pair that cannot be resampled says why", "[studentized_bootstrap]") {
  const auto of = [](Groups groups) { return bootstrap_within_blocks(groups, {}, {})[0]; };
  CHECK(says(of({{1, 2}, {3, 5}}), "group 1 has fewer than 3 values"));
  CHECK(says(of({{1, 2, 3}, {3, 5, HUGE_VAL}}), "group 2 has values that are not finite"));
  CHECK(says(of({{1, 2, 3, 4}, {2, 3, 4, 5}}), "the differences within blocks are all equal"));
  CHECK(says(
      of({{1, 2, 3}, {3, 5, 9}}),
      "too few different differences within blocks: the bootstrap needs 4"));  // 3^-2 of the resamples have no spread
  CHECK(fewest_blocks(1, 0.95) == 4);                                          // 4^-3 is below 0.025
  CHECK(fewest_blocks(15, 0.95) == 5);                                         // 5^-4 is below 0.025 / 15
}

TEST_CASE("an interval excludes 0 where p is below the level, whatever the scale", "[studentized_bootstrap]") {
  std::mt19937_64 engine(11);
  int excluded = 0;
  for (int set = 0; set < 100; ++set) {
    Groups groups{{}, {}, {}};
    for (std::size_t g = 0; g < groups.size(); ++g) {
      for (int i = 0; i < 8; ++i) groups[g].push_back((set % 2 == 0 ? 5 : 0) + static_cast<double>(g) + normal(engine));
    }
    for (const MeanDifference& pair : studentized_bootstrap(groups, {}, {.resamples = 999})) {
      REQUIRE(pair.undefined.empty());
      CAPTURE(set, pair.difference.low, pair.difference.value, pair.difference.high, pair.p);
      CHECK((pair.difference.low > 0 || pair.difference.high < 0) == (pair.p < 0.05));
      CHECK(pair.difference.low < pair.difference.value);
      CHECK(pair.difference.value < pair.difference.high);
      excluded += pair.p < 0.05 ? 1 : 0;
    }
  }
  CHECK(excluded > 20);
  CHECK(excluded < 280);
}

TEST_CASE("the unit of the values changes no p, and scales the interval", "[studentized_bootstrap]") {
  const auto one = compared(two)[0];
  for (const double factor : {0x1p-600, 0x1p600}) {
    const auto other = compared(in_units(two, factor))[0];
    CHECK(other.p == one.p);
    CHECK(other.difference.low == Approx(one.difference.low * factor).epsilon(1e-9));
    CHECK(other.difference.high == Approx(one.difference.high * factor).epsilon(1e-9));
  }
}

TEST_CASE("neither the order of the groups nor that of their values changes a pair", "[studentized_bootstrap]") {
  const MeanDifference one = compared(three)[1];  // the first and the third
  for (Groups other : {Groups{three[1], three[0], three[2]}, Groups{three[2], three[1], three[0]}}) {
    for (auto& group : other) std::ranges::reverse(group);
    const auto pairs = compared(other);
    const auto found = std::ranges::find_if(
        pairs, [&](const MeanDifference& pair) { return std::abs(pair.difference.value) == Approx(0.8333333333); });
    REQUIRE(found != pairs.end());
    const double sign = found->difference.value * one.difference.value > 0 ? 1 : -1;
    CHECK(found->p == one.p);
    CHECK(sign * (sign > 0 ? found->difference.low : found->difference.high) == Approx(one.difference.low));
    CHECK(sign * (sign > 0 ? found->difference.high : found->difference.low) == Approx(one.difference.high));
  }
}

TEST_CASE("groups keep their digits beside one that is larger by any power of ten", "[studentized_bootstrap]") {
  // Two groups of which one value is below 0, so that means are compared, and the same ones beside a third.
  const Groups tiny = in_units({{-1.2, 3.4, 0.7, 5.9, 2.2}, two[1]}, 1e-290);
  const auto alone = compared(tiny)[0];
  const auto beside = compared({tiny[0], tiny[1], {1e300, 2e300, 3e300, 1.5e300, 2.5e300, 4e300}});
  REQUIRE(beside[0].undefined.empty());
  CHECK(beside[0].p >= alone.p);  // of three pairs
  CHECK(beside[0].p < 0.2);
  CHECK(beside[0].difference.value == alone.difference.value);
  CHECK(beside[1].undefined.empty());
  // A constant has no unit either.
  CHECK(compared({tiny[0], std::vector<double>(5, 1.0)})[0].p <= 0.05);
}

TEST_CASE("groups that the bootstrap learns nothing of are refused with the reason", "[studentized_bootstrap]") {
  const std::vector<double> good{1, 2, 3, 5, 4}, other{2, 4, 1, 7, 3};
  const auto pairs = compared({good, {1, 2}, other, {1, 2, HUGE_VAL}, {7, 7, 7}, {8, 8, 8}});
  CHECK(says(pairs[0], "group 2 has fewer than 3 values"));
  CHECK(pairs[1].p <= 1);
  CHECK(says(pairs[2], "group 4 has values that are not finite"));
  CHECK(says(pairs.back(), "both groups are constant"));
  const Groups of_three{{1, 2, 3}, {2, 3, 5}, {3, 5, 8}, {9, 11, 14}};  // each has no spread in 3 of 27 resamples
  CHECK(says(compared(of_three)[0],                                     // 4^-6 < 0.025 / 6
             "too few different values: the bootstrap of 6 pairs needs 4 in each group"));
  CHECK(compared({of_three[0], of_three[3]})[0].undefined.empty());
  // One value of twenty differs: no spread in a third of its resamples, and none in the group that it is held against.
  std::vector<double> nearly_constant(20, 5), constant(20, 6);
  nearly_constant[0] = 5.5;
  const auto beside = compared({nearly_constant, constant, good, other});
  CHECK(
      says(beside[0],  // 5^-4 < 0.025 / 6
           "group 2 are all equal, and the other group has too few different ones: the bootstrap of 6 pairs needs 5"));
  for (std::size_t i = 1; i < beside.size(); ++i) CHECK(beside[i].p <= 1);
  CHECK(compared({}).empty());
  CHECK_THROWS_AS(studentized_bootstrap(two, {}, {.level = 1}), std::invalid_argument);
  CHECK_THROWS_AS(studentized_bootstrap(two, {}, {.resamples = 1}), std::invalid_argument);
}

TEST_CASE("the more values and groups, the fewer resamples, and none of too many", "[studentized_bootstrap]") {
  CHECK(affordable_resamples(120, 6, 0.95) == 9999);
  CHECK(affordable_resamples(120, 6, 0.999) == 60000);
  CHECK(affordable_resamples(20000, 6, 0.95) == 2500);  // 5e7 / (20000 + 15 / 4)
  CHECK(affordable_resamples(60000, 6, 0.95) == 0);
  CHECK(affordable_resamples(2000, 1000, 0.95) == 0);
}
