// The URDF text of an arm is that arm: by a reader of its own, and by ours.
#include "numerics/random.hpp"
#include "robots/urdf.hpp"
#include "tests/common.hpp"

using namespace ikbench::robots;

namespace {

Eigen::Vector3d three(const std::string& text) {
  std::istringstream in(text);
  Eigen::Vector3d v;
  in >> v.x() >> v.y() >> v.z();
  return v;
}

// Follows the joints in the order of the text.
Eigen::Matrix4d pose_by_text(const std::string& urdf, const Eigen::VectorXd& q) {
  static const std::regex joint(R"re(<joint name="([^"]*)" type="(\w+)">([^]*?)</joint>)re");
  const auto attribute = [](const std::string& text, const std::string& name) {
    std::smatch found;
    return std::regex_search(text, found, std::regex(name + "=\"([^\"]*)\"")) ? found[1].str() : std::string();
  };
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  std::map<std::string, double> values;
  for (std::sregex_iterator at(urdf.begin(), urdf.end(), joint), end; at != end; ++at) {
    const std::string type = (*at)[2], body = (*at)[3];
    const Eigen::Vector3d rpy = three(attribute(body, "rpy"));
    pose = pose * Eigen::Translation3d(three(attribute(body, "xyz"))) *
           Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) * Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
           Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX());
    if (type == "fixed") continue;
    const std::string mimicked = attribute(body, "mimic joint");
    const double value = mimicked.empty() ? q[static_cast<Eigen::Index>(values.size())] : -values.at(mimicked);
    if (mimicked.empty()) values[(*at)[1]] = value;
    const Eigen::Vector3d axis = three(attribute(body, "axis xyz"));
    if (type == "prismatic")
      pose = pose * Eigen::Translation3d(value * axis);
    else
      pose = pose * Eigen::AngleAxisd(value, axis);
  }
  return pose.matrix();
}

}  // namespace

TEST_CASE("The URDF text of an arm from a file has that arm alone, in the numbers of the file") {
  ikbench::numerics::Random random(ikbench::numerics::Key(1));
  for (const char* const name : {"fetch", "gen3", "iiwa14", "panda", "ur5_calibrated", "ur5e"}) {
    INFO(name);
    const Robot arm =
        load_robot(std::string("tests/data/urdf/") + name + ".urdf", {.limits = UrdfChoice::Limits::soft});
    const std::string text = urdf_of(arm, arm.chain);
    const Robot read = parse_urdf(text, "arm.urdf", {.base = arm.base_link, .tip = arm.tip_link});
    CHECK(joint_names(read) == joint_names(arm));
    CHECK(read.limits.lower == arm.limits.lower);
    CHECK(read.limits.upper == arm.limits.upper);
    CHECK(static_cast<int>(read.description.size()) == arm.joints() + 1);  // and one that leads to the tip
    // Of the first joints, as before a wrist, with the tool where the searched chain has it.
    const std::vector<DhLink>& links = arm.chain.links();
    const Chain first({links.begin(), links.end() - 3}, arm.chain.base(), {.position = {0, 0, 0.1}});
    const std::string of_first = urdf_of(arm, first);
    Configuration q(arm.joints());
    for (int trial = 0; trial < 20; ++trial) {
      for (double& joint : q) joint = random.uniform(-3, 3);
      const Eigen::Matrix4d judged = pose_of(arm.description, q).matrix();
      CHECK((pose_by_text(text, q) - judged).cwiseAbs().maxCoeff() <= 1e-14);
      CHECK((pose_of(read.description, q).matrix() - judged).cwiseAbs().maxCoeff() <= 1e-14);
      const Eigen::VectorXd q_first = q.head(first.joints());
      CHECK((pose_by_text(of_first, q_first) - first.forward(q_first).matrix()).cwiseAbs().maxCoeff() <= 1e-13);
    }
  }
}

TEST_CASE("The URDF text of each built-in arm is that arm, to 1e-12") {
  ikbench::numerics::Random random(ikbench::numerics::Key(1));
  for (const Robot& arm : all_robots()) {
    INFO(arm.name);
    const std::string text = urdf_of(arm, arm.chain);
    const bool is_coupled = text.find("<mimic") != std::string::npos;  // which our reader refuses
    const Robot read = is_coupled ? arm : parse_urdf(text, "arm.urdf", {.base = "base", .tip = "tool"});
    CHECK(joint_names(read) == joint_names(arm));
    CHECK(doubts_of(read) == doubts_of(arm));
    for (int trial = 0; trial < 20; ++trial) {
      const JointLimits finite = arm.limits.around(Configuration::Zero(arm.joints()));
      Configuration q(arm.joints());
      for (Eigen::Index j = 0; j < q.size(); ++j) q[j] = random.uniform(finite.lower[j], finite.upper[j]);
      const Eigen::Matrix4d here = arm.chain.forward(q).matrix();
      CHECK((pose_by_text(text, q) - here).cwiseAbs().maxCoeff() <= 1e-12);
      CHECK((read.chain.forward(q).matrix() - here).cwiseAbs().maxCoeff() <= 1e-12);
    }
    for (Eigen::Index j = 0; j < arm.joints(); ++j) {
      CHECK(read.limits.lower[j] == arm.limits.lower[j]);
      CHECK(read.limits.upper[j] == arm.limits.upper[j]);
      CHECK(read.chain.slides(j) == arm.chain.slides(j));
    }
  }
}
