// The library of arms: each tool is where its maker's description has it.
#include "tests/robots/random_configuration.hpp"

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
      {"kinova_jaco2", {0, 0.0642618693987, 0.361078920702}, {0.0944506624006, 0.092128789487, 0.35269673066}, 1e-9},
      {"abb_yumi_left",
       {0.564597461108, -0.000648653529, 0.417406962563},
       {0.401782943301, 0.0343770744665, 0.227231606267},
       1e-9},
      {"atlas_2013_left", {0.1406, 0.9137, 0.2517}, {0.117582449915, 0.852113214013, 0.476990680087}, 1e-9},
      {"atlas_2015_left", {0.1406, 0.94115, 0.21659}, {0.108749621057, 0.890464216136, 0.443128130737}, 1e-9},
      {"fanuc_m430ia2f", {0, -0.095, 1.405}, {0.391699662939, -0.056175930011, 1.30609835922}, 1e-9},
      {"franka_panda_2018", {0.088, 0, 0.926}, {0.0850806553505, 0.063708128769, 0.975173649017}, 1e-9},
      {"kinova_jaco2_limited",
       {0, 0.0642618693971, 0.361078920703},
       {0.0944506624005, 0.0921287894855, 0.352696730661},
       1e-9},
      {"kuka_iiwa14_experimental", {0, 0, 1.306}, {0.041296034747, -0.00418945574711, 1.27866651754}, 1e-9},
      {"motoman_csda10f_right",
       {0.194270902852, -1.16003405625, 1.19944629988},
       {0.233377491607, -1.06577999084, 1.27990779977},
       1e-9},
      {"motoman_mh180", {2.14, 0, 2.1}, {2.20302812543, 0.263257864675, 1.09620655447}, 1e-9},
      {"pr2_right", {0.821, -0.188, 0}, {0.750593420241, -0.0755629801087, -0.255246170575}, 1e-9},
      {"schunk_lwa4d", {0, 0, 0.891}, {0.237117069964, 0.0611488562715, 0.829161339877}, 1e-9}};
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

TEST_CASE("arms of the library whose last three axes meet have a spherical wrist", "[arms]") {
  std::vector<std::string> found;
  for (const Robot& arm : all_robots()) {
    if (SphericalWrist::fits(arm.chain)) found.push_back(arm.name);
  }
  CHECK(found == std::vector<std::string>{"abb_irb120", "atlas_2015_left", "kuka_iiwa14", "kuka_iiwa14_experimental",
                                          "kuka_iiwa7", "motoman_mh180", "pr2_right", "puma560", "schunk_lwa4d",
                                          "stanford"});
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
