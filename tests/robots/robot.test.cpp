#include "tests/robots/random_configuration.hpp"

TEST_CASE("every robot is found by its name, names its source, and has limits for each joint", "[robot]") {
  for (const Robot& arm : all_robots()) {
    CAPTURE(arm.name);
    CHECK(robot(arm.name).name == arm.name);
    CHECK_FALSE(arm.summary.empty());
    CHECK(arm.summary.size() <= 80);  // a line
    CHECK_FALSE(arm.source.empty());
    CHECK(arm.limits.lower.size() == arm.chain.joints());
    CHECK(arm.limits.upper.size() == arm.chain.joints());
    CHECK((arm.limits.lower.array() < arm.limits.upper.array()).all());
  }
}

TEST_CASE("a misspelt robot is told the nearest name", "[robot]") {
  CHECK_THROWS_WITH(robot("kuka_iiwa"), StartsWith("unknown robot \"kuka_iiwa\"; did you mean \"kuka_iiwa7\"? "
                                                   "There are: abb_irb120, abb_yumi_left, "));
  CHECK_THROWS_AS(robot(""), std::invalid_argument);
}

TEST_CASE("the iiwa's limits are those of Table 2", "[robot][paper]") {
  const JointLimits limits = robot("kuka_iiwa14").limits;
  const Eigen::Vector<double, 7> degrees{170, 120, 170, 120, 170, 120, 175};
  CHECK((limits.upper * 180 / std::numbers::pi - degrees).cwiseAbs().maxCoeff() < 1e-13);
  CHECK(limits.lower == -limits.upper);
}

TEST_CASE("a violation is how far the worst joint is outside", "[robot]") {
  const JointLimits limits{Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 2, 1)};
  CHECK(limits.violation(Eigen::Vector3d(0, 0, 0)) == 0);
  CHECK(limits.violation(Eigen::Vector3d(-1, 2, 1)) == 0);
  CHECK(limits.violation(Eigen::Vector3d(1.25, 0, -1.5)) == 0.5);
  CHECK(limits.violation(Eigen::Vector3d(1.25, 0, -1.125)) == 0.25);
}
