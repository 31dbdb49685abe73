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
  CHECK(time.expected == Approx(864));  // 4320 / 5
  CHECK(time.sp1 == Approx(422.4));     // 1320 / 5 / 0.625
  CHECK(time.success_rate == 0.625);
  CHECK(time.trials == 8);
  CHECK(time.successes == 5);
}

TEST_CASE("where all succeed the expected running time is the mean", "[running_time]") {
  const RunningTime time = running_time(Costs{{1, true}, {3, true}});
  CHECK(time.expected == 2);
  CHECK(time.sp1 == 2);
}

TEST_CASE("where none succeeds there is a success rate and no running time", "[running_time]") {
  const RunningTime time = running_time(Costs{{10, false}, {10, false}});
  CHECK(time.success_rate == 0);
  CHECK(std::isnan(time.expected));
  CHECK(std::isnan(time.sp1));
  CHECK(says(time.undefined, "no trial reached"));
}

TEST_CASE("costs that cannot be have no running time", "[running_time]") {
  CHECK(says(running_time({}).undefined, "no trials"));
  CHECK(says(running_time(Costs{{1, true}, {NAN, true}}).undefined, "trial 2"));
  CHECK(says(running_time(Costs{{HUGE_VAL, false}}).undefined, "trial 1"));
  CHECK(says(running_time(Costs{{-1, true}}).undefined, "trial 1"));
  CHECK(says(running_time(Costs{{1e308, true}, {1e308, true}}).undefined, "too large"));
}
