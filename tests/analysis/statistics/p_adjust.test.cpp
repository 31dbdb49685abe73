#include "analysis/statistics/p_adjust.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/statistics/descriptive.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;

namespace {

void check_equal(const std::vector<double>& values, const std::vector<double>& expected) {
  REQUIRE(values.size() == expected.size());
  for (std::size_t i = 0; i < values.size(); ++i) CHECK(values[i] == Approx(expected[i]));
}

}  // namespace

TEST_CASE("five p-values are adjusted as R's p.adjust does", "[p_adjust]") {
  const std::vector<double> p{.01, .02, .03, .04, .05};
  check_equal(adjusted(p, Correction::holm), {.05, .08, .09, .09, .09});  // R 4.2.2
  check_equal(adjusted(p, Correction::hochberg), {.05, .05, .05, .05, .05});
  check_equal(adjusted(p, Correction::benjamini_hochberg), {.05, .05, .05, .05, .05});
  check_equal(adjusted(p, Correction::bonferroni), {.05, .10, .15, .20, .25});
}

TEST_CASE("Benjamini and Hochberg's own example finds four", "[p_adjust]") {
  // Benjamini and Hochberg (1995), section 4.1: at 0.05 their procedure rejects four of the fifteen, Bonferroni's
  // three.
  const std::vector<double> p{.0001, .0004, .0019, .0095, .0201, .0278, .0298, .0344,
                              .0459, .3240, .4262, .5719, .6528, .7590, 1.000};
  const auto found = [&](Correction correction) {
    return std::ranges::count_if(adjusted(p, correction), [](double value) { return value <= 0.05; });
  };
  CHECK(found(Correction::benjamini_hochberg) == 4);
  CHECK(found(Correction::bonferroni) == 3);
  CHECK(found(Correction::hochberg) == 3);
}

TEST_CASE("adjusted p-values come in the order given, ties alike", "[p_adjust]") {
  check_equal(adjusted(std::vector<double>{.04, .01, .04}, Correction::holm), {.08, .03, .08});
  check_equal(adjusted(std::vector<double>{.04, .01, .04}, Correction::hochberg), {.04, .03, .04});
  check_equal(adjusted(std::vector<double>{.9, .8}, Correction::bonferroni), {1, 1});
}

TEST_CASE("Hochberg's adjusted p lies between Benjamini-Hochberg's and Holm's, Bonferroni's above all", "[p_adjust]") {
  std::vector<double> p;
  for (int i = 0; i < 50; ++i) p.push_back(std::pow(std::fmod(i * 0.6180339887, 1.0), 3));
  const auto holm = adjusted(p, Correction::holm), hochberg = adjusted(p, Correction::hochberg);
  const auto bh = adjusted(p, Correction::benjamini_hochberg), bonferroni = adjusted(p, Correction::bonferroni);
  for (std::size_t i = 0; i < p.size(); ++i) {
    CHECK(p[i] <= bh[i]);
    CHECK(bh[i] <= hochberg[i] * (1 + 1e-15));
    CHECK(hochberg[i] <= holm[i]);
    CHECK(holm[i] <= bonferroni[i]);
  }
}

TEST_CASE("a test that could not be made stays undefined and does not count", "[p_adjust]") {
  const auto correction =
      GENERATE(Correction::holm, Correction::hochberg, Correction::bonferroni, Correction::benjamini_hochberg);
  const auto with = adjusted(std::vector<double>{.01, not_defined, .03}, correction);
  const auto without = adjusted(std::vector<double>{.01, .03}, correction);
  CHECK(with[0] == without[0]);
  CHECK(std::isnan(with[1]));
  CHECK(with[2] == without[1]);
  CHECK(adjusted({}, correction).empty());
  CHECK(std::isnan(adjusted(std::vector<double>{not_defined}, correction)[0]));
  CHECK(adjusted(std::vector<double>{.2}, correction)[0] == .2);
  CHECK_THROWS_AS(adjusted(std::vector<double>{1.1}, correction), std::invalid_argument);
  CHECK_THROWS_AS(adjusted(std::vector<double>{-0.1}, correction), std::invalid_argument);
}
