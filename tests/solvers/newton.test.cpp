// Newton's method: its steps by hand, its end, and its restarts.
#include <Eigen/Eigenvalues>

#include "tests/solvers/objectives.hpp"

TEST_CASE("a step of Newton's method is J^+ times what is to go, in metres and radians", "[newton]") {
  for (const std::string name : {"abb_irb120", "franka_panda"}) {
    for (const double weight : {0.05, 1.0, 4.0}) {  // for any weight of a radian
      ReachablePose task(name, 3, weight);
      task.problem.start.array() += 0.3;  // in the middle of its limits the arm is singular
      RecordingObjective recorded(task.arm.chain, task.goal);
      Random random{Key(1)};
      const auto newton = solver("newton").make({{"bounds", "initial"}});
      newton->start(task.problem, recorded, random);
      for (int iteration = 0; iteration < 4; ++iteration) {
        const Eigen::VectorXd q = recorded.candidates.back();
        const auto [J, to_go] = linearized(task, q);
        const Eigen::MatrixXd A = J * J.transpose();
        const Eigen::VectorXd solved = A.llt().solve(to_go), step = J.transpose() * solved;  // J has all its rows
        newton->step(recorded, random);
        REQUIRE((recorded.candidates.back() - (q + step)).norm() < 1e-9 * (1 + step.norm()));
      }
    }
  }
}

TEST_CASE("J^+ r and the undamped step are those of an orthogonal decomposition, whatever the rank", "[newton]") {
  Random random{Key(1)};
  for (const int rows : {3, 6}) {
    for (int joints = 1; joints <= 9; ++joints) {
      for (int rank = 1; rank <= std::min(rows, joints); ++rank) {
        for (const double scale : {1e-3, 1.0, 1e3}) {  // of some rows against the others
          CAPTURE(rows, joints, rank, scale);
          const auto centred = [&](int height, int width) {
            return Eigen::MatrixXd(drawn_uniforms(random, height, width).array() - 0.5);
          };
          Eigen::MatrixXd J = centred(rows, rank) * centred(rank, joints);
          J.topRows(rows / 2) *= scale;
          const Residual r = centred(rows, 1);
          const Eigen::MatrixXd inverse = pseudo_inverse(J);
          const Eigen::VectorXd expected = inverse * r;
          CHECK((pseudo_inverse_times(J, r, 0) - expected).norm() < 1e-9 * expected.norm());
          Configuration step;
          const double smallest = damped_step(J, r, 0, step);
          if (rank < std::min(rows, joints)) {
            CHECK(smallest == 0);
          } else if (smallest > 0) {
            CHECK((step - expected).norm() < 1e-7 * expected.norm());
            CHECK(smallest <= std::pow(inverse.operatorNorm(), -2) * (1 + 1e-9));  // the smallest singular value
          }
        }
      }
    }
  }
}

TEST_CASE("a step of an arm with fewer joints than rows needs no singular values", "[newton]") {
  for (const char* const name : {"fanuc_m430ia2f", "dobot_magician"}) {
    ReachablePose task(name, 1);
    Objective objective(task.arm.chain, task.goal);
    Eigen::MatrixXd J(6, task.arm.joints());
    const Configuration q = task.problem.start.array() + 0.3;
    const Linearized linearized = linearize_twist(objective, q, J);
    REQUIRE(J.cols() < J.rows());
    Configuration step;
    CHECK(damped_step(J, linearized.to_go, 0, step) > 1e-10);
    CHECK((step - pseudo_inverse(J) * linearized.to_go).norm() < 1e-9 * step.norm());
  }
}

TEST_CASE("a step leaves out what the Jacobian cannot do, and ends at the limits", "[newton]") {
  // Stretched along x, the planar arm moves along y alone: J = (0 0; 1 0.5), and J^+ (x, y) = (0.8, 0.4) y.
  Task task = planar_task(1);
  task.problem.start.setZero();
  task.target = {0.7, 0.5, 0};
  RecordingObjective objective(task.chain, task.target);
  Random random{Key(1)};
  const auto newton = solver("newton").make({});
  newton->start(task.problem, objective, random);
  newton->step(objective, random);
  CHECK((objective.candidates.back() - Eigen::Vector2d(0.4, 0.2)).norm() < 1e-15);
  task.target.y() = 20;  // (16, 8) rad
  RecordingObjective far(task.chain, task.target);
  newton->start(task.problem, far, random);
  newton->step(far, random);
  CHECK(far.candidates.back() == task.problem.upper);
}

TEST_CASE("Newton's, and Levenberg and Marquardt's method end at the pose, and say so", "[newton][lm]") {
  for (const auto& [name, restarts] :
       {std::pair("newton", Settings{{"restarts", "none"}}), {"newton", {}}, {"levenberg_marquardt", {}}}) {
    ReachablePose task("franka_panda", 5);
    task.problem.start = task.problem.start * 0.9;
    Objective objective(task.arm.chain, {task.arm.chain.forward(task.problem.start * 1.02), 0.3});
    Random random{Key(1)}, untouched{Key(1)};
    const auto descent = solver(name).make(restarts);
    const Solution solution = solve(*descent, task.problem, objective, random, {.iterations = 100});
    CHECK(solution.stopped == StopReason::finished);
    CHECK(solution.iterations < 10);
    CHECK(solution.best.error <= 1e-9);
    CHECK(random.uniform() == untouched.uniform());
    descent->step(objective, random);
    CHECK(objective.evaluations() == solution.evaluations);  // a step after that does nothing
  }
}

TEST_CASE("where no joint moves any more Newton's method ends, or starts again at random", "[newton]") {
  Task task = planar_task(1);
  task.target = {-0.9, -0.1, 0};  // both joints go to their limits
  Objective objective(task.chain, task.target);
  Random random{Key(1)}, untouched{Key(1)};
  const Solution stuck =
      solve(*solver("newton").make({{"restarts", "none"}}), task.problem, objective, random, {.iterations = 50});
  CHECK(stuck.stopped == StopReason::finished);
  CHECK(stuck.iterations < 50);
  CHECK(random.uniform() == untouched.uniform());
  RecordingObjective recorded(task.chain, task.target);
  const Solution again = solve(*solver("newton").make({}), task.problem, recorded, random, {.iterations = 50});
  CHECK(again.stopped == StopReason::iterations);
  const JointLimits limits{task.problem.lower, task.problem.upper};
  for (const Eigen::VectorXd& q : recorded.candidates) REQUIRE(limits.violation(q) == 0);
  CHECK(random.uniform() != untouched.uniform());
}

TEST_CASE("a search begins again at random after its iterations, if it has a number of them", "[newton][lm]") {
  for (const auto& [name, search, x] :
       {std::tuple("newton", 0.0, -0.9), {"newton", 3.0, -0.9}, {"levenberg_marquardt", 3.0, 2.0}}) {
    CAPTURE(name, search);
    Task task = planar_task(1);
    task.target = {x, -0.1, 0};  // both joints go to their limits; or it is out of reach
    RecordingObjective objective(task.chain, task.target);
    Random random{Key(1)}, drawn{Key(1)};
    const auto descent = solver(name).make({{"search_iterations", search}, {"small_move", 0.0}});
    solve(*descent, task.problem, objective, random, {.iterations = 9});
    REQUIRE(objective.candidates.size() == 10);
    for (const std::size_t start : search == 0 ? std::vector<std::size_t>{} : std::vector<std::size_t>{4, 8}) {
      for (Eigen::Index j = 0; j < 2; ++j) CHECK(objective.candidates[start][j] == drawn.uniform(-1, 1));
    }
    CHECK(descent->restarts() == (search == 0 ? 0 : 2));
    CHECK(random.uniform() == drawn.uniform());
  }
}

TEST_CASE("with restarts Newton's method solves more poses, and most if it turns joints back inside", "[newton]") {
  int solved_by_kdl = 0, with_restarts = 0, with_both = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const ReachablePose task("abb_irb120", seed);
    const auto is_solved = [&](const Settings& settings) {
      RecordingObjective objective(task.arm.chain, task.goal);
      const Solution solution = solve_by("newton", settings, task.problem, objective, {.iterations = 400});
      for (const Eigen::VectorXd& q : objective.candidates) REQUIRE(task.arm.limits.violation(q) == 0);
      return solution.best.error < 1e-9 ? 1 : 0;
    };
    solved_by_kdl += is_solved({{"restarts", "none"}});
    with_restarts += is_solved({});
    with_both += is_solved({{"bounds", "wrap"}});
  }
  // Beeson and Ames print 39.41 % and 98.48 % for KDL and KDL-RR, which does both; 4 standard errors of 100 poses.
  CHECK(std::abs(solved_by_kdl - 39.41) < 20);
  CHECK(with_restarts > solved_by_kdl);
  CHECK(with_both > with_restarts);
  CHECK(with_both > 93);
}

TEST_CASE("a joint that turns is turned back inside by whole turns, one that slides is clamped", "[newton]") {
  // A slide along z, and a metre that turns about z: from zeros one moves along z alone, the other along y.
  const Chain chain({{.d = 0, .joint = Joint::slides}, {.a = 1}});
  const auto second = [&](double height, double turn, double limit) -> Eigen::VectorXd {
    RecordingObjective objective(chain,
                                 Eigen::Vector3d(1, turn, height));  // from (1, 0, 0): the step is (height, turn)
    Random random{Key(1)};
    const auto newton = solver("newton").make({{"bounds", "wrap"}});
    newton->start(
        {.start = Eigen::Vector2d::Zero(), .lower = Eigen::Vector2d(-1, -limit), .upper = Eigen::Vector2d(1, limit)},
        objective, random);
    newton->step(objective, random);
    return objective.candidates.back();
  };
  constexpr double turn = 2 * std::numbers::pi;
  CHECK((second(0.5, 2, 3) - Eigen::Vector2d(0.5, 2)).norm() < 1e-15);
  CHECK((second(7, 4, 3) - Eigen::Vector2d(1, 4 - turn)).norm() < 1e-14);
  CHECK((second(-7, -16, 3) - Eigen::Vector2d(-1, 3 * turn - 16)).norm() < 1e-14);
  CHECK((second(0, 3.1, 3) - Eigen::Vector2d(0, 3)).norm() < 1e-14);  // 3.1 - 2 pi is below -3: clamped
}
