#include <cmath>
#include <utility>
#include <vector>

#include "analysis/inference/costs.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::inference;

namespace {

RunningTime running_time(const std::vector<std::pair<double, bool>>& costs) {
  RunningTime sum;
  for (const auto& [cost, is_success] : costs) sum.add(cost, is_success);
  return sum;
}

}  // namespace

TEST_CASE("the expected running time is all that was spent by the successes", "[running_time]") {
  const RunningTime time = running_time(
      {{120, true}, {340, true}, {80, true}, {1000, false}, {1000, false}, {560, true}, {1000, false}, {220, true}});
  CHECK(time.expected() == Approx(864));  // 4320 / 5
  CHECK(time.spent == 4320);
  CHECK(time.trials == 8);
  CHECK(time.successes == 5);
}

TEST_CASE("where all succeed the expected running time is the mean", "[running_time]") {
  CHECK(running_time({{1, true}, {3, true}}).expected() == 2);
}

TEST_CASE("where none succeeds the expected running time is infinite, whatever was spent", "[running_time]") {
  CHECK(running_time({{10, false}, {10, false}}).expected() == HUGE_VAL);
  CHECK(running_time({{0, false}}).expected() == HUGE_VAL);
  CHECK(std::isnan(running_time({}).expected()));
}
