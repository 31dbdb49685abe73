#include <fmt/format.h>
#include <tinyxml2.h>

#include <set>
#include <utility>

#include "robots/urdf.hpp"

namespace ikbench::robots {

namespace {

// A joint as URDF has it.
struct UrdfJoint {
  std::string name;
  const char* type;
  Frame origin;  // in the frame of the link before
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
  double lower = 0, upper = 0;  // equal: no limits
  double velocity = 0;
  std::string mimicked = {};  // the joint whose value this one has, negated; empty: none
};

// Writes links one behind the other, each with the joint before it. URDF wants numbers for the effort of a joint, which
// no arm here has, and for its velocity.
class Writer {
 public:
  Writer(const std::string& name, const std::string& base) : before_(base) {
    xml_.OpenElement("robot");
    xml_.PushAttribute("name", name.c_str());
    add_link(base);
  }

  // Returns a name that no link or joint has yet, and takes it.
  std::string unused(std::string name) {
    while (!names_.insert(name).second) name += '_';
    return name;
  }

  // Writes the link `child`, and the joint from the last link to it.
  void write(const UrdfJoint& joint, const std::string& child) {
    add_link(child);
    xml_.OpenElement("joint");
    xml_.PushAttribute("name", joint.name.c_str());
    xml_.PushAttribute("type", joint.type);
    add("parent", {{"link", std::exchange(before_, child)}});
    add("child", {{"link", child}});
    add("origin", {{"xyz", text_of(joint.origin.position)}, {"rpy", text_of(joint.origin.rpy)}});
    if (!joint.axis.isZero(0)) add("axis", {{"xyz", text_of(joint.axis)}});
    if (joint.lower < joint.upper)
      add("limit", {{"lower", number(joint.lower)},
                    {"upper", number(joint.upper)},
                    {"effort", "1000"},
                    {"velocity", number(joint.velocity)}});
    if (!joint.mimicked.empty()) add("mimic", {{"joint", joint.mimicked}, {"multiplier", "-1"}});
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
  std::set<std::string> names_;  // taken names
  std::string before_;           // link written last
};

Pose turned(double about_x, double about_y, double about_z) { return Frame{.rpy = {about_x, about_y, about_z}}.pose(); }

const char* type_of(Joint joint, bool is_continuous) {
  if (joint == Joint::slides) return "prismatic";
  return is_continuous ? "continuous" : "revolute";
}

// Returns joint j of an arm with its limits, and without a place.
UrdfJoint urdf_joint(const Robot& arm, int j, const DhLink& link) {
  const bool is_continuous = is_endless(arm.limits.lower[j], arm.limits.upper[j]);
  return {.name = joint_names(arm)[static_cast<std::size_t>(j)],
          .type = type_of(link.joint, is_continuous),
          .origin = {},
          .lower = is_continuous ? 0 : arm.limits.lower[j],
          .upper = is_continuous ? 0 : arm.limits.upper[j],
          .velocity = arm.velocity.size() > 0 && arm.velocity[j] > 0 ? arm.velocity[j] : 1000};
}

// Writes a joint. If the link is coupled, a joint that turns back follows.
void write_joint(Writer& writer, const UrdfJoint& joint, const DhLink& link) {
  writer.write(joint, writer.unused(joint.name + "_link"));
  if (link.joint != Joint::coupled) return;
  UrdfJoint back = joint;
  back.name = writer.unused(joint.name + "_back");
  back.origin = {.position = {link.a, 0, link.d}};
  back.lower = -joint.upper;
  back.upper = -joint.lower;
  back.mimicked = joint.name;
  writer.write(back, writer.unused(joint.name + "_end"));
}

// Writes the joints of a Denavit-Hartenberg table. Returns the frame of the tool behind the last joint.
Frame write_table(Writer& writer, const Robot& arm, const Chain& chain) {
  Pose before = chain.base().pose();  // from the last joint to the next
  for (int j = 0; j < chain.joints(); ++j) {
    const DhLink& link = chain.links()[static_cast<std::size_t>(j)];
    const bool is_coupled = link.joint == Joint::coupled;
    const Pose offset = is_coupled ? turned(0, link.offset, 0) : turned(0, 0, link.offset);
    UrdfJoint joint = urdf_joint(arm, j, link);
    joint.origin = frame_of(before * offset);
    joint.axis = is_coupled ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
    write_joint(writer, joint, link);
    before = is_coupled ? turned(0, -link.offset, 0) : Pose(Eigen::Translation3d(link.a, 0, link.d));
    before = before * turned(link.alpha, 0, 0);
    if (link.beta != 0) before = before * turned(0, link.beta, 0);
  }
  return frame_of(before * chain.tool().pose());
}

// Returns the frame `second`, which is relative to `first`, relative to the frame before. Digits of a file stay if one
// of the two frames moves nothing.
Frame product(const Frame& first, const Frame& second) {
  if (first == Frame()) return second;
  return second == Frame() ? first : frame_of(first.pose() * second.pose());
}

// Writes the joints as the arm's file has them, with the numbers that it prints. A fixed joint becomes part of the next
// origin. Returns the frame of the tool behind the last joint of `chain`, which may have only the first joints of the
// arm.
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
    const DhLink& link = chain.links()[static_cast<std::size_t>(moving)];
    UrdfJoint moved = urdf_joint(arm, moving, link);
    moved.origin = before;
    moved.axis = joint.axis;
    write_joint(writer, moved, link);
    ++moving;
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
  const UrdfJoint to_tool{.name = writer.unused("to_" + tip_link_of(arm)), .type = "fixed", .origin = tool};
  writer.write(to_tool, tip_link_of(arm));
  return writer.text();
}

}  // namespace ikbench::robots
