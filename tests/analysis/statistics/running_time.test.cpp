#include "analysis/statistics/running_time.hpp"

#include <cmath>
#include <vector>

#include "tests/analysis/statistics/samples.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::statistics;
using namespace ikbench::samples;

using Costs = std::vector<CensoredCost>;

TEST_CASE("the expected running time is all that was spent by the successes", "[running_time]") {
  const RunningTime time = running_time(Costs{
      {120, true}, {340, true}, {80, true}, {1000, false}, {1000, false}, {560, true}, {1000, false}, {220, true}});
  CHECK(time.expected() == Approx(864));  // 4320 / 5
  CHECK(time.spent == 4320);
  CHECK(time.trials == 8);
  CHECK(time.successes == 5);
}

TEST_CASE("where all succeed the expected running time is the mean", "[running_time]") {
  CHECK(running_time(Costs{{1, true}, {3, true}}).expected() == 2);
}

TEST_CASE("where none succeeds the expected running time is infinite, whatever was spent", "[running_time]") {
  CHECK(running_time(Costs{{10, false}, {10, false}}).expected() == HUGE_VAL);
  CHECK(running_time(Costs{{0, false}}).expected() == HUGE_VAL);
  CHECK(std::isnan(running_time({}).expected()));
}

TEST_CASE("costs that cannot be have no running time", "[running_time]") {
  CHECK(says(wrong_with({}), "no trials"));
  CHECK(says(wrong_with(Costs{{1, true}, {NAN, true}}), "trial 2"));
  CHECK(says(wrong_with(Costs{{HUGE_VAL, false}}), "trial 1"));
  CHECK(says(wrong_with(Costs{{-1, true}}), "trial 1"));
  CHECK(says(wrong_with(Costs{{1e308, true}, {1e308, true}}), "too large"));
  CHECK(wrong_with(Costs{{1, true}, {0, false}}).empty());
}
