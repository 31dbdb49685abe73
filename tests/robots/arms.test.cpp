// The library of arms: each tool is where its maker's description has it.
#include "base/csv.hpp"
#include "tests/robots/random_configuration.hpp"

namespace {

Eigen::VectorXd tenths(int joints) { return Eigen::VectorXd::LinSpaced(joints, 0.1, 0.1 * joints); }

}  // namespace

TEST_CASE("the tool of an arm of the library is where its maker's description has it", "[arms]") {
  // At zeros and at (0.1, 0.2, ...), by the product of the transforms of the URDF files that the arm files name. Those
  // of Universal Robots print quarter turns with nine decimals, which moves the tool by up to 6e-10 m; those of Kinova
  // print lengths with ten digits.
  const std::string text = text_in("tests/data/arms/tools.csv");
  const CsvTable tools = parse_csv(text, "tools.csv");
  CHECK(tools.rows() == 23);
  for (std::size_t row = 0; row < tools.rows(); ++row) {
    const Chain chain = robot(tools.cell(row, 0)).chain;
    for (const std::string at : {"zeros", "tenths"}) {
      const auto coordinate = [&](const char* axis) { return tools.number(row, fmt::format("{}_{}", at, axis)); };
      const Eigen::Vector3d expected(coordinate("x"), coordinate("y"), coordinate("z"));
      const Eigen::VectorXd q = (at == "zeros" ? 0 : 1) * tenths(chain.joints());
      CAPTURE(tools.cell(row, 0), at);
      CHECK((chain.position(q) - expected).norm() < tools.number(row, "within"));
    }
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
  for (const Robot& arm : all_robots())
    if (SphericalWrist::fits(arm.chain)) found.push_back(arm.name);
  CHECK(found == std::vector<std::string>{"abb_irb120", "atlas_2015_left", "kuka_iiwa14", "kuka_iiwa14_experimental",
                                          "kuka_iiwa7", "motoman_mh180", "pr2_right", "puma560", "schunk_lwa4d",
                                          "stanford"});
}

TEST_CASE("a joint that turns without end has no limits, and is drawn from half a turn each way of where it is",
          "[arms]") {
  const JointLimits limits = robot("kinova_gen3").limits;
  CHECK(limits.lower[0] == -infinity);
  CHECK(limits.upper[0] == infinity);
  CHECK(limits.upper[1] == Approx(2.24).epsilon(1e-8));
  Eigen::VectorXd q = Eigen::VectorXd::Zero(7);
  q[0] = 1e6;
  CHECK(limits.violation(q) == 0);
  q[0] = 2;
  const JointLimits range = limits.around(q);
  CHECK(range.lower[0] == 2 - std::numbers::pi);
  CHECK(range.upper[0] == 2 + std::numbers::pi);
  CHECK(range.lower[1] == limits.lower[1]);
}
