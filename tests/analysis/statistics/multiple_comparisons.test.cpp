#include "analysis/statistics/multiple_comparisons.hpp"

#include <cmath>
#include <stdexcept>

#include "analysis/statistics/studentized_range.hpp"
#include "analysis/statistics/welch.hpp"
#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using samples::plant_growth;

namespace {

std::vector<GroupSummary> summaries(const std::vector<std::vector<double>>& groups) {
  std::vector<GroupSummary> result;
  for (const auto& group : groups) result.push_back(summarise(group));
  return result;
}

// The paper's Table 3, position error: IK-BA, BA, DE, PSO, K-ABC, MO-PSO.
const std::vector<GroupSummary> table_3_error{{0.0019, 1.7824e-4, 20}, {1.6849, 0.9069, 20}, {0.3653, 0.2929, 20},
                                              {0.4382, 0.3312, 20},    {0.2318, 0.0722, 20}, {0.4075, 0.0891, 20}};
const std::vector<GroupSummary> table_3_variation{{87.1916, 7.8247, 20},   {301.5794, 25.2466, 20},
                                                  {303.6915, 32.8049, 20}, {274.7692, 21.9459, 20},
                                                  {276.6456, 20.9967, 20}, {89.9602, 25.6630, 20}};

}  // namespace

TEST_CASE("Games and Howell's q and df of PlantGrowth are those of R's rstatix", "[multiple_comparisons]") {
  const auto pairs = tamhane(summaries(plant_growth), 0.95);
  const std::vector<double> p{0.474554922194, 0.112889176854, 0.0237034547392};
  const std::vector<double> q{1.68469658833, 3.01796066719, 4.25692218235};
  const std::vector<double> df{16.5235850569, 16.7857644826, 14.1035691228};
  REQUIRE(pairs.size() == 3);
  CHECK(pairs[2].first == 1);
  CHECK(pairs[2].second == 2);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(StudentizedRange(3).upper_tail(pairs[i].q, pairs[i].df) == Approx(p[i]).epsilon(1e-7));
    CHECK(pairs[i].q == Approx(q[i]).epsilon(1e-11));
    CHECK(pairs[i].df == Approx(df[i]).epsilon(1e-11));
  }
}

TEST_CASE("Tamhane's T2 of PlantGrowth is Welch's test of each pair, corrected", "[multiple_comparisons]") {
  // mpmath, thirty digits: 1 - (1 - p)^3 of Welch's p, and t at 1 - 0.95^(1/3).
  const auto pairs = tamhane(summaries(plant_growth), 0.95);
  REQUIRE(pairs.size() == 3);
  CHECK(pairs[0].p == Approx(0.5787701540936).epsilon(1e-10));
  CHECK(pairs[1].p == Approx(0.1369246478595).epsilon(1e-10));
  CHECK(pairs[2].p == Approx(0.02763663710409).epsilon(1e-10));
  CHECK(pairs[2].df == Approx(14.10356912).epsilon(1e-9));
  CHECK(pairs[2].difference.low == Approx(-1.64273819708).epsilon(1e-9));
  CHECK(pairs[2].difference.high == Approx(-0.0872618029195).epsilon(1e-9));
}

TEST_CASE("Tamhane's T2 of Table 3 tells IK-BA's error from every other algorithm's", "[multiple_comparisons][paper]") {
  // mpmath, thirty digits, as above with fifteen pairs
  const std::vector<double> expected{1.45078409017e-6, 0.0003554925215022, 0.0001697625047371, 2.052290899952e-10,
                                     3.458828158826e-13};
  const auto pairs = tamhane(table_3_error, 0.95, 0);
  REQUIRE(pairs.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) CHECK(pairs[i].p == Approx(expected[i]).epsilon(1e-8));
}

TEST_CASE("two groups are compared by Welch's test, uncorrected", "[multiple_comparisons]") {
  const std::vector<GroupSummary> groups{{0.75, 1.789010, 10}, {2.33, 2.002249, 12}};
  const MeanDifference pair = tamhane(groups, 0.95)[0];
  CHECK(pair.p == Approx(welch_anova(groups).p).epsilon(1e-11));
  CHECK(pair.p_alone == Approx(pair.p).epsilon(1e-9));
  CHECK(pair.df == Approx(welch_anova(groups).df_within).epsilon(1e-12));
}

TEST_CASE("an interval leaves out zero exactly where p is below one less the level", "[multiple_comparisons]") {
  const auto groups = summaries(plant_growth);
  for (const MeanDifference& pair : tamhane(groups, 0.95)) {
    const auto at_p = tamhane(groups, 1 - pair.p);
    for (const MeanDifference& same : at_p) {
      if (same.first != pair.first || same.second != pair.second) continue;
      CHECK(std::min(std::abs(same.difference.low), std::abs(same.difference.high)) < 1e-9);
    }
    CHECK((pair.difference.low > 0 || pair.difference.high < 0) == (pair.p < 0.05));
  }
}

TEST_CASE("pairs with one group carry the correction for all groups", "[multiple_comparisons]") {
  const auto all = tamhane(table_3_error, 0.95);
  REQUIRE(all.size() == 15);
  const auto some = tamhane(table_3_error, 0.95, 2);
  REQUIRE(some.size() == 5);
  std::size_t found = 0;
  for (const MeanDifference& pair : all) {
    if (pair.first != 2 && pair.second != 2) continue;
    CHECK(some[found].first == pair.first);
    CHECK(some[found].second == pair.second);
    CHECK(some[found].p == pair.p);
    ++found;
  }
}

TEST_CASE("the unit of measurement changes no p, however large or small", "[multiple_comparisons]") {
  const double unit = GENERATE(1e-250, 1e-3, 1e250);
  std::vector<GroupSummary> scaled = summaries(plant_growth);
  for (GroupSummary& group : scaled) {
    group.mean *= unit;
    group.std *= unit;
  }
  const auto expected = tamhane(summaries(plant_growth), 0.95);
  const auto pairs = tamhane(scaled, 0.95);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    CHECK(pairs[i].undefined.empty());
    CHECK(pairs[i].p == Approx(expected[i].p).epsilon(1e-9));
  }
}

TEST_CASE("a constant group is compared with one that varies", "[multiple_comparisons]") {
  const auto pair = tamhane(std::vector<GroupSummary>{{2, 2, 4}, {1, 0, 20}}, 0.95)[0];
  CHECK(pair.df == Approx(3));
  CHECK(pair.p == Approx(0.391002).epsilon(1e-5));  // t = 1 on 3 degrees of freedom (t table)
}

TEST_CASE("a pair without a p says why", "[multiple_comparisons]") {
  using Summaries = std::vector<GroupSummary>;
  const GroupSummary good{1, 1, 5}, constant{2, 0, 5}, single{1, not_defined, 1}, empty{},
      lost{not_defined, not_defined, 5};
  const auto says = [](const std::vector<MeanDifference>& pairs, std::size_t i, const std::string& reason) {
    CAPTURE(pairs[i].undefined, reason);
    CHECK(std::isnan(pairs[i].p));
    CHECK(std::isnan(pairs[i].difference.low));
    CHECK(ikbench::samples::says(pairs[i].undefined, reason));
  };
  CHECK(tamhane({}, 0.95).empty());
  CHECK(tamhane(Summaries{good}, 0.95).empty());
  says(tamhane(Summaries{constant, constant}, 0.95), 0, "both groups are constant");
  says(tamhane(Summaries{good, empty}, 0.95), 0, "group 2 has no values");
  says(tamhane(Summaries{good, {1, HUGE_VAL, 5}}, 0.95), 0, "spread of group 2 is too large");
  says(tamhane(Summaries{{1e308, 1, 5}, {-1e308, 1, 5}}, 0.95), 0, "too large");
  const auto mixed = tamhane(Summaries{good, single, good, lost}, 0.95);
  says(mixed, 0, "group 2 has a single value");
  says(mixed, 2, "group 4 has values that are not finite");
  CHECK(mixed[1].undefined.empty());
  CHECK(mixed[1].p == Approx(1));
  CHECK_THROWS_AS(tamhane(Summaries{good, good}, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(tamhane(Summaries{good, good}, not_defined), std::invalid_argument);
  CHECK_THROWS_AS(tamhane(Summaries{good, good}, 0.95, 2), std::invalid_argument);
}

TEST_CASE("two hundred groups are compared with one of them", "[multiple_comparisons]") {
  std::vector<GroupSummary> groups;
  for (int i = 0; i < 200; ++i) groups.push_back({.mean = i * 0.01, .std = 1.0 + i % 7, .n = 10 + i % 13});
  const auto pairs = tamhane(groups, 0.95, 7);
  REQUIRE(pairs.size() == 199);
  for (const MeanDifference& pair : pairs) CHECK((pair.undefined.empty() && pair.p > 0 && pair.p <= 1));
}
