// Damped least squares: its steps by hand, its convergence and its restarts.
#include <Eigen/Eigenvalues>

#include "tests/solvers/objectives.hpp"

TEST_CASE("a step that makes it worse is undone, and damped by 2, 4, 8 and so on", "[dls]") {
  const Task task = planar_task(1);
  RecordingObjective objective(task.chain, std::vector<double>{0.5});  // every later candidate is worse
  Random random{Key(1)};
  const auto descent = solver("damped_least_squares").make({{"damping", 1.0}, {"bounds", "clamp"}});
  descent->start(task.problem, objective, random);
  const Eigen::VectorXd start = task.problem.start;
  Eigen::Matrix3Xd J(3, 2);
  task.chain.position_jacobian(start, J);
  const Eigen::Matrix2d A = J.transpose() * J;
  const Eigen::Vector2d gradient = -J.transpose() * task.chain.position(start);  // a scripted objective's target is 0
  double mu = A.diagonal().maxCoeff();
  for (const double growth : {2, 4, 8, 16}) {
    descent->step(objective, random);
    const Eigen::Vector2d h = (A + mu * Eigen::Matrix2d::Identity()).inverse() * gradient;
    CHECK((objective.candidates.back() - (start + h).cwiseMax(-1).cwiseMin(1)).norm() < 1e-14);
    mu *= growth;
  }
  CHECK(descent->best().error == 0.5);
}

TEST_CASE("damped least squares places the iiwa's wrist to 1e-14 m within 20 steps", "[dls]") {
  const Task task = iiwa_task();
  Objective objective(task.chain, task.target);
  CHECK(solve_by("damped_least_squares", {}, task.problem, objective, {.iterations = 20}).best.error < 1e-14);
}

TEST_CASE("damped least squares restarts at random where it is stuck, and only there", "[dls]") {
  Task task = iiwa_task();
  const JointLimits limits{task.problem.lower, task.problem.upper};
  for (const bool reachable : {true, false}) {
    if (!reachable) task.target = {2, 0, 0};
    RecordingObjective objective(task.chain, task.target);
    Random random{Key(1)}, untouched{Key(1)};
    const Solution solution = solve(*solver("damped_least_squares").make({{"bounds", "clamp"}}), task.problem,
                                    objective, random, {.iterations = 200});
    CHECK((random.uniform() == untouched.uniform()) == reachable);
    CHECK((solution.restarts == 0) == reachable);
    for (const Eigen::VectorXd& q : objective.candidates) REQUIRE(limits.violation(q) == 0);
  }
}

TEST_CASE("damped least squares does not depend on the population", "[dls]") {
  const Task few = iiwa_task(1), many = iiwa_task(100);
  Objective first(few.chain, few.target), second(many.chain, many.target);
  CHECK(solve_by("damped_least_squares", {}, few.problem, first, {.iterations = 10}).best.q ==
        solve_by("damped_least_squares", {}, many.problem, second, {.iterations = 10}).best.q);
}

TEST_CASE("damped least squares starts at the limits where the arm is outside them", "[dls]") {
  Task task = planar_task(1);
  task.problem.start = Eigen::Vector2d(1.5, -0.2);
  RecordingObjective objective(task.chain, task.target);
  Random random{Key(1)};
  solver("damped_least_squares").make({})->start(task.problem, objective, random);
  CHECK(objective.candidates.front() == Eigen::Vector2d(1, -0.2));
}

TEST_CASE("damped least squares begins again where its shrinking steps would end outside the limits", "[dls]") {
  Task task = planar_task(1);
  task.target = task.chain.position(Eigen::Vector2d(1.2, -1.8));
  RecordingObjective objective(task.chain, task.target);
  Random random{Key(1)};
  const auto descent = solver("damped_least_squares").make({{"bounds", "free"}});
  descent->start(task.problem, objective, random);
  double error_before_restart = 0;
  for (int trial = 0; trial < 20 && descent->restarts() == 0; ++trial) {
    error_before_restart = objective.given.back();
    descent->step(objective, random);
  }
  CHECK(descent->restarts() == 1);
  CHECK(error_before_restart > 1e-4);  // it did not go on until the target was reached
}

TEST_CASE("a damped step gives a bound of the eigenvalues, and none where it may have lost its digits", "[dls]") {
  Random random{Key(1)};
  int bounded = 0;
  for (const int rows : {3, 6}) {
    for (int repeat = 0; repeat < 100; ++repeat) {
      Eigen::MatrixXd J = drawn_uniforms(random, rows, 7);
      Configuration step;
      const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(J * J.transpose()).eigenvalues();
      const double bound = damped_step(J, Residual::Ones(rows), 0, step);
      CHECK(bound <= values[0] * (1 + 1e-12));
      if (bound > 0) CHECK((J * step - Eigen::VectorXd::Ones(rows)).norm() < 1e-7);
      bounded += bound > 0;
      J.row(1) = J.row(0);
      CHECK(damped_step(J, Residual::Ones(rows), 0, step) == 0);
    }
  }
  CHECK(bounded > 150);
}
