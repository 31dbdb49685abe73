// The closed form as a solver: its choice of a branch, and the arms that it refuses.
#include "robots/closed_form.hpp"

#include <cmath>
#include <numbers>

#include "tests/catch.hpp"
#include "tests/solvers/allocations.hpp"
#include "tests/solvers/objectives.hpp"

using namespace ikbench;
using namespace ikbench::numerics;
using namespace ikbench::robots;
using namespace ikbench::solvers;

namespace {

const Robot irb120 = robot("abb_irb120");

struct Posed {
  Eigen::VectorXd q;  // a configuration that reaches the goal
  Goal goal;
  Problem problem;
};

Posed posed(std::uint64_t seed) {
  Random random{Key(seed)};
  Eigen::VectorXd q(6), start(6);
  for (Eigen::Index j = 0; j < 6; ++j) {
    q[j] = random.uniform(irb120.limits.lower[j], irb120.limits.upper[j]);
    start[j] = random.uniform(irb120.limits.lower[j], irb120.limits.upper[j]);
  }
  return {
      q, {irb120.chain.forward(q), 0.3}, {.start = start, .lower = irb120.limits.lower, .upper = irb120.limits.upper}};
}

}  // namespace

TEST_CASE("the closed form gives the branch inside the limits that is nearest to the start, and ends",
          "[closed_form]") {
  const auto closed_form = solver("closed_form").make({});
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto [q, goal, problem] = posed(seed);
    RecordingObjective objective(irb120.chain, goal);
    Random random{Key(1)};
    const Solution solution = solve(*closed_form, problem, objective, random, {.iterations = 10});
    REQUIRE(solution.stopped == Stopped::finished);
    REQUIRE(solution.iterations == 0);
    REQUIRE(solution.best.error < 1e-9);
    REQUIRE(solution.best.error == Objective(irb120.chain, goal).error(solution.best.q));
    REQUIRE(irb120.limits.violation(solution.best.q) == 0);

    // Every branch with every whole turn that the limits of +-400 deg could allow.
    double nearest = (q - problem.start).norm();
    std::size_t inside = 0;
    const ClosedForm::Branches branches = ClosedForm(irb120.chain).branches(goal.target, problem.start);
    for (Eigen::Index i = 0; i < branches.cols(); ++i) {
      bool is_inside = false;
      for (int turns = -2; turns <= 2; ++turns) {
        Eigen::VectorXd turned = branches.col(i);
        turned[5] += 2 * std::numbers::pi * turns;
        if (irb120.limits.violation(turned) > 0) continue;
        is_inside = true;
        nearest = std::min(nearest, (turned - problem.start).norm());
      }
      inside += is_inside ? 1 : 0;
    }
    REQUIRE((solution.best.q - problem.start).norm() < nearest + 1e-9);
    REQUIRE(objective.candidates.size() == inside);
  }
}

TEST_CASE("where no branch is inside the limits, or the pose is out of reach, the arm stays where it is",
          "[closed_form]") {
  auto [q, goal, problem] = posed(1);
  const auto solved = [&goal = goal, &problem = problem] {
    Objective objective(irb120.chain, goal);
    Random random{Key(1)};
    return solve(*solver("closed_form").make({}), problem, objective, random, {});
  };
  const Problem all = problem;
  problem.start = problem.lower = problem.upper = Eigen::VectorXd::Constant(6, 0.01);
  CHECK(solved().best.q == problem.start);
  problem = all;
  goal.target.translation().x() += 2;
  CHECK(solved().best.q == problem.start);
  CHECK(solved().stopped == Stopped::finished);
  CHECK(solved().best.error > 1);
}

TEST_CASE("a solver of closed form that is used again takes no memory from the heap, and may change its arm",
          "[closed_form]") {
  const auto closed_form = solver("closed_form").make({});
  const auto [q, goal, problem] = posed(1);
  Random random{Key(1)};
  Objective objective(irb120.chain, goal);
  closed_form->start(problem, objective, random);
  const Configuration first = closed_form->best().q;
  const long before = allocations();
  closed_form->start(problem, objective, random);
  CHECK(allocations() == before);
  CHECK(closed_form->best().q == first);
  const Robot puma = robot("puma560");
  const Goal other{puma.chain.forward(Eigen::VectorXd::Constant(6, 0.3)), 0.3};
  Objective of_puma(puma.chain, other);
  closed_form->start({.start = Eigen::VectorXd::Zero(6), .lower = puma.limits.lower, .upper = puma.limits.upper},
                     of_puma, random);
  CHECK(closed_form->best().error < 1e-9);
}

TEST_CASE("arms without a closed form, and goals that are positions, are refused", "[closed_form]") {
  const SolverInfo info = solver("closed_form");
  CHECK(info.why_not(irb120.chain, GoalKind::pose).empty());
  CHECK(info.why_not(irb120.chain, GoalKind::position) == "closed_form solves for a pose; expected search = \"pose\"");
  const std::string why =
      "closed_form needs an arm with six joints that turn and a spherical wrist, but this one has 7 joints, not six";
  const Robot panda = robot("franka_panda");
  CHECK(info.why_not(panda.chain, GoalKind::pose) == why);
  const Eigen::VectorXd q = Eigen::VectorXd::Zero(7);
  Objective objective(panda.chain, {panda.chain.forward(q), 0.3});
  Random random{Key(1)};
  CHECK_THROWS_WITH(
      info.make({})->start({.start = q, .lower = panda.limits.lower, .upper = panda.limits.upper}, objective, random),
      why);
}
