#include "analysis/inference/ranking.hpp"

#include <cmath>

#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::inference;

TEST_CASE("a ranking begins with the smallest mean and ends with those that are not finite", "[ranking]") {
  std::string order;
  for (const RankedSolver& each : ranked({{"A", 3}, {"B", NAN}, {"C", 1}, {"D", INFINITY}, {"E", 1}}))
    order += each.solver;
  CHECK(order == "CEABD");
}
