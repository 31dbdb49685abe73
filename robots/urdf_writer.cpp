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
  void joint(const std::string& name, const char* type, const std::string& child, const Pose& pose, const char* axis,
             double lower = 0, double upper = 0, double velocity = 0, const std::string& mimicked = {}) {
    add_link(child);
    xml_.OpenElement("joint");
    xml_.PushAttribute("name", name.c_str());
    xml_.PushAttribute("type", type);
    add("parent", {{"link", std::exchange(before_, child)}});
    add("child", {{"link", child}});
    const auto [xyz, rpy] = frame_of(pose);
    add("origin", {{"xyz", text_of(xyz)}, {"rpy", text_of(rpy)}});
    if (*axis != '\0') add("axis", {{"xyz", axis}});
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

}  // namespace

std::vector<std::string> joint_names(const Robot& arm) {
  std::vector<std::string> names = joint_names(arm.description);
  for (int j = static_cast<int>(names.size()); j < arm.joints(); ++j) names.push_back(fmt::format("joint_{}", j + 1));
  return names;
}

std::string urdf_of(const Robot& arm, const Chain& chain) {
  Writer writer(arm.name, base_link_of(arm));
  const std::vector<std::string> names = joint_names(arm);
  for (const std::string& name : names) writer.unused(name);
  writer.unused(base_link_of(arm)), writer.unused(tip_link_of(arm));
  Pose before = chain.base().pose();  // from the last joint to the next
  for (int j = 0; j < chain.joints(); ++j) {
    const std::string& name = names[static_cast<std::size_t>(j)];
    const DhLink& link = chain.links()[static_cast<std::size_t>(j)];
    const double lower = arm.limits.lower[j], upper = arm.limits.upper[j];
    const bool is_coupled = link.joint == Joint::coupled, is_free = is_endless(lower, upper);
    const char* const type = link.joint == Joint::slides ? "prismatic" : is_free ? "continuous" : "revolute";
    const double velocity = arm.velocity.size() > 0 && arm.velocity[j] > 0 ? arm.velocity[j] : 1000;
    const Pose offset = is_coupled ? turned(0, link.offset, 0) : turned(0, 0, link.offset);
    writer.joint(name, type, writer.unused(name + "_link"), before * offset, is_coupled ? "0 1 0" : "0 0 1",
                 is_free ? 0 : lower, is_free ? 0 : upper, velocity);
    before = Pose(Eigen::Translation3d(link.a, 0, link.d));
    if (is_coupled) {  // a parallelogram turns back after the link
      writer.joint(writer.unused(name + "_back"), type, writer.unused(name + "_end"), before, "0 1 0",
                   is_free ? 0 : -upper, is_free ? 0 : -lower, velocity, name);
      before = turned(0, -link.offset, 0);
    }
    before = before * turned(link.alpha, 0, 0);
    if (link.beta != 0) before = before * turned(0, link.beta, 0);
  }
  writer.joint(writer.unused("to_" + tip_link_of(arm)), "fixed", tip_link_of(arm), before * chain.tool().pose(), "");
  return writer.text();
}

}  // namespace ikbench::robots
