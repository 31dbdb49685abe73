// Arms whose joints turn without end: no solver stops at a whole turn, and first candidates are drawn from one.
#include "tests/solvers/objectives.hpp"

namespace {

constexpr double half = std::numbers::pi;

// A joint that turns without end, one within limits, and one that slides.
Task endless_task(int population = 10) {
  return {Chain({{.a = 0.4}, {.a = 0.3, .alpha = half / 2}, {.joint = Joint::slides}}),
          {0.3, 0.3, 0},
          problem_of(Eigen::Vector3d(2.5, 0.3, 0.1), Eigen::Vector3d(-infinity, -1.5, 0),
                     Eigen::Vector3d(infinity, 1.5, 0.4), population)};
}

std::vector<SolverInfo> solvers_for_endless() { return solvers_for(endless_task().chain, GoalKind::position); }

}  // namespace

TEST_CASE("an arm without end is searched by every solver as one with limits is", "[endless]") {
  for (const SolverInfo& info : solvers_for_endless()) {
    CAPTURE(info.name);
    const Task task = endless_task(std::max(10, info.min_population));
    Objective objective(task.chain, task.target), judge(task.chain, task.target);
    Random random{Key(3)};
    const Solution solution = solve(*info.make({}), task.problem, objective, random, {.iterations = 200});
    CHECK(solution.stopped != StopReason::not_finite);
    CHECK(solution.best.q.allFinite());
    CHECK(std::abs(solution.best.error - judge.error(solution.best.q)) < 1e-14);
    CHECK(solution.best.error < judge.error(task.problem.start));
  }
}

TEST_CASE("bounds = clamp holds the joints that have limits, and no others", "[endless]") {
  for (const SolverInfo& info : solvers_for_endless()) {
    if (!info.options({}).contains("bounds")) continue;
    CAPTURE(info.name);
    const Task task = endless_task(50);
    const JointLimits limits{task.problem.lower, task.problem.upper};
    RecordingObjective objective(task.chain, task.target);
    solve_by(info.name, {{"bounds", "clamp"}}, task.problem, objective, {.iterations = 100});
    for (const auto& q : objective.candidates) {
      REQUIRE(limits.violation(q) == 0);
      REQUIRE(q[0] != task.problem.start[0] - half);
      REQUIRE(q[0] != task.problem.start[0] + half);
    }
  }
}

TEST_CASE("swarms leave the turn that they began in where a joint turns without end", "[endless]") {
  for (const char* name : {"particle_swarm", "bat", "differential_evolution", "k_artificial_bee_colony"}) {
    CAPTURE(name);
    Task task = endless_task(50);
    task.target = {-0.69, 0.05, 0};  // stretched, near half a turn from zero
    task.problem.start[0] = 0;
    RecordingObjective objective(task.chain, task.target);
    const Solution solution = solve_by(name, {}, task.problem, objective, {.iterations = 200});
    double farthest = 0;
    for (const auto& q : objective.candidates) farthest = std::max(farthest, std::abs(q[0]));
    CHECK(farthest > half);
    CHECK(solution.best.error < 0.01);
  }
}

TEST_CASE("first candidates of a joint without end are drawn from a turn about the start", "[endless]") {
  const Task task = endless_task(1000);
  RecordingObjective objective(task.chain, task.target);
  Random random{Key(1)};
  solver("random_search").make({})->start(task.problem, objective, random);
  double least = infinity, most = -infinity;
  for (const auto& q : objective.candidates) {
    least = std::min(least, q[0]);
    most = std::max(most, q[0]);
    CHECK(q[2] >= 0);
    CHECK(q[2] <= 0.4);
  }
  CHECK(least >= 2.5 - half);
  CHECK(least < 2.5 - 0.95 * half);
  CHECK(most <= 2.5 + half);
  CHECK(most > 2.5 + 0.95 * half);
}
