// The library of arms: each tool is where its maker's description has it.
#include <limits>
#include <numbers>
#include <vector>

#include "robots/robot.hpp"
#include "robots/spherical_wrist.hpp"
#include "tests/catch.hpp"

using namespace ikbench;
using namespace ikbench::robots;

namespace {

Eigen::VectorXd tenths(int joints) { return Eigen::VectorXd::LinSpaced(joints, 0.1, 0.1 * joints); }

}  // namespace

TEST_CASE("the tool of an arm of the library is where its maker's description has it", "[arms]") {
  // At zeros and at (0.1, 0.2, ...), by the product of the transforms of the URDF files that the arm files name. Those
  // of Universal Robots print quarter turns with nine decimals, which moves the tool by up to 6e-10 m; those of Kinova
  // print lengths with ten digits.
  struct Tool {
    const char* arm;
    Eigen::Vector3d at_zeros, at_tenths;
    double within;  // [m]
  };
  const std::vector<Tool> tools{
      {"kuka_iiwa14", {0, 0, 1.306}, {0.0413365575869, -0.00431495492164, 1.27874931418}, 1e-11},
      {"kuka_iiwa7", {0, 0, 1.266}, {0.0373830213538, -0.00471163168316, 1.23914798262}, 1e-11},
      {"ur5e", {0.8172, 0.232899999959, 0.0627999999522}, {0.686708353115, 0.290716033453, -0.209344149494}, 1e-9},
      {"ur10e", {1.18425, 0.290699999951, 0.0608499999404}, {1.01011366729, 0.379169614793, -0.333310314492}, 1e-9},
      {"ur3e", {0.45675, 0.223149999965, 0.0664999999542}, {0.363303549266, 0.24939110523, -0.0863917230228}, 1e-9},
      {"ur5", {0.81725, 0.191449999961, -0.00549100003927}, {0.689484802521, 0.251464945618, -0.273073028611}, 1e-9},
      {"franka_panda", {0.088, 0, 0.926}, {0.0850806553507, 0.0637081287693, 0.975173649017}, 1e-11},
      {"franka_fr3", {0.088, 0, 0.926}, {0.0850806553507, 0.0637081287693, 0.975173649017}, 1e-11},
      {"kinova_gen3", {0, -0.0248501, 1.187385}, {0.363424486373, -0.179329891055, 1.02961295177}, 1e-11},
      {"baxter_left",
       {0.797461795001, 0.992464633721, 0.320976},
       {0.439231475192, 1.006319406, -0.122509615264},
       1e-11},
      {"abb_irb120", {0.374, 0, 0.63}, {0.38913603944, 0.0525535201507, 0.413067627577}, 1e-11},
      {"kinova_jaco2", {0, 0.0642618693987, 0.361078920702}, {0.0944506624006, 0.092128789487, 0.35269673066}, 1e-9}};
  for (const Tool& tool : tools) {
    const Chain chain = robot(tool.arm).chain;
    CAPTURE(tool.arm, chain.position(tenths(chain.joints())).transpose());
    CHECK((chain.position(0 * tenths(chain.joints())) - tool.at_zeros).norm() < tool.within);
    CHECK((chain.position(tenths(chain.joints())) - tool.at_tenths).norm() < tool.within);
  }
}

TEST_CASE("the Puma 560 and the Stanford arm of the library are where Corke's toolbox has them", "[arms]") {
  const Chain puma = robot("puma560").chain, stanford = robot("stanford").chain;
  CHECK((puma.position(0 * tenths(6)) - Eigen::Vector3d(0.4521, -0.15005, 1.1038)).norm() < 1e-15);
  CHECK((puma.position(tenths(6)) - Eigen::Vector3d(0.247802746924, -0.125940181452, 1.146457905695)).norm() < 1e-12);
  CHECK((stanford.position(tenths(6)) - Eigen::Vector3d(0.045955315691, 0.138982208321, 0.706019973352)).norm() <
        1e-12);
}

TEST_CASE("of the library, the KUKA arms, the IRB 120, the Puma and the Stanford arm have a spherical wrist",
          "[arms]") {
  std::vector<std::string> found;
  for (const Robot& arm : all_robots()) {
    if (SphericalWrist::fits(arm.chain)) found.push_back(arm.name);
  }
  CHECK(found == std::vector<std::string>{"abb_irb120", "kuka_iiwa14", "kuka_iiwa7", "puma560", "stanford"});
}

TEST_CASE("a joint that turns without end has no limits, and is drawn from half a turn each way of where it is",
          "[arms]") {
  const JointLimits limits = robot("kinova_gen3").limits;
  constexpr double infinity = std::numeric_limits<double>::infinity(), pi = std::numbers::pi;
  CHECK(limits.lower[0] == -infinity);
  CHECK(limits.upper[0] == infinity);
  CHECK(limits.upper[1] == Approx(2.24).epsilon(1e-8));
  Eigen::VectorXd q = Eigen::VectorXd::Zero(7);
  q[0] = 1e6;
  CHECK(limits.violation(q) == 0);
  q[0] = 2;
  const JointLimits range = limits.around(q);
  CHECK(range.lower[0] == 2 - pi);
  CHECK(range.upper[0] == 2 + pi);
  CHECK(range.lower[1] == limits.lower[1]);
}
