// The one loop: when it stops, what it counts and what it traces.
#include "solvers/solve.hpp"

#include <algorithm>

#include "tests/catch.hpp"
#include "tests/solvers/objectives.hpp"

using namespace ikbench;
using namespace ikbench::numerics;
using namespace ikbench::solvers;

namespace {

Solution solved(const StopRule& stop, Trace trace = Trace::none) {
  const Task task = iiwa_task();
  Objective objective(task.chain, task.target);
  Random random{Key(1)};
  return solve(*solver("ik_bat").make({}), task.problem, objective, random, stop, trace);
}

}  // namespace

TEST_CASE("a solve stops after its iterations", "[solve]") {
  const Solution solution = solved({.iterations = 12});
  CHECK(solution.stopped == Stopped::iterations);
  CHECK(solution.iterations == 12);
  CHECK(solution.evaluations == 10 + 12 * 10);  // the first population and one an iteration
}

TEST_CASE("a solve of no iterations is its start", "[solve]") {
  const Solution solution = solved({.iterations = 0}, Trace::best_error);
  CHECK(solution.stopped == Stopped::iterations);
  CHECK(solution.evaluations == 10);
  CHECK(solution.trace.empty());
}

TEST_CASE("a solve stops at the first error within the tolerance", "[solve]") {
  const Solution solution = solved({.iterations = 1000, .tolerance = 0.01}, Trace::best_error);
  CHECK(solution.stopped == Stopped::tolerance);
  CHECK(solution.best.error <= 0.01);
  REQUIRE(solution.trace.size() >= 2);
  CHECK(solution.trace[solution.trace.size() - 2] > 0.01);
}

TEST_CASE("a solve stops after the iteration that spends its evaluations", "[solve]") {
  const Solution solution = solved({.iterations = 1000, .evaluations = 55});
  CHECK(solution.stopped == Stopped::evaluations);
  CHECK(solution.evaluations == 60);
}

TEST_CASE("a solve stops when its time is over", "[solve]") {
  const Solution solution = solved({.iterations = 1000000000, .seconds = 0.01});
  CHECK(solution.stopped == Stopped::time);
  CHECK(solution.iterations > 0);
}

TEST_CASE("the trace has the best error after each iteration and never grows", "[solve]") {
  const Solution solution = solved({.iterations = 40}, Trace::best_error);
  REQUIRE(solution.trace.size() == 40);
  CHECK(std::is_sorted(solution.trace.rbegin(), solution.trace.rend()));
  CHECK(solution.trace.back() == solution.best.error);
  CHECK(solved({.iterations = 40}).trace.empty());
}

TEST_CASE("an unknown solver is told the nearest name", "[solve]") {
  CHECK_THROWS_AS(solver("ik_bta"), std::invalid_argument);
  CHECK_THROWS_WITH(solver("ik_bta"),
                    Catch::Matchers::StartsWith("unknown solver \"ik_bta\"; did you mean \"ik_bat\"?"));
}
