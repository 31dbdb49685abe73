// Public arms whose files print rounded angles are the arms that their files print: the tool is where another program
// puts it, for the judge, for the solvers and in the text that programs get.
#include "base/number.hpp"
#include "tests/robots/random_configuration.hpp"

namespace {

struct PublicArm {
  std::string name, urdf = "<robot name='r'><link name='l0'/>\n";
  int links = 0;  // behind the first
  std::vector<std::pair<Configuration, Eigen::Matrix<double, 3, 4>>> poses;

  void add_joint(std::istringstream& row) {
    std::string type, joint, numbers[11];
    row >> type >> joint;
    for (std::string& number : numbers) row >> number;
    const auto three = [&](int first) { return numbers[first] + ' ' + numbers[first + 1] + ' ' + numbers[first + 2]; };
    const std::string before = std::to_string(links), after = std::to_string(++links);
    urdf += "<link name='l" + after + "'/><joint name='" + joint + "' type='" + type + "'><parent link='l" + before +
            "'/><child link='l" + after + "'/><origin xyz='" + three(0) + "' rpy='" + three(3) + "'/><axis xyz='" +
            three(6) + "'/>";
    if (type == "revolute" || type == "prismatic")
      urdf += "<limit lower='" + numbers[9] + "' upper='" + numbers[10] + "'/>";
    urdf += "</joint>\n";
  }

  void add_pose(std::istringstream& row) {
    std::vector<double> values;
    for (std::string word; row >> word && word != "=";) values.push_back(number_from(word).value());
    Eigen::Matrix<double, 3, 4> tool;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 4; ++j) row >> tool(i, j);
    REQUIRE(row);
    poses.emplace_back(Configuration::Map(values.data(), static_cast<Eigen::Index>(values.size())), tool);
  }

  Robot read(const std::string& text) const {
    return parse_urdf(text, name + ".urdf", {.base = "l0", .tip = "l" + std::to_string(links)});
  }
};

std::vector<PublicArm> public_arms() {
  std::vector<PublicArm> arms;
  std::istringstream lines(text_in("tests/data/urdf/public_arms.txt"));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream row(line);
    std::string kind;
    row >> kind;
    if (kind == "arm") row >> arms.emplace_back().name;
    if (kind == "joint") arms.back().add_joint(row);
    if (kind == "at") arms.back().add_pose(row);
  }
  return arms;
}

}  // namespace

TEST_CASE("the tools of thirty public arms with rounded angles are where another program puts them", "[urdf][public]") {
  const std::vector<PublicArm> arms = public_arms();
  CHECK(arms.size() == 30);
  for (const PublicArm& arm : arms) {
    CAPTURE(arm.name);
    const Robot robot = arm.read(arm.urdf + "</robot>\n"), again = arm.read(urdf_of(robot, robot.chain));
    CHECK(joint_names(again) == joint_names(robot));
    REQUIRE(arm.poses.size() >= 2);
    for (const auto& [q, tool] : arm.poses) {
      const auto off = [&expected = tool](const Pose& pose) {
        return (pose.matrix().topRows<3>() - expected).cwiseAbs().maxCoeff();
      };
      CHECK(off(robot.chain.forward(q)) < 1e-12);
      CHECK(off(pose_of(robot.description, q)) < 1e-12);
      CHECK(off(again.chain.forward(q)) < 1e-12);
      Eigen::VectorXd error(1);
      robot.chain.position_errors(q, tool.col(3), error);
      CHECK(error[0] < 1e-12);
    }
  }
}
