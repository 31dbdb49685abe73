// The searches of the Robotics Toolbox: their steps by hand, their end, their starts and their limits.
#include <Eigen/LU>
#include <Eigen/SVD>
#include <vector>

#include "numerics/numpy_random.hpp"
#include "tests/catch.hpp"
#include "tests/solvers/objectives.hpp"
#include "tests/solvers/pseudo_inverse.hpp"

using namespace ikbench;
using namespace ikbench::numerics;
using namespace ikbench::robots;
using namespace ikbench::solvers;

namespace {

// The residual [m, rad] at q, and the Jacobian.
Eigen::VectorXd residual_at(const ReachablePose& task, const Eigen::VectorXd& q, Matrix6Xd& J) {
  J.resize(6, q.size());
  const Pose reached = task.arm.chain.pose_jacobian(q, J);
  const Eigen::AngleAxisd turn(task.goal.target.linear() * reached.linear().transpose());
  Eigen::VectorXd e(6);
  e << task.goal.target.translation() - reached.translation(), turn.angle() * turn.axis();
  return e;
}

}  // namespace

TEST_CASE("a step of each method of the Robotics Toolbox is that of its equation", "[toolbox]") {
  struct Case {
    Settings settings;
    Eigen::MatrixXd (*inverse)(const Eigen::MatrixXd& J, double E);  // the matrix before e
  };
  const auto damped = [](const Eigen::MatrixXd& J, double W) -> Eigen::MatrixXd {
    return (J.transpose() * J + W * Eigen::MatrixXd::Identity(J.cols(), J.cols())).inverse() * J.transpose();
  };
  static const auto levenberg = damped;
  const std::vector<Case> cases{
      {{{"method", "newton"}}, [](const Eigen::MatrixXd& J, double) { return pseudo_inverse(J); }},
      {{{"method", "newton"}, {"inverse", "exact"}},
       [](const Eigen::MatrixXd& J, double) -> Eigen::MatrixXd { return J.inverse(); }},
      {{{"method", "gauss_newton"}}, [](const Eigen::MatrixXd& J, double) { return pseudo_inverse(J); }},
      {{{"method", "gauss_newton"}, {"inverse", "exact"}},
       [](const Eigen::MatrixXd& J, double) { return levenberg(J, 0); }},
      {{{"method", "chan"}, {"damping", "0.1"}},
       [](const Eigen::MatrixXd& J, double E) { return levenberg(J, 0.1 * E); }},
      {{{"method", "sugihara"}, {"damping", "0.1"}},
       [](const Eigen::MatrixXd& J, double E) { return levenberg(J, E + 0.1); }},
      {{{"method", "wampler"}, {"damping", "0.1"}},
       [](const Eigen::MatrixXd& J, double) { return levenberg(J, 0.1); }}};
  for (const Case& each : cases) {
    const ReachablePose task("abb_irb120", 3, 1);
    RecordingObjective recorded(task.arm.chain, task.goal);
    Random random{Key(1)};
    const auto searches = solver("robotics_toolbox").make(each.settings);
    Problem problem = task.problem;
    problem.start[4] += 0.5;  // away from the wrist's singular configuration
    searches->start(problem, recorded, random);
    searches->step(recorded, random);
    searches->step(recorded, random);
    REQUIRE(recorded.linearized.size() == 2);
    const Eigen::VectorXd q = recorded.linearized[0];
    Matrix6Xd J;
    const Eigen::VectorXd e = residual_at(task, q, J);
    INFO(each.settings.begin()->second);
    CHECK(same(q, problem.start));
    CHECK((recorded.linearized[1] - (q + each.inverse(J, e.squaredNorm() / 2) * e)).norm() < 1e-8);
  }
}

TEST_CASE("a search of the Robotics Toolbox tests the error before its last step, and takes the step", "[toolbox]") {
  const ReachablePose task("abb_irb120", 5, 1);
  const auto answer_with = [&](const char* last_step) {
    RecordingObjective recorded(task.arm.chain, task.goal);
    Random random{Key(1)};
    const auto searches =
        solver("robotics_toolbox").make({{"last_step", last_step}, {"limits", "ignored"}, {"steps", "500"}});
    const Solution solution = solve(*searches, task.problem, recorded, random, {.iterations = 100'000});
    REQUIRE(solution.stopped == Stopped::finished);
    CHECK(solution.evaluations == solution.iterations + 2);  // and those of the start and of the answer
    Matrix6Xd J;
    const Eigen::VectorXd before = residual_at(task, recorded.linearized.back(), J);
    CHECK(before.squaredNorm() / 2 < 1e-6);
    const Eigen::VectorXd after = residual_at(task, solution.best.q, J);
    return std::pair(before.norm(), after.norm());
  };
  const auto [before, after] = answer_with("taken");
  CHECK(after < before / 10);  // the step converges quadratically here
  const auto [reached, same_place] = answer_with("dropped");
  CHECK(same_place == Approx(reached));
}

TEST_CASE("searches of the Robotics Toolbox fail after their steps, begin again, and give up", "[toolbox]") {
  Task task = planar_task(1);
  task.target = {3, 0, 0};  // out of reach
  RecordingObjective recorded(task.chain, task.target);
  Random random{Key(1)}, drawn{Key(1)};
  const auto searches = solver("robotics_toolbox").make({{"steps", "3"}, {"searches", "4"}});
  const Solution solution = solve(*searches, task.problem, recorded, random, {.iterations = 1000});
  CHECK(solution.stopped == Stopped::gave_up);
  CHECK(solution.iterations == 12);
  CHECK(solution.restarts == 3);
  CHECK(solution.best.q == task.problem.start);
  for (const std::size_t start : {3u, 6u, 9u}) {
    for (Eigen::Index j = 0; j < 2; ++j) CHECK(recorded.linearized[start][j] == drawn.uniform(-1, 1));
  }
  CHECK(random.uniform() == drawn.uniform());
  searches->step(recorded, random);
  CHECK(recorded.evaluations() == solution.evaluations);  // a step after that does nothing
}

TEST_CASE("a search of the Robotics Toolbox that ends outside the limits fails where they are required", "[toolbox]") {
  Task task = planar_task(1);
  task.target = task.chain.position(Eigen::Vector2d(2, -1.5));  // both solutions are outside
  for (const bool are_required : {true, false}) {
    Objective objective(task.chain, task.target);
    Random random{Key(1)};
    const auto searches = solver("robotics_toolbox").make({{"limits", are_required ? "required" : "ignored"}});
    const Solution solution = solve(*searches, task.problem, objective, random, {.iterations = 10'000});
    CHECK(solution.stopped == (are_required ? Stopped::gave_up : Stopped::finished));
    if (are_required) continue;
    CHECK(solution.best.error < 2e-3);
    CHECK((solution.best.q.array().abs() <= 3.1416).all());  // turned into [-180, 180) deg
  }
}

TEST_CASE("searches may begin at NumPy's list, the same for all targets", "[toolbox]") {
  Task task = planar_task(1);
  task.target = {3, 0, 0};  // out of reach
  for (int solved = 0; solved < 2; ++solved) {
    RecordingObjective recorded(task.chain, task.target);
    Random random{Key(7)}, untouched{Key(7)};
    const auto searches = solver("robotics_toolbox")
                              .make({{"steps", "1"},
                                     {"searches", "3"},
                                     {"starts", "numpy"},
                                     {"starts_seed", "10"},
                                     {"starts_skipped", "4"}});
    solve(*searches, task.problem, recorded, random, {.iterations = 1000});
    NumpyRandom numpy(10, 4);
    REQUIRE(recorded.linearized.size() == 3);
    for (const Eigen::VectorXd& start : recorded.linearized) {
      for (const double angle : start) CHECK(angle == numpy.uniform(-1, 1));
    }
    CHECK(random.uniform() == untouched.uniform());
  }
}
