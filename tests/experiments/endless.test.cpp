// Arms with continuous joints: the problems that solvers get, their answers, and the joint motion.
#include "tests/experiments/samples.hpp"

namespace {

constexpr double half = std::numbers::pi;

}  // namespace

TEST_CASE("no solver's answer is held at half a turn from the start", "[endless]") {
  const Study study = load_study("tests/data/endless.toml");
  const Robot arm = robot_of(study);
  std::map<std::string, int> held, beyond;
  solve_without_store(study, 1, [&](const SolveRecord& solve) {
    CHECK(solve.largest_move_deg <= 180 * (1 + 1e-12));
    CHECK(solve.status != Status::limit_violated);
    for (Eigen::Index j = 0; j < arm.joints(); ++j) {
      if (std::isfinite(arm.limits.lower[j])) continue;
      const auto at = static_cast<std::size_t>(j);
      const double moved = std::abs(solve.answer_rad[at] - solve.start_rad[at]);
      held[solve.label] += std::abs(moved - half) < 1e-9 ? 1 : 0;
      beyond[solve.label] += moved > half ? 1 : 0;
    }
  });
  for (const SolverEntry& entry : study.solvers) {
    CAPTURE(entry.label);
    CHECK(held[entry.label] == 0);
  }
  for (const char* label : {"Newton", "wrapped", "DLS", "PSO"}) {
    CAPTURE(label);
    CHECK(beyond[label] > 0);
  }
}

TEST_CASE("a joint without end moves the shorter way round, and any other as far as it goes", "[endless][verifier]") {
  Robot arm = robot("planar_2");
  arm.limits = {Eigen::Vector2d(-infinity, -9), Eigen::Vector2d(infinity, 9)};
  const Eigen::VectorXd start = Eigen::Vector2d(0.5, 0.5);
  const auto verified = [&](double first, double second) {
    return verify(arm, {.target = Pose::Identity(),
                        .start = start,
                        .answer = Eigen::VectorXd(start + Eigen::Vector2d(first, second))});
  };
  CHECK(verified(2 * half + 0.3, 0).joint_motion == Approx(0.3));
  CHECK(verified(-4 * half - 0.3, 0).largest_move == Approx(0.3));
  CHECK(verified(1.5 * half, 0).joint_motion == Approx(half / 2));
  CHECK(verified(3, 0).joint_motion == 3);
  CHECK(verified(0, 1.5 * half).joint_motion == Approx(1.5 * half));
  CHECK(verified(100, 0).limit_violation == 0);
}

TEST_CASE("a program gets null for no limit, a whole turn each way to search in, and a rotation by rows", "[endless]") {
  const Robot arm = robot("kinova_gen3");
  const nlohmann::json robot_told =
      nlohmann::json::parse(robot_message({.arm = arm, .searched = arm.chain, .goal = Eigen::Vector3d(0, 0, 0)}));
  CHECK(robot_told["joints"][0]["lower"].is_null());
  CHECK(robot_told["joints"][1]["upper"] == arm.limits.upper[1]);
  const Problem problem{
      .start = Configuration::Constant(7, 0.2), .lower = arm.limits.lower, .upper = arm.limits.upper, .population = 20};
  const nlohmann::json message =
      nlohmann::json::parse(solve_message(problem, Eigen::Vector3d(0, 0, 0.5), {.iterations = 1000}, 1));
  CHECK(message["lower"][0] == 0.2 - 2 * half);
  CHECK(message["upper"][0] == 0.2 + 2 * half);
  CHECK(message["upper"][1] == arm.limits.upper[1]);
  CHECK(message["budget"]["iterations"] == 1000);
  CHECK_FALSE(message.contains("state"));
  const Goal pose{arm.chain.forward(Configuration::Constant(7, 0.7)), 0.25, GoalKind::pose};
  const nlohmann::json of_pose = nlohmann::json::parse(solve_message(problem, pose, {}, 1));
  CHECK(of_pose["target"]["rotation"] == row_major(pose.target.linear()));
}
