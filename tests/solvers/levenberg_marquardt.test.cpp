// Levenberg and Marquardt's method: its steps by hand, its end, and its restarts.
#include "tests/solvers/objectives.hpp"

TEST_CASE("a step is (J^T J + W)^-1 J^T e with the damping of each rule, in metres and radians", "[lm]") {
  struct Case {
    std::string rule;
    double (*damping)(double E);  // with the factor or term 0.1
  };
  const std::vector<Case> cases{{"chan", [](double E) { return 0.1 * E; }},
                                {"sugihara", [](double E) { return E + 0.1; }},
                                {"wampler", [](double) { return 0.1; }}};
  for (const auto& [rule, damping] : cases) {
    for (const double weight : {0.3, 4.0}) {  // for any weight of a radian
      const ReachablePose task("franka_panda", 3, weight);
      RecordingObjective recorded(task.arm.chain, task.goal);
      Random random{Key(1)};
      const auto descent =
          solver("levenberg_marquardt").make({{"rule", rule}, {"damping", 0.1}, {"bounds", "initial"}});
      descent->start(task.problem, recorded, random);
      for (int iteration = 0; iteration < 4; ++iteration) {
        const Eigen::VectorXd q = recorded.candidates.back();
        const auto [J, e] = linearized(task, q);
        const double W = damping(e.squaredNorm() / 2);
        const Eigen::MatrixXd A = J.transpose() * J + W * Eigen::MatrixXd::Identity(q.size(), q.size());
        descent->step(recorded, random);
        INFO(rule << ", " << weight << ", " << iteration);
        const Eigen::VectorXd gradient = J.transpose() * e, step = A.llt().solve(gradient);
        REQUIRE((recorded.candidates.back() - (q + step)).norm() < 1e-9);
      }
    }
  }
}

TEST_CASE("Levenberg and Marquardt's method takes a step that makes it worse, within the limits", "[lm]") {
  const Task task = planar_task(1);
  RecordingObjective objective(task.chain, std::vector<double>{0.5});  // every later candidate is worse
  Random random{Key(1)};
  const auto descent =
      solver("levenberg_marquardt").make({{"rule", "wampler"}, {"damping", 1e-6}, {"bounds", "clamp"}});
  descent->start(task.problem, objective, random);
  for (int iteration = 0; iteration < 3; ++iteration) {
    descent->step(objective, random);
    CHECK((objective.candidates.back().array().abs() <= 1).all());
  }
  CHECK(descent->best().q == task.problem.start);
  CHECK(descent->best().error == 0.5);
}

TEST_CASE("a search of Levenberg and Marquardt's method begins again where no joint moves any more", "[lm]") {
  Task task = planar_task(1);
  task.target = {-0.9, -0.1, 0};                                                      // both joints go to their limits
  for (const auto& [small_move, restarts] : {std::pair(1e-9, true), {0.0, false}}) {  // 0: never
    Objective objective(task.chain, task.target);
    Random random{Key(1)};
    const auto descent = solver("levenberg_marquardt")
                             .make({{"search_iterations", 1e6}, {"small_move", small_move}, {"bounds", "clamp"}});
    solve(*descent, task.problem, objective, random, {.iterations = 100});
    CHECK((descent->restarts() > 0) == restarts);
  }
}

TEST_CASE("a search of Levenberg and Marquardt's method begins again where it is at the target, outside the limits",
          "[lm]") {
  for (const auto& [error, restarts] : {std::pair(0.01, 1), {0.011, 0}}) {
    Task task = planar_task(1);
    task.problem.stop.tolerance = 0.01;
    RecordingObjective objective(task.chain, std::vector<double>{0.5, error});
    Random random{Key(1)};
    const auto descent =
        solver("levenberg_marquardt").make({{"rule", "wampler"}, {"damping", 0.01}, {"bounds", "free"}});
    descent->start(task.problem, objective, random);
    descent->step(objective, random);
    REQUIRE((objective.candidates.back().array().abs() > 1).any());
    descent->step(objective, random);
    CHECK(descent->restarts() == restarts);
  }
}

TEST_CASE("a search of Levenberg and Marquardt's method begins again after steps without a smaller residual", "[lm]") {
  Task task = planar_task(1);
  task.target = {2, 0, 0};  // out of reach, so that steps overshoot
  RecordingObjective objective(task.chain, task.target);
  Random random{Key(1)}, drawn{Key(1)};
  const auto descent = solver("levenberg_marquardt").make({{"bounds", "initial"}});
  solve(*descent, task.problem, objective, random, {.iterations = 100});
  double least = objective.given[0];
  int failures = 0, restarts = 0;
  for (std::size_t i = 1; i < objective.given.size(); ++i) {
    const bool is_drawn = failures == 3;
    failures = is_drawn || objective.given[i] < least ? 0 : failures + 1;
    least = is_drawn ? objective.given[i] : std::min(least, objective.given[i]);
    restarts += is_drawn ? 1 : 0;
    for (Eigen::Index j = 0; j < 2 && is_drawn; ++j) CHECK(objective.candidates[i][j] == drawn.uniform(-1, 1));
  }
  CHECK(restarts > 2);
  CHECK(descent->restarts() == restarts);
}

TEST_CASE("a free search ends outside where it is outside by more than its last steps", "[lm]") {
  const Task task = planar_task(1);  // from -1 to 1
  const auto ends = [](const Problem& problem, double q, double step) {
    return ends_outside(problem, Eigen::Vector2d(0, q), Eigen::Vector2d(step, 0));
  };
  CHECK(ends(task.problem, 1.5, 0.1));
  CHECK(ends(task.problem, -1.5, -0.1));
  CHECK_FALSE(ends(task.problem, 1.5, 0.2));
  CHECK_FALSE(ends(task.problem, 1, 0));
  CHECK_FALSE(ends({.start = task.problem.start,
                    .lower = Eigen::Vector2d::Constant(-std::numeric_limits<double>::infinity()),
                    .upper = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity())},
                   1e3, 0));
}

TEST_CASE("Levenberg and Marquardt's method solves most reachable poses within the limits, by each rule", "[lm]") {
  for (const Settings& settings :
       {Settings{}, Settings{{"bounds", "clamp"}}, Settings{{"rule", "sugihara"}, {"damping", 1e-4}},
        Settings{{"rule", "wampler"}, {"damping", 1e-4}}}) {
    int solved = 0;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const ReachablePose task("abb_irb120", seed);
      RecordingObjective objective(task.arm.chain, task.goal);
      const Solution solution =
          solve_by("levenberg_marquardt", settings, task.problem, objective, {.iterations = 1000});
      for (const Eigen::VectorXd& q : objective.candidates)
        if (settings.contains("bounds")) REQUIRE(task.arm.limits.violation(q) == 0);
      solved += solution.best.error <= 1e-9 ? 1 : 0;
    }
    CHECK(solved > 40);
  }
}
