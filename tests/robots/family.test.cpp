#include "robots/family.hpp"

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "robots/robot.hpp"
#include "robots/urdf.hpp"
#include "tests/catch.hpp"
#include "tests/robots/random_configuration.hpp"

using namespace ikbench;
using namespace ikbench::robots;

namespace {

Family family_of(const char* name) { return robots::family_of(robot(name).chain); }

// A joint's axis in space: a point and a direction.
struct Axis {
  Eigen::Vector3d point, direction;
};

// From the motion of the tool by each joint that turns: p - tool = direction x motion.
std::vector<Axis> axes_at(const Chain& arm, const Configuration& q) {
  Eigen::Matrix<double, 6, Eigen::Dynamic> jacobian(6, arm.joints());
  const Pose tool = arm.pose_jacobian(q, jacobian);
  std::vector<Axis> axes;
  for (const auto& column : jacobian.colwise()) {
    const Eigen::Vector3d motion = column.head<3>(), direction = column.tail<3>();
    axes.push_back({tool.translation() + direction.cross(motion), direction});
  }
  return axes;
}

// The smallest sum of squared distances of a point from three axes.
double apart(const Axis& a, const Axis& b, const Axis& c) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Axis& axis : {a, b, c}) {
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - axis.direction * axis.direction.transpose();
    sum += across;
    right += across * axis.point;
  }
  const Eigen::Vector3d point = sum.ldlt().solve(right);
  double distance = 0;
  for (const Axis& axis : {a, b, c}) distance += axis.direction.cross(point - axis.point).squaredNorm();
  return distance;
}

}  // namespace

TEST_CASE("the family of an arm of the library", "[family]") {
  for (const char* six : {"puma560", "abb_irb120", "kuka_kr6", "stanford"}) {
    INFO(six);
    CHECK(family_of(six).name == "spherical wrist (4 to 6)");
    CHECK(family_of(six).has_closed_form);
  }
  for (const char* universal : {"ur3e", "ur5", "ur5e", "ur10e", "ur5_toolbox"}) {
    INFO(universal);
    CHECK(family_of(universal).name == "three parallel axes (2 to 4), offset wrist");
    CHECK(family_of(universal).closed_form == "known (Pieper 1968; Hawkins 2013 for Universal Robots)");
  }
  for (const char* iiwa : {"kuka_iiwa7", "kuka_iiwa14", "kuka_iiwa7_endless"}) {
    INFO(iiwa);
    CHECK(family_of(iiwa).name ==
          "spherical shoulder (1 to 3), three axes that meet (3 to 5), spherical wrist (5 to 7)");
    CHECK(family_of(iiwa).closed_form.ends_with("(Shimizu et al. 2008)"));
  }
  for (const char* panda : {"franka_panda", "franka_fr3", "franka_panda_hand"}) {
    INFO(panda);
    CHECK(family_of(panda).name == "spherical shoulder (1 to 3), offset wrist");
    CHECK(family_of(panda).closed_form == "known for every value of one other joint (Pieper 1968)");
  }
  for (const char* offset : {"kinova_jaco2", "kinova_gen3", "baxter_left"}) {
    INFO(offset);
    CHECK(family_of(offset).name == "offset wrist");
    CHECK_FALSE(family_of(offset).has_closed_form);
  }
  CHECK(family_of("puma560").closed_form == "known, at most 8 configurations of a pose (Pieper 1968)");
  CHECK(family_of("stanford").closed_form == "known (Pieper 1968)");  // one joint slides
  CHECK(family_of("planar_2").name == "planar: all axes are parallel");
  CHECK(family_of("planar_3").closed_form == "known, at most 2 configurations (Craig 2005)");
  CHECK(family_of("dobot_magician").name == "linkage: joints are coupled");
}

TEST_CASE("the family of an arm is that of its URDF file, and calibration takes the closed form away", "[family]") {
  const auto of_file = [](const std::string& name) {
    return robots::family_of(load_robot("tests/data/urdf/" + name + ".urdf").chain);
  };
  CHECK(of_file("ur5e").name == family_of("ur5e").name);
  CHECK(of_file("panda").name == family_of("franka_panda").name);
  CHECK(of_file("iiwa14").name == family_of("kuka_iiwa14").name);
  CHECK(of_file("gen3").name == family_of("kinova_gen3").name);
  CHECK_FALSE(of_file("ur5_calibrated").has_closed_form);
  const Family fetch = of_file("fetch");
  CHECK(fetch.name.find("spherical wrist (6 to 8)") != std::string::npos);
  CHECK(fetch.closed_form == "known for every value of 2 other joints (Pieper 1968)");
}

TEST_CASE("three axes meet, or are parallel, in every configuration exactly where the family says so", "[family]") {
  RandomConfigurations random;
  for (const Robot& arm : all_robots()) {
    const auto turns = [](const DhLink& link) { return link.joint == Joint::turns; };
    if (arm.joints() < 6 || !std::ranges::all_of(arm.chain.links(), turns)) continue;
    const std::string name = robots::family_of(arm.chain).name;
    const auto says = [&](const std::string& words) { return name.find(words) != std::string::npos; };
    for (std::size_t i = 0; i + 2 < arm.chain.links().size(); ++i) {
      double farthest = 0, most_turned = 0;
      for (int trial = 0; trial < 20; ++trial) {
        const std::vector<Axis> axes = axes_at(arm.chain, random(arm.limits));
        const Axis &a = axes[i], &b = axes[i + 1], &c = axes[i + 2];
        most_turned =
            std::max({most_turned, a.direction.cross(b.direction).norm(), b.direction.cross(c.direction).norm()});
        if (a.direction.cross(b.direction).norm() > 0.1) farthest = std::max(farthest, apart(a, b, c));
      }
      const std::string which = " (" + std::to_string(i + 1) + " to " + std::to_string(i + 3) + ")";
      INFO(arm.name << which << ": " << name);
      const bool is_parallel = most_turned < 1e-9;
      CHECK(says("parallel axes" + which) == is_parallel);
      CHECK((says("wrist" + which) || says("shoulder" + which) || says("meet" + which)) ==
            (!is_parallel && farthest > 0 ? farthest < 1e-18 : false));
    }
  }
}

TEST_CASE("families that no arm of the library has", "[family]") {
  const auto quarter = std::numbers::pi / 2;
  // SCARA: two joints that turn and one that slides, all about the vertical.
  const Chain scara({{.a = 0.3}, {.a = 0.2, .alpha = 2 * quarter}, {.joint = Joint::slides}});
  CHECK(robots::family_of(scara).name == "SCARA: all axes are parallel");
  CHECK(robots::family_of(scara).has_closed_form);
  const Chain snake(std::vector<DhLink>(4, DhLink{.a = 0.3}));
  CHECK_FALSE(robots::family_of(snake).has_closed_form);
  // Six general joints; then a length of a nanometre, which is none, and one of a micrometre.
  const auto general = [&](double a4) {
    return robots::family_of(Chain({{.a = 0.1, .alpha = 0.5, .d = 0.2},
                                    {.a = 0.2, .alpha = 0.7, .d = 0.1},
                                    {.a = 0.1, .alpha = 1, .d = 0.3},
                                    {.a = a4, .alpha = quarter, .d = 0.2},
                                    {.alpha = -quarter},
                                    {.d = 0.1}}));
  };
  CHECK(general(1e-10).name == "spherical wrist (4 to 6)");
  CHECK(general(1e-6).name == "offset wrist");
  CHECK(general(1e-6).closed_form.find("degree 16") != std::string::npos);
  const Chain short_one({{.alpha = quarter}, {.a = 0.4}, {.a = 0.4}});
  CHECK(robots::family_of(short_one).name == "no three axes that meet or are parallel");
}
