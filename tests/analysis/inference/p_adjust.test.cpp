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
  check_equal(adjusted(p), {.05, .08, .09, .09, .09});  // R 4.2.2
}

TEST_CASE("adjusted p-values come in the order given, ties alike", "[p_adjust]") {
  check_equal(adjusted(std::vector<double>{.04, .01, .04}), {.08, .03, .08});
  check_equal(adjusted(std::vector<double>{.9, .8}), {1, 1});
}

TEST_CASE("a test that could not be made stays undefined and does not count", "[p_adjust]") {
  const auto with = adjusted(std::vector<double>{.01, not_defined, .03});
  const auto without = adjusted(std::vector<double>{.01, .03});
  CHECK(with[0] == without[0]);
  CHECK(std::isnan(with[1]));
  CHECK(with[2] == without[1]);
  CHECK(adjusted({}).empty());
  CHECK(std::isnan(adjusted(std::vector<double>{not_defined})[0]));
  CHECK(adjusted(std::vector<double>{.2})[0] == .2);
  CHECK_THROWS_AS(adjusted(std::vector<double>{1.1}), std::invalid_argument);
  CHECK_THROWS_AS(adjusted(std::vector<double>{-0.1}), std::invalid_argument);
}
