#include <cmath>

#include "analysis/statistics/ranks.hpp"
#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

TEST_CASE("the Kruskal-Wallis test of PlantGrowth is that of R, ties and all", "[kruskal_wallis]") {
  const RankTest test = kruskal_wallis(plant_growth);
  CHECK(test.statistic == Approx(7.9882287494437).epsilon(1e-13));  // R 4.2.2, kruskal.test
  CHECK(test.p == Approx(0.01842375573147).epsilon(1e-12));
  CHECK(test.df == 2);
  CHECK(test.effect == Approx(7.9882287494437 / 29));  // H / (n - 1)
}

TEST_CASE("the Kruskal-Wallis test of the mucociliary data is that of R", "[kruskal_wallis]") {
  // R's help page of kruskal.test (Hollander and Wolfe 1973, p. 116): 0.77143, df 2, p 0.68.
  const Groups groups{{2.9, 3.0, 2.5, 2.6, 3.2}, {3.8, 2.7, 4.0, 2.4}, {2.8, 3.4, 3.7, 2.2, 2.0}};
  const RankTest test = kruskal_wallis(groups);
  CHECK(test.statistic == Approx(0.77142857142857).epsilon(1e-12));  // 12 / (14 * 15) sum R_i^2 / n_i - 3 * 15, by hand
  CHECK(test.p == Approx(std::exp(-0.77142857142857 / 2)).epsilon(1e-12));
}

TEST_CASE("groups that do not overlap at all have the largest H there is", "[kruskal_wallis]") {
  // Mean ranks 2, 5, 8 of 9: H = 12 / 90 * 3 * (9 + 0 + 9) = 7.2.
  const RankTest test = kruskal_wallis(Groups{{1, 2, 3}, {4, 5, 6}, {7, 8, HUGE_VAL}});
  CHECK(test.statistic == Approx(7.2));
  CHECK(test.mean_ranks == std::vector<double>{2, 5, 8});
  CHECK(test.effect == Approx(0.9));
}

TEST_CASE("only the order of the values counts", "[kruskal_wallis]") {
  Groups cubes = plant_growth;
  for (auto& group : cubes) {
    for (double& value : group) value = std::exp(value * value);
  }
  CHECK(kruskal_wallis(cubes).statistic == kruskal_wallis(plant_growth).statistic);
}

TEST_CASE("where there is no H the test says why", "[kruskal_wallis]") {
  const auto [groups, reason] =
      GENERATE_COPY(table<Groups, std::string>({{Groups{}, "no group"},
                                                {Groups{{1, 2}}, "one group"},
                                                {Groups{{1, 2}, {}}, "group 2 has no values"},
                                                {Groups{{1, 2}, {1, NAN}}, "not a number"},
                                                {Groups{{3, 3}, {3}}, "all values are equal"},
                                                {Groups{{HUGE_VAL}, {HUGE_VAL}}, "all values are equal"}}));
  CAPTURE(reason);
  const RankTest test = kruskal_wallis(groups);
  CHECK(says(test.undefined, reason));
  CHECK(std::isnan(test.statistic));
  CHECK(std::isnan(test.p));
}

TEST_CASE("two groups of one value each have H = 1, two hundred are no trouble", "[kruskal_wallis]") {
  CHECK(kruskal_wallis(Groups{{1}, {2}}).statistic == Approx(1));  // 12 / 6 * (0.25 + 0.25)
  Groups many(200);
  for (std::size_t i = 0; i < many.size(); ++i) many[i] = {static_cast<double>(i), static_cast<double>(i) + 0.5};
  CHECK(kruskal_wallis(many).p < 1e-10);
}
