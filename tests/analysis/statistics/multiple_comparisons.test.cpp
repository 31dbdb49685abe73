#include "analysis/statistics/multiple_comparisons.hpp"

#include <cmath>
#include <stdexcept>

#include "analysis/statistics/anova.hpp"
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

TEST_CASE("Tukey's test of PlantGrowth is that of R", "[multiple_comparisons]") {
  // R 4.2.2, TukeyHSD(aov(weight ~ group)); the differences there are treatment less control.
  const auto pairs = tukey(summaries(plant_growth), 0.95);
  REQUIRE(pairs.size() == 3);
  CHECK(pairs[0].p == Approx(0.390871144202).epsilon(1e-7));
  CHECK(pairs[1].p == Approx(0.197995991300).epsilon(1e-7));
  CHECK(pairs[2].p == Approx(0.012006423979).epsilon(1e-7));
  CHECK(pairs[2].first == 1);
  CHECK(pairs[2].second == 2);
  CHECK(pairs[2].df == 27);
  CHECK(pairs[2].difference.low == Approx(-1.55621605141).epsilon(1e-6));
  CHECK(pairs[2].difference.high == Approx(-0.17378394859).epsilon(1e-5));
}

TEST_CASE("Games-Howell of PlantGrowth is that of R's rstatix", "[multiple_comparisons]") {
  const auto pairs = games_howell(summaries(plant_growth), 0.95);
  const std::vector<double> p{0.474554922194, 0.112889176854, 0.0237034547392};
  const std::vector<double> q{1.68469658833, 3.01796066719, 4.25692218235};
  const std::vector<double> df{16.5235850569, 16.7857644826, 14.1035691228};
  REQUIRE(pairs.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(pairs[i].p == Approx(p[i]).epsilon(1e-7));
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

TEST_CASE("Games-Howell of Table 3 tells IK-BA's error from every other algorithm's", "[multiple_comparisons][paper]") {
  // mpmath 1.3.0, thirty digits, on the printed means and standard deviations. R 4.2.2's ptukey has 2.7e-13 for the
  // last: it takes 1 - cdf.
  const auto pairs = games_howell(table_3_error, 0.95, 0);
  const std::vector<double> p{1.29522898597268e-6, 2.96792173726569e-4, 1.43727808544199e-4, 1.89365980805599e-10,
                              3.21748856382838e-13};
  REQUIRE(pairs.size() == 5);
  for (std::size_t i = 0; i < p.size(); ++i) CHECK(pairs[i].p == Approx(p[i]).epsilon(1e-9).margin(0));
}

TEST_CASE("on Table 3 pooling hides what Games-Howell finds", "[multiple_comparisons][paper]") {
  // The audit of the paper: pooled p of IK-BA against DE 0.07 and K-ABC 0.50; in variation IK-BA and MO-PSO p = 0.997.
  const auto error = tukey(table_3_error, 0.95, 0);
  CHECK(error[1].p == Approx(0.07).margin(0.005));
  CHECK(error[3].p == Approx(0.50).margin(0.005));
  CHECK(games_howell(table_3_variation, 0.95)[4].p == Approx(0.997).margin(0.0005));
}

TEST_CASE("two groups compared by Games-Howell are Welch's test, by Tukey Student's", "[multiple_comparisons]") {
  const std::vector<GroupSummary> groups{{0.75, 1.789010, 10}, {2.33, 2.002249, 12}};
  CHECK(games_howell(groups, 0.95)[0].p == Approx(welch_anova(groups).p).epsilon(1e-11));
  CHECK(tamhane(groups, 0.95)[0].p == Approx(welch_anova(groups).p).epsilon(1e-11));
  for (const auto method : {tukey, games_howell, tamhane}) {  // of two groups nothing is corrected
    CHECK(method(groups, 0.95, std::nullopt)[0].p_alone ==
          Approx(method(groups, 0.95, std::nullopt)[0].p).epsilon(1e-9));
  }
  CHECK(games_howell(groups, 0.95)[0].df == Approx(welch_anova(groups).df_within).epsilon(1e-12));
  // One-way analysis of variance of two groups is the square of Student's t.
  CHECK(tukey(groups, 0.95)[0].p == Approx(anova_from_summaries(groups).p).epsilon(1e-11));
}

TEST_CASE("an interval leaves out zero exactly where p is below one less the level", "[multiple_comparisons]") {
  const auto groups = summaries(plant_growth);
  for (const auto method : {tukey, games_howell, tamhane}) {
    for (const MeanDifference& pair : method(groups, 0.95, std::nullopt)) {
      const auto at_p = method(groups, 1 - pair.p, std::nullopt);
      for (const MeanDifference& same : at_p) {
        if (same.first != pair.first || same.second != pair.second) continue;
        CHECK(std::min(std::abs(same.difference.low), std::abs(same.difference.high)) < 1e-9);
      }
      CHECK((pair.difference.low > 0 || pair.difference.high < 0) == (pair.p < 0.05));
    }
  }
}

TEST_CASE("pairs with one group carry the correction for all groups", "[multiple_comparisons]") {
  for (const auto method : {tukey, games_howell, tamhane}) {
    const auto all = method(table_3_error, 0.95, std::nullopt);
    REQUIRE(all.size() == 15);
    const auto some = method(table_3_error, 0.95, 2);
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
}

TEST_CASE("the unit of measurement changes no p, however large or small", "[multiple_comparisons]") {
  const double unit = GENERATE(1e-250, 1e-3, 1e250);
  std::vector<GroupSummary> scaled = summaries(plant_growth);
  for (GroupSummary& group : scaled) {
    group.mean *= unit;
    group.std *= unit;
  }
  for (const auto method : {tukey, games_howell, tamhane}) {
    const auto expected = method(summaries(plant_growth), 0.95, std::nullopt);
    const auto pairs = method(scaled, 0.95, std::nullopt);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      CHECK(pairs[i].undefined.empty());
      CHECK(pairs[i].p == Approx(expected[i].p).epsilon(1e-9));
    }
  }
}

TEST_CASE("a constant group is compared with one that varies", "[multiple_comparisons]") {
  const auto pair = games_howell(std::vector<GroupSummary>{{2, 2, 4}, {1, 0, 20}}, 0.95)[0];
  CHECK(pair.df == Approx(3));
  CHECK(pair.p == Approx(0.391002).epsilon(1e-5));  // t = 1 on 3 degrees of freedom (t table)
}

TEST_CASE("a group of one value takes part in Tukey's test with the spread of the others", "[multiple_comparisons]") {
  // Groups 1 2 3 and 5: the same as the analysis of variance, F = 6.75 on 1 and 2.
  const auto pair = tukey(std::vector<GroupSummary>{{2, 1, 3}, {5, not_defined, 1}}, 0.95)[0];
  CHECK(pair.q * pair.q / 2 == Approx(6.75));
  CHECK(pair.df == 2);
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
  CHECK(tukey({}, 0.95).empty());
  CHECK(games_howell(Summaries{good}, 0.95).empty());
  says(games_howell(Summaries{constant, constant}, 0.95), 0, "both groups are constant");
  says(tukey(Summaries{constant, constant}, 0.95), 0, "every group is constant");
  says(tukey(Summaries{single, single}, 0.95), 0, "single value");
  says(tukey(Summaries{good, good, lost}, 0.95), 0, "group 3 has values that are not finite");
  says(tukey(Summaries{good, empty}, 0.95), 0, "group 2 has no values");
  says(tukey(Summaries{good, {1, HUGE_VAL, 5}}, 0.95), 0, "spread of group 2 is too large");
  says(tukey(Summaries{{1e308, 1, 5}, {-1e308, 1, 5}}, 0.95), 0, "too large");
  const auto mixed = games_howell(Summaries{good, single, good, lost}, 0.95);
  says(mixed, 0, "group 2 has a single value");
  says(mixed, 2, "group 4 has values that are not finite");
  CHECK(mixed[1].undefined.empty());
  CHECK(mixed[1].p == Approx(1));
  says(games_howell(Summaries(1001, good), 0.95, 0), 0, "1000 at most");
  CHECK_THROWS_AS(tukey(Summaries{good, good}, 1.0), std::invalid_argument);
  CHECK_THROWS_AS(games_howell(Summaries{good, good}, not_defined), std::invalid_argument);
  CHECK_THROWS_AS(games_howell(Summaries{good, good}, 0.95, 2), std::invalid_argument);
}

TEST_CASE("two hundred groups are compared with one of them", "[multiple_comparisons]") {
  std::vector<GroupSummary> groups;
  for (int i = 0; i < 200; ++i) groups.push_back({.mean = i * 0.01, .std = 1.0 + i % 7, .n = 10 + i % 13});
  const auto pairs = games_howell(groups, 0.95, 7);
  REQUIRE(pairs.size() == 199);
  for (const MeanDifference& pair : pairs) CHECK((pair.undefined.empty() && pair.p > 0 && pair.p <= 1));
}
