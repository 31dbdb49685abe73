#include "analysis/statistics/survival.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

using Costs = std::vector<CensoredCost>;

namespace {

const Costs evaluations{{120, true},   {340, true}, {80, true},    {1000, false},
                        {1000, false}, {560, true}, {1000, false}, {220, true}};

}  // namespace

TEST_CASE("five of eight trials reach the tolerance, an eighth of them at a time", "[survival]") {
  const SurvivalCurve curve = kaplan_meier(evaluations);
  REQUIRE(curve.steps.size() == 5);
  const std::array<double, 5> costs{80, 120, 220, 340, 560}, survival{0.875, 0.75, 0.625, 0.5, 0.375};
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(curve.steps[i].cost == costs[i]);
    CHECK(curve.steps[i].survival == Approx(survival[i]));
    CHECK(curve.steps[i].at_risk == 8 - static_cast<int>(i));
    CHECK(curve.steps[i].reached == 1);
    // Without censoring before it, Greenwood's is the binomial's.
    CHECK(curve.steps[i].standard_error == Approx(std::sqrt(survival[i] * (1 - survival[i]) / 8)));
  }
  CHECK(curve.median == 340);
  CHECK(curve.last_cost == 1000);
}

TEST_CASE("the restricted mean without earlier censoring is the mean of what was spent", "[survival]") {
  const RestrictedMean mean = restricted_mean(kaplan_meier(evaluations), 1000);
  CHECK(mean.mean == Approx(540));                                         // 4320 / 8
  CHECK(mean.standard_error == Approx(134.9536957626578).epsilon(1e-12));  // sqrt(sum (x - 540)^2) / 8
  // To 200 all but two count as 200: (80 + 120 + 6 * 200) / 8.
  CHECK(restricted_mean(kaplan_meier(evaluations), 200).mean == Approx(175));
  CHECK(restricted_mean(kaplan_meier(evaluations), 50).mean == 50);
  CHECK(restricted_mean(kaplan_meier(evaluations), 50).standard_error == 0);
}

TEST_CASE("the remissions under 6-mercaptopurine have the curve of the textbooks", "[survival]") {
  // Freireich et al., Blood 21 (1963) 699; the curve and Greenwood's errors in Kalbfleisch and Prentice, Statistical
  // Analysis of Failure Time Data (1980), and here from the formulas by a script.
  const SurvivalCurve curve =
      kaplan_meier(Costs{{6, true},   {6, true},   {6, true},   {6, false},  {7, true},   {9, false},  {10, true},
                         {10, false}, {11, false}, {13, true},  {16, true},  {17, false}, {19, false}, {20, false},
                         {22, true},  {23, true},  {25, false}, {32, false}, {32, false}, {34, false}, {35, false}});
  const std::array<double, 7> costs{6, 7, 10, 13, 16, 22, 23};
  const std::array<double, 7> survival{0.8571, 0.8067, 0.7529, 0.6902, 0.6275, 0.5378, 0.4482};
  const std::array<double, 7> errors{0.0764, 0.0869, 0.0963, 0.1068, 0.1141, 0.1282, 0.1346};
  const std::array<int, 7> at_risk{21, 17, 15, 12, 11, 7, 6};
  REQUIRE(curve.steps.size() == 7);
  for (std::size_t i = 0; i < 7; ++i) {
    CHECK(curve.steps[i].cost == costs[i]);
    CHECK(curve.steps[i].survival == Approx(survival[i]).margin(5e-5));
    CHECK(curve.steps[i].standard_error == Approx(errors[i]).margin(5e-5));
    CHECK(curve.steps[i].at_risk == at_risk[i]);
  }
  CHECK(curve.steps[0].reached == 3);
  CHECK(curve.median == 23);
}

TEST_CASE("a censored cost before the horizon weighs on those after it, by hand", "[survival]") {
  // 1 reached, 2 given up, 3 reached, 4 given up: S = 3/4 from 1, 3/8 from 3. Mean to 4: 1 + 2 * 3/4 + 3/8 = 2.875.
  // Variance: (1.5 + 0.375)^2 / (4 * 3) + 0.375^2 / (2 * 1).
  const RestrictedMean mean = restricted_mean(kaplan_meier(Costs{{1, true}, {2, false}, {3, true}, {4, false}}), 4);
  CHECK(mean.mean == Approx(2.875));
  CHECK(mean.standard_error == Approx(std::sqrt(1.875 * 1.875 / 12 + 0.375 * 0.375 / 2)));
}

TEST_CASE("a trial given up at the cost where another succeeds was at risk there", "[survival]") {
  CHECK(kaplan_meier(Costs{{5, false}, {5, true}}).steps.at(0).survival == 0.5);
}

TEST_CASE("where all succeed the curve ends at zero and is known for ever", "[survival]") {
  const SurvivalCurve curve = kaplan_meier(Costs{{1, true}, {3, true}, {3, true}});
  CHECK(curve.steps.back().survival == 0);
  CHECK(curve.steps.back().standard_error == 0);
  CHECK(restricted_mean(curve, 100).mean == Approx(7.0 / 3));
  CHECK(restricted_mean(curve, 100).standard_error == Approx(std::sqrt(8.0 / 27)));  // sum of squares 8/3, by n^2
}

TEST_CASE("where none succeeds the curve stays at one", "[survival]") {
  const SurvivalCurve curve = kaplan_meier(Costs{{10, false}, {20, false}});
  CHECK(curve.steps.empty());
  CHECK(std::isnan(curve.median));
  CHECK(restricted_mean(curve, 15).mean == 15);
  CHECK(says(restricted_mean(curve, 21).undefined, "beyond 20"));
}

TEST_CASE("there is no curve of impossible costs and no mean to an impossible horizon", "[survival]") {
  CHECK(says(kaplan_meier({}).undefined, "no trials"));
  CHECK(says(kaplan_meier(Costs{{NAN, true}}).undefined, "trial 1"));
  CHECK(says(restricted_mean(kaplan_meier({}), 10).undefined, "no trials"));
  CHECK(says(restricted_mean(kaplan_meier(evaluations), 1001).undefined, "beyond 1000"));
  CHECK(says(restricted_mean(kaplan_meier(evaluations), -1).undefined, "horizon of -1"));
  CHECK(says(restricted_mean(kaplan_meier(evaluations), NAN).undefined, "horizon"));
  CHECK(std::isnan(restricted_mean(kaplan_meier(evaluations), 1001).mean));
}

TEST_CASE("trials in clusters that are drawn once each have the curve and the mean of all", "[survival]") {
  const std::vector<std::size_t> clusters{0, 1, 2, 3, 0, 1, 2, 3};
  const ClusteredSurvival survival(evaluations, clusters);
  const std::vector<double> once(4, 1.0);
  CHECK(survival.restricted_mean(1000, once) == Approx(540));
  CHECK(survival.restricted_mean(200, once) == Approx(175));
  CHECK(survival.survival_at(std::vector<double>{0, 80, 100, 560, 2000}, once) ==
        std::vector<double>{1, 0.875, 0.875, 0.375, 0.375});
}

TEST_CASE("a cluster that is drawn twice counts as its trials twice would, one that is not drawn as none",
          "[survival]") {
  const Costs costs{{1, true}, {2, false}, {3, true}, {4, false}, {2, true}, {5, true}};
  const std::vector<std::size_t> clusters{0, 0, 1, 1, 2, 2};
  const Costs drawn{{1, true}, {1, true}, {2, false}, {2, false}, {3, true}, {4, false}};
  const ClusteredSurvival survival(costs, clusters);
  CHECK(survival.restricted_mean(4, std::vector<double>{2, 1, 0}) ==
        Approx(restricted_mean(kaplan_meier(drawn), 4).mean));
  // 4 of 6 are left from 1 on and half of them from 3 on: 1 + 2 (2 / 3) + 7 (1 / 3), level beyond the last trial.
  CHECK(survival.restricted_mean(10, std::vector<double>{2, 1, 0}) == Approx(14.0 / 3));
  CHECK(survival.restricted_mean(10, std::vector<double>{0, 0, 3}) == Approx(3.5));
}
