#include "analysis/statistics/equal_variances.hpp"

#include <cmath>

#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

namespace {

// NIST/SEMATECH e-Handbook of Statistical Methods, 1.3.5.10.1: gear diameters, ten batches.
const Groups gears{{1.006, 0.996, 0.998, 1.000, 0.992, 0.993, 1.002, 0.999, 0.994, 1.000},
                   {0.998, 1.006, 1.000, 1.002, 0.997, 0.998, 0.996, 1.000, 1.006, 0.988},
                   {0.991, 0.987, 0.997, 0.999, 0.995, 0.994, 1.000, 0.999, 0.996, 0.996},
                   {1.005, 1.002, 0.994, 1.000, 0.995, 0.994, 0.998, 0.996, 1.002, 0.996},
                   {0.998, 0.998, 0.982, 0.990, 1.002, 0.984, 0.996, 0.993, 0.980, 0.996},
                   {1.009, 1.013, 1.009, 0.997, 0.988, 1.002, 0.995, 0.998, 0.981, 0.996},
                   {0.990, 1.004, 0.996, 1.001, 0.998, 1.000, 1.018, 1.010, 0.996, 1.002},
                   {0.998, 1.000, 1.006, 1.000, 1.002, 0.996, 0.998, 0.996, 1.002, 1.006},
                   {1.002, 0.998, 0.996, 0.995, 0.996, 1.004, 1.004, 0.998, 0.999, 0.991},
                   {0.991, 0.995, 0.984, 0.994, 0.997, 0.997, 0.991, 0.998, 1.004, 0.997}};

std::vector<GroupSummary> summaries_of(const Groups& groups) {
  std::vector<GroupSummary> summaries;
  for (const auto& group : groups) summaries.push_back(summarise(group));
  return summaries;
}

Groups scaled(Groups groups, double factor) {
  for (auto& group : groups) {
    for (double& value : group) value *= factor;
  }
  return groups;
}

}  // namespace

TEST_CASE("Bartlett's test of the gears is NIST's, that of PlantGrowth R's", "[equal_variances]") {
  CHECK(bartlett(summaries_of(gears)).statistic ==
        Approx(20.78587342806484).epsilon(1e-10));  // NIST: 20.78580; R 4.2.2, all digits
  CHECK(bartlett(summaries_of(gears)).p == Approx(0.0136358632781).epsilon(1e-9));
  CHECK(bartlett(summaries_of(gears)).df == 9);
  CHECK(bartlett(summaries_of(plant_growth)).statistic ==
        Approx(2.8785737872361).epsilon(1e-12));  // R 4.2.2, bartlett.test
  CHECK(bartlett(summaries_of(plant_growth)).p == Approx(0.2370967736346).epsilon(1e-12));
}

TEST_CASE("Brown and Forsythe's test of the gears is NIST's, that of PlantGrowth R's", "[equal_variances]") {
  CHECK(brown_forsythe(gears).statistic ==
        Approx(1.7059176930008939).epsilon(1e-10));  // NIST: 1.705910; R 4.2.2, all digits
  CHECK(brown_forsythe(gears).p == Approx(0.0990829755522).epsilon(1e-9));
  CHECK(brown_forsythe(gears).df_within == 90);
  CHECK(brown_forsythe(plant_growth).statistic == Approx(1.11919).epsilon(1e-5));  // R 4.2.2, car::leveneTest
  CHECK(brown_forsythe(plant_growth).p == Approx(0.34123).epsilon(1e-5));
}

TEST_CASE("Bartlett's test needs only means, deviations and counts", "[equal_variances]") {
  std::vector<GroupSummary> summaries = summaries_of(plant_growth);
  for (GroupSummary& summary : summaries) summary.mean = not_defined;  // not even means
  CHECK(bartlett(summaries).p == bartlett(summaries_of(plant_growth)).p);
}

TEST_CASE("equal variances have p = 1", "[equal_variances]") {
  CHECK(bartlett(summaries_of(Groups{{1, 2, 3}, {5, 6, 7}})).p == Approx(1));
  CHECK(brown_forsythe(Groups{{1, 2, 4}, {5, 6, 8}}).p == Approx(1));
}

TEST_CASE("neither test knows the unit, however large or small", "[equal_variances]") {
  const double factor = GENERATE(1e-140, 1e-9, 1e140);
  CHECK(bartlett(summaries_of(scaled(plant_growth, factor))).p == Approx(0.2370967736346).epsilon(1e-10));
  CHECK(brown_forsythe(scaled(plant_growth, factor)).p == Approx(0.34123).epsilon(1e-5));
}

TEST_CASE("where variances cannot be compared the tests say why", "[equal_variances]") {
  CHECK(says(bartlett({}).undefined, "no group"));
  CHECK(says(bartlett(summaries_of(Groups{{1, 2}})).undefined, "one group"));
  CHECK(says(bartlett(summaries_of(Groups{{1, 2}, {1}})).undefined, "group 2 has fewer than two values"));
  CHECK(says(bartlett(summaries_of(Groups{{1, 2}, {}})).undefined, "group 2 has fewer than two values"));
  CHECK(says(bartlett(summaries_of(Groups{{1, 2}, {3, 3}})).undefined, "group 2 is constant"));
  CHECK(says(bartlett(summaries_of(Groups{{1, HUGE_VAL}, {3, 4}})).undefined, "group 1 is not defined"));
  CHECK(bartlett(summaries_of(Groups{{1e308, -1e308}, {3, 4}})).p < 1e-100);
  CHECK(says(bartlett(summaries_of(Groups{{3, 4}, {1.7e308, -1.7e308, 1.7e308}})).undefined, "group 2 is too large"));
  CHECK(std::isnan(bartlett(summaries_of(Groups{{1, 2}, {3, 3}})).p));

  CHECK(says(brown_forsythe({}).undefined, "no group"));
  CHECK(says(brown_forsythe(Groups{{1, 2}, {}}).undefined, "group 2 has no values"));
  CHECK(says(brown_forsythe(Groups{{1}, {2}}).undefined, "single value"));
  CHECK(says(brown_forsythe(Groups{{1, 1}, {2, 2}}).undefined, "constant"));
  CHECK(says(brown_forsythe(Groups{{1, NAN}, {2, 2}}).undefined, "not finite"));
  CHECK(says(brown_forsythe(Groups{{1.7e308, 1.7e308, -1.7e308}, {2, 3}}).undefined, "too large"));
  CHECK(std::isnan(brown_forsythe(Groups{{1, 1}, {2, 2}}).p));
}
