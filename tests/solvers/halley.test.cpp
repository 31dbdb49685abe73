// Halley's method: its step by differences of the Jacobian, its order of convergence, its cut residual and its end.
#include <Eigen/LU>
#include <cmath>

#include "tests/catch.hpp"
#include "tests/solvers/objectives.hpp"
#include "tests/solvers/pseudo_inverse.hpp"

using namespace ikbench;
using namespace ikbench::numerics;
using namespace ikbench::robots;
using namespace ikbench::solvers;

namespace {

// [m, rad]
Eigen::VectorXd residual_at(const ReachablePose& task, const Eigen::VectorXd& q) {
  Matrix6Xd J(6, q.size());
  const Pose reached = task.arm.chain.pose_jacobian(q, J);
  Eigen::VectorXd e(6);
  e << task.goal.target.translation() - reached.translation(),
      rotation_vector(task.goal.target.linear() * reached.linear().transpose());
  return e;
}

Eigen::MatrixXd jacobian_at(const Chain& arm, const Eigen::VectorXd& q, Eigen::Index rows) {
  Matrix6Xd J(6, q.size());
  arm.pose_jacobian(q, J);
  return J.topRows(rows);
}

// J and its change along dq, by central differences. The rows of a rotation change by w_i x w_j for i < j alone, as the
// differences of the columns' own axes do.
Eigen::MatrixXd bent(const Chain& arm, const Eigen::VectorXd& q, const Eigen::VectorXd& dq, Eigen::Index rows) {
  const double h = 1e-5;
  const Eigen::MatrixXd change = jacobian_at(arm, q + h * dq, rows) - jacobian_at(arm, q - h * dq, rows);
  return jacobian_at(arm, q, rows) + change / (2 * h);
}

const Settings unbound{{"bounds", "initial"}, {"most_position_m", "1e6"}, {"most_rotation_rad", "1e6"}};

}  // namespace

TEST_CASE("a step of Halley's method bends the Jacobian half a Newton step along", "[halley]") {
  for (const std::string name : {"abb_irb120", "franka_panda", "stanford"}) {  // stanford has a sliding joint
    ReachablePose task(name, 3, 1);
    task.problem.start.array() += 0.05;
    RecordingObjective recorded(task.arm.chain, task.goal);
    Random random{Key(1)};
    const auto halley = solver("halley").make(unbound);
    halley->start(task.problem, recorded, random);
    halley->step(recorded, random);
    const Eigen::VectorXd q = recorded.candidates.front(), e = residual_at(task, q);
    const Eigen::VectorXd dq = pseudo_inverse(jacobian_at(task.arm.chain, q, 6)) * e / 2;
    const Eigen::VectorXd step = pseudo_inverse(bent(task.arm.chain, q, dq, 6)) * e;
    CAPTURE(name);
    CHECK((recorded.candidates.back() - (q + step)).norm() < 1e-6 * (1 + step.norm()));
  }
}

TEST_CASE("Halley's method searches positions, too", "[halley]") {
  const Task task = iiwa_task();
  Problem problem = task.problem;
  problem.start.array() += 0.4;
  RecordingObjective recorded(task.chain, task.target);
  Random random{Key(1)};
  const auto halley = solver("halley").make(unbound);
  halley->start(problem, recorded, random);
  halley->step(recorded, random);
  const Eigen::VectorXd q = recorded.candidates.front(), e = task.target - task.chain.forward(q).translation();
  const Eigen::VectorXd dq = pseudo_inverse(jacobian_at(task.chain, q, 3)) * e / 2;
  const Eigen::VectorXd step = pseudo_inverse(bent(task.chain, q, dq, 3)) * e;
  CHECK((recorded.candidates.back() - (q + step)).norm() < 1e-6 * (1 + step.norm()));
}

// From a start near a solution, the error of the next step is of the order of its third power, or of its square.
TEST_CASE("Halley's method converges by the third power where Newton's does by the second", "[halley]") {
  const auto order = [](const char* method) {
    ReachablePose task("abb_irb120", 3, 1);
    const auto after_one_step = [&](double away) {
      ReachablePose near = task;
      Eigen::VectorXd q = task.problem.start.array() + 0.3;
      near.goal = Goal(task.arm.chain.forward(q), 1);
      near.problem.start = q.array() + away;
      Objective objective(near.arm.chain, near.goal);
      Random random{Key(1)};
      Settings settings = unbound;
      settings["method"] = method;
      const auto solver_of = solver("halley").make(settings);
      solver_of->start(near.problem, objective, random);
      solver_of->step(objective, random);
      return residual_at(near, solver_of->best().q).norm();
    };
    return std::log(after_one_step(0.04) / after_one_step(0.02)) / std::log(2);
  };
  CHECK(order("newton") == Approx(2).margin(0.3));
  CHECK(order("halley") == Approx(3).margin(0.3));
}

TEST_CASE("a residual is cut to the length that a step can trust", "[halley]") {
  // Stretched along y, the planar arm has J = (-1 -0.5; 0 0) for a target to its left, and J^+ (x, 0) = (-0.8, -0.4) x.
  Task task = planar_task(1);
  task.problem.start = Eigen::Vector2d(std::acos(-1.0) / 2, 0);
  task.target = {-3, 1, 0};
  RecordingObjective objective(task.chain, task.target);
  Random random{Key(1)};
  const auto newton = solver("halley").make({{"method", "newton"}, {"most_position_m", "0.1"}, {"bounds", "initial"}});
  newton->start(task.problem, objective, random);
  newton->step(objective, random);
  const Eigen::VectorXd moved = objective.candidates.back() - objective.candidates.front();
  CHECK((moved - Eigen::Vector2d(0.08, 0.04)).norm() < 1e-12);
}

TEST_CASE("Halley's method ends where the residual is small, and says so", "[halley]") {
  const ReachablePose task("franka_panda", 5, 1);
  for (const char* method : {"halley", "newton"}) {
    Objective objective(task.arm.chain, task.goal);
    Random random{Key(1)};
    const auto made = solver("halley").make({{"method", method}, {"bounds", "initial"}});
    Problem problem = task.problem;
    problem.start.array() += 0.1;
    const Solution solution = solve(*made, problem, objective, random, {.iterations = 300});
    CAPTURE(method, solution.iterations);
    CHECK(solution.stopped == Stopped::finished);
    CHECK(residual_at(task, solution.best.q).norm() < 1e-8);
  }
}
