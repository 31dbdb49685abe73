#include "analysis/statistics/log_rank.hpp"

#include <cmath>
#include <vector>

#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

using Costs = std::vector<CensoredCost>;

TEST_CASE("the remissions of leukaemia: 6-mercaptopurine against placebo", "[log_rank]") {
  // Freireich et al., Blood 21 (1963) 699. R's survdiff: 16.8 on 1, expected 19.3 and 10.7; all digits from exact
  // fractions.
  const Costs drug{{6, true},   {6, true},   {6, true},   {6, false},  {7, true},   {9, false},  {10, true},
                   {10, false}, {11, false}, {13, true},  {16, true},  {17, false}, {19, false}, {20, false},
                   {22, true},  {23, true},  {25, false}, {32, false}, {32, false}, {34, false}, {35, false}};
  Costs placebo;
  for (const double week : {1, 1, 2, 2, 3, 4, 4, 5, 5, 8, 8, 8, 8, 11, 11, 12, 12, 15, 17, 22, 23}) {
    placebo.push_back({week, true});
  }
  const LogRank test = log_rank(std::vector<Costs>{drug, placebo});
  CHECK(test.chi_squared == Approx(16.792940989216532).epsilon(1e-12));
  CHECK(test.df == 1);
  CHECK(test.p == Approx(std::erfc(std::sqrt(16.792940989216532 / 2))).epsilon(1e-10));
  CHECK(test.observed == std::vector<double>{9, 21});
  CHECK(test.expected[0] == Approx(19.25050094803113).epsilon(1e-12));
  CHECK(test.expected[1] == Approx(10.74949905196887).epsilon(1e-12));
}

TEST_CASE("R's ovarian cancer data, treatments 1 and 2", "[log_rank]") {
  // R survival, help page of survdiff: observed 7 5, expected 5.23 6.77, chi-square 1.06 on 1 degree of freedom, p
  // 0.303.
  const Costs one{{59, true},   {115, true},  {156, true},   {431, true},   {448, false}, {477, false}, {638, true},
                  {803, false}, {855, false}, {1040, false}, {1106, false}, {268, true},  {329, true}};
  const Costs two{{421, false},  {464, true},   {475, true},   {563, true}, {744, false}, {769, false}, {770, false},
                  {1129, false}, {1206, false}, {1227, false}, {353, true}, {365, true},  {377, false}};
  const LogRank test = log_rank(std::vector<Costs>{one, two});
  CHECK(test.chi_squared == Approx(1.0627398612914138).epsilon(1e-12));  // exact fractions
  CHECK(test.p == Approx(0.303).margin(0.0005));
  CHECK(test.expected[0] == Approx(5.233531017149943).epsilon(1e-12));
}

TEST_CASE("three groups, in exact fractions by hand", "[log_rank]") {
  // O 2 3 2, E 569/420 1691/840 1017/280, V11 160499/176400, V12 -148499/352800, V22 888319/705600.
  const LogRank test = log_rank(std::vector<Costs>{
      {{1, true}, {3, true}, {5, false}}, {{2, true}, {4, true}, {6, true}}, {{3, true}, {7, false}, {8, true}}});
  CHECK(test.expected[0] == Approx(569.0 / 420));
  CHECK(test.expected[1] == Approx(1691.0 / 840));
  CHECK(test.expected[2] == Approx(1017.0 / 280));
  CHECK(test.chi_squared == Approx(1730455733.0 / 860873987).epsilon(1e-12));
  CHECK(test.df == 2);
  CHECK(test.p == Approx(std::exp(-1730455733.0 / 860873987 / 2)).epsilon(1e-12));
}

TEST_CASE("the log-rank test does not depend on the order of the groups", "[log_rank]") {
  const Costs a{{1, true}, {3, true}, {5, false}}, b{{2, true}, {4, true}}, c{{3, true}, {7, false}, {8, true}};
  CHECK(log_rank(std::vector<Costs>{a, b, c}).chi_squared ==
        Approx(log_rank(std::vector<Costs>{c, a, b}).chi_squared).epsilon(1e-12));
}

TEST_CASE("groups that are alike have chi-square 0", "[log_rank]") {
  const Costs costs{{1, true}, {2, false}, {3, true}};
  CHECK(log_rank(std::vector<Costs>{costs, costs}).chi_squared == Approx(0).margin(1e-15));
  CHECK(log_rank(std::vector<Costs>{costs, costs}).p == Approx(1));
}

TEST_CASE("a group given up before the first success takes no part", "[log_rank]") {
  const Costs early{{1, false}, {2, false}}, a{{3, true}, {5, true}}, b{{4, true}, {6, false}};
  const LogRank with = log_rank(std::vector<Costs>{early, a, b}), without = log_rank(std::vector<Costs>{a, b});
  CHECK(with.df == 1);
  CHECK(with.chi_squared == Approx(without.chi_squared));
  CHECK(with.expected[0] == 0);
}

TEST_CASE("two hundred groups have a log-rank test", "[log_rank]") {
  std::vector<Costs> groups;
  for (int g = 0; g < 200; ++g) groups.push_back({{1.0 + g % 7, true}, {2.0 + g % 5, true}, {9, false}});
  const LogRank test = log_rank(groups);
  CHECK(test.df == 199);
  CHECK(test.p > 0);
}

TEST_CASE("where there is no log-rank test it says why", "[log_rank]") {
  const Costs good{{1, true}, {2, true}};
  const auto why = [](const std::vector<Costs>& groups) {
    CHECK(std::isnan(log_rank(groups).p));
    return log_rank(groups).undefined;
  };
  CHECK(says(why({}), "no group"));
  CHECK(says(why({good}), "one group"));
  CHECK(says(why({good, {}}), "group 2: there are no trials"));
  CHECK(says(why({good, {{NAN, true}}}), "group 2: the cost of trial 1"));
  CHECK(says(why({{{1, false}}, {{2, false}}}), "no trial reached"));
  CHECK(says(why({{{1, false}}, {{2, true}}}), "only one group"));
  CHECK(says(why({{{2, true}}, {{2, true}}}), "at one cost"));
}
