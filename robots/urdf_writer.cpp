#include <fmt/format.h>
#include <tinyxml2.h>

#include <set>
#include <utility>

#include "robots/urdf.hpp"

namespace ikbench::robots {

namespace {

// A link and the joint before it, in the frame of the link before. URDF wants numbers for the effort of a joint, which
// no arm here has, and for its velocity.
class Writer {
 public:
  Writer(const std::string& name, const std::string& base) : before_(base) {
    xml_.OpenElement("robot");
    xml_.PushAttribute("name", name.c_str());
    add_link(base);
  }

  // A name that no link or joint has yet.
  std::string unused(std::string name) {
    while (!names_.insert(name).second) name += '_';
    return name;
  }

  // `mimicked` is the joint whose value this one has, negated; empty: none.
  void joint(const std::string& name, const char* type, const std::string& child, const Frame& origin,
             const Eigen::Vector3d& axis, double lower = 0, double upper = 0, double velocity = 0,
             const std::string& mimicked = {}) {
    add_link(child);
    xml_.OpenElement("joint");
    xml_.PushAttribute("name", name.c_str());
    xml_.PushAttribute("type", type);
    add("parent", {{"link", std::exchange(before_, child)}});
    add("child", {{"link", child}});
    add("origin", {{"xyz", text_of(origin.position)}, {"rpy", text_of(origin.rpy)}});
    if (!axis.isZero(0)) add("axis", {{"xyz", text_of(axis)}});
    if (lower < upper)
      add("limit",
          {{"lower", number(lower)}, {"upper", number(upper)}, {"effort", "1000"}, {"velocity", number(velocity)}});
    if (!mimicked.empty()) add("mimic", {{"joint", mimicked}, {"multiplier", "-1"}});
    xml_.CloseElement();
  }

  std::string text() {
    xml_.CloseElement();
    return xml_.CStr();
  }

 private:
  static std::string number(double value) { return fmt::format("{}", value + 0.0); }  // no -0
  static std::string text_of(const Eigen::Vector3d& v) {
    return number(v.x()) + ' ' + number(v.y()) + ' ' + number(v.z());
  }
  void add_link(const std::string& name) { add("link", {{"name", name}}); }
  void add(const char* element, const std::vector<std::pair<const char*, std::string>>& attributes) {
    xml_.OpenElement(element);
    for (const auto& [key, value] : attributes) xml_.PushAttribute(key, value.c_str());
    xml_.CloseElement();
  }

  tinyxml2::XMLPrinter xml_;
  std::set<std::string> names_;  // that are taken
  std::string before_;           // the last link
};

Pose turned(double about_x, double about_y, double about_z) { return Frame{.rpy = {about_x, about_y, about_z}}.pose(); }

// One joint of an arm, with its limits; behind it, if it is coupled, one that turns back.
void write_joint(Writer& writer, const Robot& arm, const Chain& chain, int j, const Frame& origin,
                 const Eigen::Vector3d& axis) {
  const std::string name = joint_names(arm)[static_cast<std::size_t>(j)];
  const DhLink& link = chain.links()[static_cast<std::size_t>(j)];
  const bool is_free = is_endless(arm.limits.lower[j], arm.limits.upper[j]);
  const double lower = is_free ? 0 : arm.limits.lower[j], upper = is_free ? 0 : arm.limits.upper[j];
  const char* const type = link.joint == Joint::slides ? "prismatic" : is_free ? "continuous" : "revolute";
  const double velocity = arm.velocity.size() > 0 && arm.velocity[j] > 0 ? arm.velocity[j] : 1000;
  writer.joint(name, type, writer.unused(name + "_link"), origin, axis, lower, upper, velocity);
  if (link.joint != Joint::coupled) return;
  writer.joint(writer.unused(name + "_back"), type, writer.unused(name + "_end"), {.position = {link.a, 0, link.d}},
               axis, -upper, -lower, velocity, name);
}

// The joints of a table. Returns what is between the last of them and the tool.
Frame write_table(Writer& writer, const Robot& arm, const Chain& chain) {
  Pose before = chain.base().pose();  // from the last joint to the next
  for (int j = 0; j < chain.joints(); ++j) {
    const DhLink& link = chain.links()[static_cast<std::size_t>(j)];
    const bool is_coupled = link.joint == Joint::coupled;
    const Pose offset = is_coupled ? turned(0, link.offset, 0) : turned(0, 0, link.offset);
    const Eigen::Vector3d axis = is_coupled ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
    write_joint(writer, arm, chain, j, frame_of(before * offset), axis);
    before = is_coupled ? turned(0, -link.offset, 0) : Pose(Eigen::Translation3d(link.a, 0, link.d));
    before = before * turned(link.alpha, 0, 0);
    if (link.beta != 0) before = before * turned(0, link.beta, 0);
  }
  return frame_of(before * chain.tool().pose());
}

Frame product(const Frame& one, const Frame& other) {
  if (one == Frame()) return other;  // with the digits of its file
  return other == Frame() ? one : frame_of(one.pose() * other.pose());
}

// The joints as their file has them, with the numbers that it prints; a fixed one becomes part of the next origin.
// Returns what is between the last joint of `chain`, which may have only the first joints of the arm, and the tool.
Frame write_described(Writer& writer, const Robot& arm, const Chain& chain) {
  Frame before;         // from the last joint that moves to the next
  Description written;  // up to the last joint that moves
  int moving = 0;
  for (const DescribedJoint& joint : arm.description) {
    if (moving == chain.joints() && moving < arm.joints()) {
      const Eigen::VectorXd at_zero = Eigen::VectorXd::Zero(moving);
      return frame_of(pose_of(written, at_zero).inverse() * chain.forward(at_zero));
    }
    written.push_back(joint);
    before = product(before, joint.origin);
    if (joint.motion == DescribedJoint::Motion::none) continue;
    write_joint(writer, arm, chain, moving++, before, joint.axis);
    before = {};
  }
  return before;
}

}  // namespace

std::vector<std::string> joint_names(const Robot& arm) {
  std::vector<std::string> names = joint_names(arm.description);
  for (int j = static_cast<int>(names.size()); j < arm.joints(); ++j) names.push_back(fmt::format("joint_{}", j + 1));
  return names;
}

std::string urdf_of(const Robot& arm, const Chain& chain) {
  Writer writer(arm.name, base_link_of(arm));
  for (const std::string& name : joint_names(arm)) writer.unused(name);
  writer.unused(base_link_of(arm));
  writer.unused(tip_link_of(arm));
  const Frame tool = arm.description.empty() ? write_table(writer, arm, chain) : write_described(writer, arm, chain);
  writer.joint(writer.unused("to_" + tip_link_of(arm)), "fixed", tip_link_of(arm), tool, Eigen::Vector3d::Zero());
  return writer.text();
}

}  // namespace ikbench::robots
