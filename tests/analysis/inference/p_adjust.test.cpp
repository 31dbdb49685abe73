#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/inference/method.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::inference;
using namespace ikbench::statistics;

namespace {

void check_equal(const std::vector<double>& values, const std::vector<double>& expected) {
  REQUIRE(values.size() == expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) CHECK(values[i] == Approx(expected[i]));
}

}  // namespace

TEST_CASE("five p-values are adjusted as R's p.adjust does", "[p_adjust]") {
  const std::vector<double> p{.01, .02, .03, .04, .05};
  check_equal(adjusted(p, Adjustment::holm), {.05, .08, .09, .09, .09});  // R 4.2.2
  check_equal(adjusted(p, Adjustment::hochberg), {.05, .05, .05, .05, .05});
  check_equal(adjusted(p, Adjustment::benjamini_hochberg), {.05, .05, .05, .05, .05});
  check_equal(adjusted(p, Adjustment::bonferroni), {.05, .10, .15, .20, .25});
}

TEST_CASE("Benjamini and Hochberg's own example finds four", "[p_adjust]") {
  // Benjamini and Hochberg (1995), section 4.1: at 0.05 their procedure rejects four of the fifteen, Bonferroni's
  // three.
  const std::vector<double> p{.0001, .0004, .0019, .0095, .0201, .0278, .0298, .0344,
                              .0459, .3240, .4262, .5719, .6528, .7590, 1.000};
  const auto found = [&](Adjustment adjustment) {
    return std::ranges::count_if(adjusted(p, adjustment), [](double value) { return value <= 0.05; });
  };
  CHECK(found(Adjustment::benjamini_hochberg) == 4);
  CHECK(found(Adjustment::bonferroni) == 3);
  CHECK(found(Adjustment::hochberg) == 3);
}

TEST_CASE("adjusted p-values come in the order given, ties alike", "[p_adjust]") {
  check_equal(adjusted(std::vector<double>{.04, .01, .04}, Adjustment::holm), {.08, .03, .08});
  check_equal(adjusted(std::vector<double>{.04, .01, .04}, Adjustment::hochberg), {.04, .03, .04});
  check_equal(adjusted(std::vector<double>{.9, .8}, Adjustment::bonferroni), {1, 1});
}

TEST_CASE("Hochberg's adjusted p lies between Benjamini-Hochberg's and Holm's, Bonferroni's above all", "[p_adjust]") {
  std::vector<double> p;
  for (int i = 0; i < 50; ++i) p.push_back(std::pow(std::fmod(i * 0.6180339887, 1.0), 3));
  const auto holm = adjusted(p, Adjustment::holm), hochberg = adjusted(p, Adjustment::hochberg);
  const auto bh = adjusted(p, Adjustment::benjamini_hochberg), bonferroni = adjusted(p, Adjustment::bonferroni);
  for (std::size_t i = 0; i < p.size(); ++i) {
    CHECK(p[i] <= bh[i]);
    CHECK(bh[i] <= hochberg[i] * (1 + 1e-15));
    CHECK(hochberg[i] <= holm[i]);
    CHECK(holm[i] <= bonferroni[i]);
  }
}

TEST_CASE("a test that could not be made stays undefined and does not count", "[p_adjust]") {
  const auto adjustment =
      GENERATE(Adjustment::holm, Adjustment::hochberg, Adjustment::bonferroni, Adjustment::benjamini_hochberg);
  const auto with = adjusted(std::vector<double>{.01, not_defined, .03}, adjustment);
  const auto without = adjusted(std::vector<double>{.01, .03}, adjustment);
  CHECK(with[0] == without[0]);
  CHECK(std::isnan(with[1]));
  CHECK(with[2] == without[1]);
  CHECK(adjusted({}, adjustment).empty());
  CHECK(std::isnan(adjusted(std::vector<double>{not_defined}, adjustment)[0]));
  CHECK(adjusted(std::vector<double>{.2}, adjustment)[0] == .2);
  CHECK_THROWS_AS(adjusted(std::vector<double>{1.1}, adjustment), std::invalid_argument);
  CHECK_THROWS_AS(adjusted(std::vector<double>{-0.1}, adjustment), std::invalid_argument);
}
