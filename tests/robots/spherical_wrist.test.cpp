#include "tests/robots/random_configuration.hpp"

using std::numbers::pi;

namespace {

const Eigen::Vector3d at_rest = Eigen::Vector3d::Zero();
const Eigen::Vector4d some_arm(0.4, -0.7, 1.1, 0.9);

Eigen::VectorXd joined(const Eigen::VectorXd& arm, const Eigen::Vector3d& wrist) {
  Eigen::VectorXd q(arm.size() + 3);
  q << arm, wrist;
  return q;
}

double orientation_error(const Chain& chain, const Eigen::VectorXd& q, const Pose& wanted) {
  return (chain.forward(q).linear() - wanted.linear()).cwiseAbs().maxCoeff();
}

// The iiwa with its wrist turned the other way: twists 90, -90, 0, and offsets and a tool besides.
Chain opposite_sense() {
  std::vector<DhLink> links = robot("kuka_iiwa14").chain.links();
  std::swap(links[4].alpha, links[5].alpha);
  links[4].offset = 0.3;
  links[5].offset = -0.2;
  links[6].offset = 0.7;
  return Chain(links, {0.02, -0.01, 0.1});
}

void check_that_poses_come_back(const Chain& chain) {
  const JointLimits limits = robot("kuka_iiwa14").limits;
  const SphericalWrist wrist(chain);
  RandomConfigurations random;
  for (int trial = 0; trial < 10000; ++trial) {
    const Eigen::VectorXd q = random(limits);
    const Pose T = chain.forward(q);
    const Eigen::VectorXd q_arm = q.head(q.size() - 3);
    REQUIRE((wrist.arm().position(q_arm) - wrist.centre(T)).norm() < 1e-12);
    const auto both = wrist.angles(q_arm, T.linear(), at_rest);
    for (const Eigen::Vector3d& angles : both) {
      const Eigen::VectorXd answer = joined(q_arm, angles);
      REQUIRE(angles.cwiseAbs().maxCoeff() <= pi);
      REQUIRE((chain.position(answer) - T.translation()).norm() < 1e-12);
      REQUIRE(orientation_error(chain, answer, T) < 1e-12);
    }
  }
}

}  // namespace

TEST_CASE("position and orientation come back through both branches of a wrist, whatever is behind its last axis",
          "[wrist]") {
  check_that_poses_come_back(robot("kuka_iiwa14").chain);
  check_that_poses_come_back(opposite_sense());  // with offsets and a tool
  // As in Fetch: a length and a quarter turn to a tool whose z is not its roll axis.
  std::vector<DhLink> links = robot("kuka_iiwa14").chain.links();
  links[6].a = 0.03;
  links[6].alpha = -pi / 2;
  const Chain chain(links, {}, {{0.02, -0.01, 0.1}, {0.1, 0.2, 0.3}});
  REQUIRE(SphericalWrist::fits(chain));
  check_that_poses_come_back(chain);
  check_that_poses_come_back(Chain(links));
}

TEST_CASE("one of the wrist's branches is where it came from, the other (t5 + pi, -t6, t7 + pi)", "[wrist]") {
  const Robot arm = robot("kuka_iiwa14");
  const SphericalWrist wrist(arm.chain);
  RandomConfigurations random;
  for (int trial = 0; trial < 1000; ++trial) {
    const Eigen::VectorXd q = random(arm.limits);
    const auto both = wrist.angles(q.head(4), arm.chain.forward(q).linear(), at_rest);
    REQUIRE(both[0][1] >= 0);
    REQUIRE((both[q[5] >= 0 ? 0 : 1] - q.tail(3)).norm() < 1e-9);  // t5 and t7 are ill conditioned near t6 = 0
    REQUIRE(std::abs(both[0][1] + both[1][1]) < 1e-12);
    for (const int outer : {0, 2}) REQUIRE(std::abs(std::abs(both[0][outer] - both[1][outer]) - pi) < 1e-12);
  }
}

TEST_CASE("next to the singular wrist the orientation still comes back", "[wrist]") {
  for (const Chain& chain : {robot("kuka_iiwa14").chain, opposite_sense()}) {
    const SphericalWrist wrist(chain);
    const double middle_offset = chain.links()[5].offset;
    for (const double singular : {0.0, pi}) {
      for (const double off : {0.0, 1e-16, 1e-13, 1e-12, 2e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-3}) {
        CAPTURE(singular, off);
        const Pose T = chain.forward(joined(some_arm, {0.5, singular - off - middle_offset, -0.8}));
        for (const Eigen::Vector3d& angles : wrist.angles(some_arm, T.linear(), at_rest)) {
          CHECK(orientation_error(chain, joined(some_arm, angles), T) < 2e-12);
        }
      }
    }
  }
}

TEST_CASE("a singular wrist keeps the first of its angles where it is", "[wrist]") {
  const Chain chain = robot("kuka_iiwa14").chain;
  const Pose T = chain.forward(joined(some_arm, {0.5, 0, -0.8}));
  const auto both = SphericalWrist(chain).angles(some_arm, T.linear(), {0.2, 0, 0});
  CHECK(both[0][0] == Approx(0.2).epsilon(1e-15));
  for (const Eigen::Vector3d& angles : both) {  // t5 + t7 = 0.5 - 0.8 is all that the orientation fixes
    CHECK(std::abs(std::remainder(angles[0] + angles[2] + 0.3, 2 * pi)) < 1e-12);
  }
}

TEST_CASE("the wrist's centre is the tool point less the flange along the tool's axis, Eq. 15", "[wrist][paper]") {
  Pose down = Pose::Identity();
  down.linear() = Eigen::Vector3d(-1, 1, -1).asDiagonal();
  down.translation() = Eigen::Vector3d(0.6, 0.2, 0.1);
  const SphericalWrist wrist(robot("kuka_iiwa14").chain);
  CHECK((wrist.centre(down) - Eigen::Vector3d(0.6, 0.2, 0.226)).norm() < 1e-15);  // 0.1 + 0.126
}

TEST_CASE("a wrist bent beyond the limit of its middle joint violates it in both branches", "[wrist]") {
  const Robot arm = robot("kuka_iiwa14");
  const Pose T = arm.chain.forward(joined(some_arm, {1, 125 * pi / 180, 1}));
  for (const Eigen::Vector3d& angles : SphericalWrist(arm.chain).angles(some_arm, T.linear(), at_rest)) {
    CHECK(arm.limits.violation(joined(some_arm, angles)) == Approx(5 * pi / 180).epsilon(1e-9));  // limit 120 deg
  }
}

TEST_CASE("an arm without a spherical wrist is refused", "[wrist]") {
  CHECK_THROWS_WITH(SphericalWrist(robot("planar_3").chain),
                    "the last three axes of this arm do not form a spherical wrist");
  std::vector<DhLink> links = robot("kuka_iiwa14").chain.links();
  links[5].d = 0.01;
  CHECK_THROWS_WITH(SphericalWrist(Chain(links)), "the last three axes of this arm do not form a spherical wrist");
}

TEST_CASE("by how much a wrist is not spherical is told", "[wrist]") {
  const auto misfit = [](double length, double angle) {
    std::vector<DhLink> links = robot("kuka_iiwa14").chain.links();
    links[4].a = length;
    links[5].alpha += angle;
    return SphericalWrist::misfit(Chain(links));
  };
  CHECK(contains(misfit(0.0025, 0), "are 2.5 mm from a common point"));
  CHECK(contains(misfit(0, -pi / 180), "are 1 deg from right angles"));
  CHECK_FALSE(contains(misfit(0.0025, 0), "1.5707963267948966"));
  CHECK(contains(misfit(0, 4e-6), "0.000229 deg from right angles (with exact angles in its file, such as 1.57079632"));
  CHECK(misfit(0, 0).empty());
  CHECK(misfit(5e-11, 5e-11).empty());
  CHECK_FALSE(misfit(0, 2e-10).empty());
  CHECK(SphericalWrist::misfit(robot("planar_2").chain).empty());  // it has no three axes at the end
}

TEST_CASE("a wrist whose outer axes are opposite at zero has the closed form, too", "[wrist]") {
  std::vector<DhLink> links = robot("kuka_iiwa14").chain.links();
  for (const double sign : {1, -1}) {
    links[4].alpha = links[5].alpha = sign * pi / 2;
    const Chain chain(links, robot("kuka_iiwa14").chain.base(), robot("kuka_iiwa14").chain.tool());
    REQUIRE(SphericalWrist::fits(chain));
    const SphericalWrist wrist(chain);
    Dice dice;
    for (int trial = 0; trial < 100; ++trial) {
      const Eigen::VectorXd q = random_joints(chain, dice);
      const Pose pose = chain.forward(q);
      for (const Eigen::Vector3d& angles : wrist.angles(q.head(4), pose.linear(), Eigen::Vector3d::Zero())) {
        Eigen::VectorXd again(7);
        again << q.head(4), angles;
        REQUIRE((chain.forward(again).matrix() - pose.matrix()).cwiseAbs().maxCoeff() < 1e-13);
      }
    }
  }
}
