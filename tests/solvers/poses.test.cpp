// Whole poses as goals: the objective's errors, the ends of solves, and the contract of every solver.
#include "tests/solvers/objectives.hpp"

namespace {

constexpr double weight = 0.5;

Goal moved(const Goal& goal, const Eigen::Vector3d& by, double angle, const Eigen::Vector3d& axis) {
  Pose target = goal.target;
  target.translation() += by;
  target.linear() = Eigen::AngleAxisd(angle, axis) * target.linear();
  return {target, goal.rotation_weight, goal.kind};
}

}  // namespace

TEST_CASE("a pose's error is its distance where it is turned right, and grows with the weight of a turn", "[pose]") {
  const ReachablePose task("ur5e", 1, weight);
  const Eigen::VectorXd q = task.problem.start;
  const Goal here{task.arm.chain.forward(q), weight};
  const auto error = [&](const Goal& goal) { return Objective(task.arm.chain, goal).error(q); };
  const Eigen::Vector3d z = here.target.linear().col(2), x = here.target.linear().col(0);
  CHECK(error(here) < 1e-15);
  CHECK(error(moved(here, {0.03, 0, 0.04}, 0, z)) == Approx(0.05));
  // Half a turn about the tool's z: two of the three points are twice the weight away; about x, one of them.
  CHECK(error(moved(here, {0, 0, 0}, std::numbers::pi, z)) == Approx(weight * std::sqrt(8.0 / 3)));
  CHECK(error(moved(here, {0, 0, 0}, std::numbers::pi, x)) == Approx(weight * std::sqrt(4.0 / 3)));
  Objective objective(task.arm.chain, moved(here, {0.03, 0, 0.04}, 0.2, x));
  CHECK(objective.deviation(q).position == Approx(0.05));
  CHECK(objective.deviation(q).angle == Approx(0.2));
  CHECK(objective.evaluations() == 0);
}

TEST_CASE("an axis' error does not change as the tool turns about it, and otherwise is that of a pose", "[axis]") {
  const ReachablePose task("ur5e", 1, weight);
  Eigen::VectorXd q = task.problem.start.array() + 0.7;  // nowhere near singular
  const Goal here{task.arm.chain.forward(q), weight, GoalKind::axis};
  const Eigen::Vector3d z = here.target.linear().col(2), x = here.target.linear().col(0), by(0.03, 0, 0.04);
  const auto seen = [&](const Goal& goal) {
    Objective objective(task.arm.chain, goal);
    return Eigen::Vector3d(objective.error(q), objective.deviation(q).position, objective.deviation(q).angle);
  };
  CHECK((seen(moved(here, by, 2, z)) - Eigen::Vector3d(0.05, 0.05, 0)).norm() < 1e-7);
  for (const double angle : {1e-9, 0.2, 2.0, std::numbers::pi}) {
    CAPTURE(angle);
    // Both other points are weight times the chord away.
    const double error = std::hypot(0.05, std::sqrt(2.0 / 3) * weight * 2 * std::sin(angle / 2));
    CHECK((seen(moved(here, by, angle, x)) - Eigen::Vector3d(error, 0.05, angle)).norm() < 1e-7);
  }
  Objective near(task.arm.chain, moved(moved(here, {1e-3, -2e-3, 3e-3}, 2, z), {0, 0, 0}, 0.03, x));
  Eigen::MatrixXd jacobian(near.rows(), q.size());
  Residual residual = near.linearize(q, jacobian).to_go;
  CHECK((residual.tail<3>() - weight * 0.03 * x).norm() < 1e-14);
  CHECK((z.transpose() * jacobian.bottomRows<3>()).norm() < 1e-14);
  for (int step = 0; step < 5; ++step) {
    q += pseudo_inverse_times(jacobian, residual, 1e-9);
    residual = near.linearize(q, jacobian).to_go;
  }
  CHECK(near.error(q) < 1e-14);
}

TEST_CASE("a pose's residual is the way and the weighted turn that are left, and its Jacobian is Newton's", "[pose]") {
  for (const char* const name : {"ur5e", "stanford", "kuka_iiwa14", "franka_panda"}) {
    CAPTURE(name);
    const ReachablePose task(name, 1, weight);
    Eigen::VectorXd q = task.problem.start.array() + 0.2;
    const Goal here{task.arm.chain.forward(q), weight};
    const Eigen::Vector3d axis = Eigen::Vector3d(1, -2, 0.5).normalized(), by(0.01, -0.02, 0.03);
    Objective objective(task.arm.chain, moved(here, by, 0.3, axis));
    Eigen::MatrixXd jacobian(objective.rows(), q.size());
    REQUIRE(objective.rows() == 6);
    const Residual residual = objective.linearize(q, jacobian).to_go;
    CHECK((residual.head<3>() - by).norm() < 1e-15);
    CHECK((residual.tail<3>() - weight * 0.3 * axis).norm() < 1e-15);
    CHECK(objective.evaluations() == 1);
    Matrix6Xd geometric(6, q.size());
    task.arm.chain.pose_jacobian(q, geometric);
    CHECK(jacobian.topRows<3>() == geometric.topRows<3>());
    CHECK((jacobian.bottomRows<3>() - weight * geometric.bottomRows<3>()).norm() < 1e-15);
    // Newton's steps towards a pose that is near converge quadratically.
    Objective near(task.arm.chain, moved(here, 0.1 * by, 0.03, axis));
    for (int step = 0; step < 5; ++step) {
      const Eigen::VectorXd to_go = near.linearize(q, jacobian).to_go;
      q += pseudo_inverse(jacobian) * to_go;
    }
    CHECK(near.linearize(q, jacobian).to_go.norm() < 1e-14);
    CHECK(near.error(q) < 1e-14);
  }
}

TEST_CASE("every solver's best is honest about a pose or an axis and never worsens, and its steps take no memory",
          "[pose]") {
  const GoalKind kind = GENERATE(GoalKind::pose, GoalKind::axis);
  for (const char* const name : {"ur5e", "stanford", "puma560"}) {
    ReachablePose task(name, 1, weight);
    task.goal.kind = kind;
    for (const SolverInfo& info : solvers_for(task.arm.chain, task.goal.kind)) {
      CAPTURE(info.name, name, task.goal.kind);
      Objective objective(task.arm.chain, task.goal), judge(task.arm.chain, task.goal);
      Random random{Key(1)};
      const auto solver = info.make({});
      double before = 1e9;
      long taken = 0;
      solver->start(task.problem, objective, random);
      for (int iteration = 0; iteration < 40; ++iteration) {
        REQUIRE(std::abs(solver->best().error - judge.error(solver->best().q)) < 1e-14);
        REQUIRE(solver->best().error <= before);
        before = solver->best().error;
        const long allocated = allocations();
        solver->step(objective, random);
        taken += allocations() - allocated;
      }
      if (info.library.empty()) CHECK(taken == 0);  // a library takes memory as it likes
    }
  }
}

TEST_CASE("a solve of a pose stops where position and angle are both within their tolerances, and not before",
          "[pose][solve]") {
  ReachablePose task("ur5e", 1, weight);
  task.goal.kind = GENERATE(GoalKind::pose, GoalKind::axis);
  const StopRule both{.iterations = 400, .tolerance = 1e-3, .angle_tolerance = 1 * degree};
  for (const char* const name : {"damped_least_squares", "ik_bat"}) {
    CAPTURE(name);
    Objective objective(task.arm.chain, task.goal);
    const Solution solution = solve_by(name, {}, task.problem, objective, both);
    const Deviation left = objective.deviation(solution.best.q);
    const bool is_near = left.position <= both.tolerance && left.angle <= both.angle_tolerance;
    CHECK((solution.stopped == StopReason::tolerance) == is_near);
    CHECK(solution.position_error == left.position);
    if (name == std::string("damped_least_squares")) REQUIRE(is_near);
    if (!is_near) continue;
    // With one iteration less it is not near enough.
    Objective again(task.arm.chain, task.goal);
    const StopRule before{.iterations = static_cast<int>(solution.iterations) - 1};
    const Deviation earlier = again.deviation(solve_by(name, {}, task.problem, again, before).best.q);
    CHECK((earlier.position > both.tolerance || earlier.angle > both.angle_tolerance));
    CHECK(again.evaluations() < objective.evaluations());
  }
}

TEST_CASE("a damped step is (J^T J + mu I)^-1 J^T e, and the gain ratio sets the next damping", "[pose][dls]") {
  const bool is_pose = GENERATE(true, false);
  ReachablePose task(is_pose ? "ur5e" : "planar_2", 1, weight);
  task.problem.start.setConstant(0.4);
  task.goal = Goal(task.arm.chain.forward(task.problem.start), weight, is_pose ? GoalKind::pose : GoalKind::position);
  task.goal = moved(task.goal, {0.05, -0.04, 0.03}, 0.5, Eigen::Vector3d(1, -2, 0.5).normalized());
  if (!is_pose) task.goal.target.translation().z() = 0;
  RecordingObjective objective(task.arm.chain, task.goal);
  Random random{Key(1)};
  const auto descent = solver("damped_least_squares").make({{"damping", 0.1}});
  descent->start(task.problem, objective, random);
  Eigen::VectorXd q = objective.candidates.front();
  Objective by_hand(task.arm.chain, task.goal);
  Eigen::MatrixXd J(by_hand.rows(), q.size()), ignored = J;
  double mu = 0;
  for (int iteration = 0; iteration < 4; ++iteration) {
    const Eigen::VectorXd e = by_hand.linearize(q, J).to_go;
    const Eigen::MatrixXd A = J.transpose() * J;
    if (iteration == 0) mu = 0.1 * A.diagonal().maxCoeff();
    const Eigen::VectorXd gradient = J.transpose() * e;
    const Eigen::VectorXd h = (A + mu * Eigen::MatrixXd::Identity(q.size(), q.size())).llt().solve(gradient);
    descent->step(objective, random);
    const Eigen::VectorXd candidate = (q + h).cwiseMax(task.problem.lower).cwiseMin(task.problem.upper);
    REQUIRE((objective.candidates.back() - candidate).norm() < 1e-12);
    const double norm = by_hand.linearize(candidate, ignored).to_go.norm();
    REQUIRE(norm < e.norm());
    const double gain = (e.squaredNorm() - norm * norm) / h.dot(mu * h + gradient);
    mu *= std::max(1.0 / 3, 1 - std::pow(2 * gain - 1, 3));
    q = candidate;
  }
}
