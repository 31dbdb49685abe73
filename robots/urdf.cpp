#include "robots/urdf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <vector>

#include "numerics/names.hpp"
#include "numerics/number.hpp"
#include "numerics/random.hpp"
#include "numerics/toml_table.hpp"
#include "robots/arm_fields.hpp"
#include "robots/description.hpp"

namespace ikbench::robots {

using namespace numerics;
using tinyxml2::XMLAttribute;
using tinyxml2::XMLElement;

namespace {

using Motion = DescribedJoint::Motion;

constexpr std::size_t most_links = 10'000;
constexpr std::string_view add_tip = "add --tip LINK, or tip = \"LINK\" in [urdf]";

std::string expand_command(const std::filesystem::path& file) {
  std::string stem = file.filename().string();
  for (const std::string_view ending : {".xacro", ".urdf"}) {
    if (stem.ends_with(ending)) stem.resize(stem.size() - ending.size());
  }
  const bool is_xacro = file.extension() == ".xacro";
  return fmt::format("expand it first: xacro {} > {}.urdf", file.filename().string(),
                     is_xacro ? stem : stem + "_expanded");
}

// A file, for messages about places in it.
class Place {
 public:
  explicit Place(const std::filesystem::path& file) : file_(file) {}

  [[noreturn]] void fail(const XMLElement& at, std::string_view message) const { fail(at.GetLineNum(), message); }
  [[noreturn]] void fail(int line, std::string_view message) const {
    throw std::invalid_argument(fmt::format("{}:{}: {}", file_.string(), line, message));
  }

  // The name in an attribute.
  std::string name(const XMLElement& at, const char* attribute) const {
    const char* const text = at.Attribute(attribute);
    if (text == nullptr || *text == '\0') {
      fail(at, fmt::format("<{}> has no {}", shown(at.Name()), attribute));
    }
    if (!TomlReader::is_plain(text)) fail(at, fmt::format("a {} is not {}", attribute, TomlReader::plain));
    return text;
  }

  double number(const XMLElement& at, const char* attribute, double if_none) const {
    const char* const text = at.Attribute(attribute);
    return text == nullptr ? if_none : numbers(at, attribute, 1)[0];
  }

  Eigen::Vector3d vector(const XMLElement& at, const char* attribute, const Eigen::Vector3d& if_none) const {
    return at.Attribute(attribute) == nullptr ? if_none : numbers(at, attribute, 3);
  }

  const std::filesystem::path& file() const { return file_; }

  static std::string shown(std::string_view text) {
    return TomlReader::is_plain(text) ? std::string(text) : "(not printable)";
  }

 private:
  Eigen::Vector3d numbers(const XMLElement& at, const char* attribute, int count) const {
    const std::string_view text = at.Attribute(attribute);
    Eigen::Vector3d values = Eigen::Vector3d::Zero();
    int found = 0;
    constexpr std::string_view blanks = " \t\r\n";
    for (std::size_t from = text.find_first_not_of(blanks); from != std::string_view::npos; ++found) {
      const std::size_t to = std::min(text.find_first_of(blanks, from), text.size());
      const std::optional<double> value = number_from(text.substr(from, to - from));
      if (!value || !(std::abs(*value) <= 1e6) || found == count) {
        found = -1;
        break;
      }
      values[found] = *value;
      from = text.find_first_not_of(blanks, to);
    }
    if (found != count) {
      fail(at, fmt::format("{} of <{}> is \"{}\"; expected {} within +-1e6", attribute, at.Name(), shown(text),
                           count == 1 ? "a number" : "3 numbers"));
    }
    return values;
  }

  const std::filesystem::path& file_;
};

class XacroFinder final : public tinyxml2::XMLVisitor {
 public:
  bool VisitEnter(const XMLElement& element, const XMLAttribute* first) override {
    if (std::string_view(element.Name()).starts_with("xacro:")) line = element.GetLineNum();
    for (const XMLAttribute* at = first; at != nullptr; at = at->Next()) {
      if (std::string_view(at->Value()).find("${") != std::string_view::npos) line = element.GetLineNum();
    }
    return line == 0;
  }
  int line = 0;
};

// The tree of links and the joints between them.
class Tree {
 public:
  Tree(const XMLElement& robot, const Place& place) : place_(place) {
    for (const XMLElement* link = robot.FirstChildElement("link"); link != nullptr;
         link = link->NextSiblingElement("link")) {
      const std::string name = place.name(*link, "name");
      if (!links_.emplace(name, link).second) place.fail(*link, fmt::format("there are two links \"{}\"", name));
      if (links_.size() > most_links) place.fail(*link, fmt::format("expected at most {} links", most_links));
    }
    if (links_.empty()) place.fail(robot, "the robot has no links");
    std::set<std::string> joints;
    for (const XMLElement* joint = robot.FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint")) {
      const std::string name = place.name(*joint, "name"), child = end(*joint, "child"), parent = end(*joint, "parent");
      if (!joints.insert(name).second) place.fail(*joint, fmt::format("there are two joints \"{}\"", name));
      const auto [known, is_new] = before_.emplace(child, joint);
      if (!is_new) {
        place.fail(*joint, fmt::format("link \"{}\" is the child of two joints, \"{}\" and \"{}\"; expected a tree",
                                       child, known->second->Attribute("name"), name));
      }
      after_[parent].push_back(child);
    }
  }

  // The root of the tree above a link.
  std::string root_of(std::string link) const {
    for (std::size_t joints = 0; joints <= before_.size(); ++joints) {
      const auto joint = before_.find(link);
      if (joint == before_.end()) return link;
      link = end(*joint->second, "parent");
    }
    place_.fail(1, fmt::format("the joints before link \"{}\" form a cycle; expected a tree", link));
  }

  std::string root() const {
    std::vector<std::string> roots;
    for (const auto& [name, link] : links_) {
      if (!before_.contains(name)) roots.push_back(name);
    }
    if (roots.size() == 1) return roots.front();
    place_.fail(1, roots.empty() ? "the joints form a cycle; expected a tree"
                                 : fmt::format("there are {} links that no joint leads to: {}; add --base "
                                               "LINK, or base = \"LINK\" in [urdf]",
                                               roots.size(), some(roots)));
  }

  // The link with the most joints between the base and it.
  std::string deepest(const std::string& base) const {
    root_of(base);  // refuses a cycle
    std::vector<std::string> level{base}, last;
    for (std::size_t depth = 0; !level.empty() && depth <= links_.size(); ++depth) {
      last = std::move(level);
      level.clear();
      for (const std::string& link : last) {
        if (const auto found = after_.find(link); found != after_.end()) {
          level.insert(level.end(), found->second.begin(), found->second.end());
        }
      }
    }
    if (last.size() == 1) return last.front();
    place_.fail(1, fmt::format("the arm may end at {}; {}", some(last), add_tip));
  }

  // A note on the other ends of the tree with as many moving joints between the base and them; empty if there are none.
  std::string note_on_ends(const std::string& base, const std::string& tip) const {
    std::map<std::string, int> moving{{base, 0}};
    std::vector<std::string> next{base}, ends;
    for (std::size_t i = 0; i < next.size(); ++i) {
      const std::string link = next[i];
      const auto found = after_.find(link);
      if (found == after_.end()) {
        ends.push_back(link);
        continue;
      }
      for (const std::string& child : found->second) {
        const char* const type = before_.at(child)->Attribute("type");
        moving[child] = moving.at(link) + (type != nullptr && std::string_view(type) == "fixed" ? 0 : 1);
        next.push_back(child);
      }
    }
    std::erase_if(ends, [&](const std::string& end) { return end == tip || moving.at(end) != moving.at(tip); });
    if (ends.empty()) return "";
    return fmt::format("the tip is \"{}\", but as many joints lead to {}; to take another, {}", tip, some(ends),
                       add_tip);
  }

  void expect_link(std::string_view key, const std::string& name) const {
    if (links_.contains(name)) return;
    std::vector<std::string> names;
    for (const auto& [known, link] : links_) names.push_back(known);
    const std::string nearest = nearest_name(name, names);
    place_.fail(1, fmt::format("{} is \"{}\", which is no link{}; there are {}", key, name,
                               nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest), some(names)));
  }

  // The joints from the base to the tip.
  std::vector<const XMLElement*> path(const std::string& base, const std::string& tip) const {
    std::vector<const XMLElement*> joints;
    std::string link = tip;
    while (link != base) {
      const auto joint = before_.find(link);
      if (joint == before_.end() || joints.size() > before_.size()) {
        place_.fail(1, joint == before_.end()
                           ? fmt::format("no joints lead from link \"{}\" to link \"{}\"", base, tip)
                           : fmt::format("the joints before link \"{}\" form a cycle; expected a tree", tip));
      }
      joints.push_back(joint->second);
      link = end(*joint->second, "parent");
    }
    std::ranges::reverse(joints);
    return joints;
  }

 private:
  // The link at one end of a joint.
  std::string end(const XMLElement& joint, const char* which) const {
    const XMLElement* const element = joint.FirstChildElement(which);
    if (element == nullptr) {
      place_.fail(joint, fmt::format("joint \"{}\" has no <{}>", place_.name(joint, "name"), which));
    }
    std::string link = place_.name(*element, "link");
    if (!links_.contains(link)) {
      place_.fail(*element, fmt::format("the {} of joint \"{}\" is \"{}\", which is no link", which,
                                        place_.name(joint, "name"), link));
    }
    return link;
  }

  static std::string some(std::vector<std::string> names) {
    constexpr std::size_t most = 10;
    const std::size_t more = names.size() > most ? names.size() - most : 0;
    names.resize(names.size() - more);
    return fmt::format("\"{}\"{}", fmt::join(names, "\", \""), more > 0 ? fmt::format(" and {} more", more) : "");
  }

  const Place& place_;
  std::map<std::string, const XMLElement*> links_;
  std::map<std::string, const XMLElement*> before_;        // joints, by their child
  std::map<std::string, std::vector<std::string>> after_;  // children, by parent
};

Motion motion_of(const XMLElement& joint, const Place& place) {
  const std::string name = place.name(joint, "name"), type = place.name(joint, "type");
  if (type == "fixed") return Motion::none;
  if (type != "revolute" && type != "continuous" && type != "prismatic") {
    place.fail(joint, fmt::format("joint \"{}\" is {}; expected revolute, continuous, prismatic or fixed", name, type));
  }
  if (joint.FirstChildElement("mimic") != nullptr) {
    place.fail(joint, fmt::format("joint \"{}\" mimics another; expected joints that move by themselves", name));
  }
  return type == "prismatic" ? Motion::slides : Motion::turns;
}

DescribedJoint described(const XMLElement& joint, const Place& place) {
  DescribedJoint read{.name = place.name(joint, "name"), .motion = motion_of(joint, place)};
  if (const XMLElement* const origin = joint.FirstChildElement("origin")) {
    read.origin.position = place.vector(*origin, "xyz", read.origin.position);
    read.origin.rpy = place.vector(*origin, "rpy", read.origin.rpy);
    if (!(read.origin.position.cwiseAbs().maxCoeff() <= lengths_m.second)) {
      place.fail(*origin,
                 fmt::format("xyz of joint \"{}\" has lengths of more than {} m", read.name, lengths_m.second));
    }
  }
  if (read.motion == Motion::none) return read;  // its axis is often 0 0 0
  if (const XMLElement* const axis = joint.FirstChildElement("axis")) {
    read.axis = place.vector(*axis, "xyz", read.axis);
    if (!(read.axis.norm() > 1e-6)) {
      place.fail(*axis,
                 fmt::format("the axis of joint \"{}\" has no direction; expected one such as 0 0 1", read.name));
    }
    read.axis.normalize();
  }
  return read;
}

// Lower and upper limit; infinite if the joint turns without end.
Eigen::Vector2d limits_of(const XMLElement& joint, const Place& place, UrdfChoice::Limits which) {
  const std::string name = place.name(joint, "name"), type = place.name(joint, "type");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (type == "continuous") return {-infinity, infinity};
  const XMLElement* const limit = joint.FirstChildElement("limit");
  if (limit == nullptr) {
    place.fail(joint,
               fmt::format("joint \"{}\" is {} and has no <limit>; expected one, or type continuous", name, type));
  }
  Eigen::Vector2d limits(place.number(*limit, "lower", 0), place.number(*limit, "upper", 0));
  const XMLElement* const safety = joint.FirstChildElement("safety_controller");
  if (which == UrdfChoice::Limits::soft && safety != nullptr) {
    limits[0] = std::max(limits[0], place.number(*safety, "soft_lower_limit", -infinity));
    limits[1] = std::min(limits[1], place.number(*safety, "soft_upper_limit", infinity));
  }
  const double most = type == "prismatic" ? lengths_m.second : angles_deg.second * degree;
  if (!(limits[0] < limits[1]) || !(limits.cwiseAbs().maxCoeff() <= most)) {
    place.fail(*limit,
               fmt::format("the limits of joint \"{}\" are {:g} and {:g}; expected the lower and then the upper, "
                           "within +-{:.6g}",
                           name, limits[0], limits[1], most));
  }
  return limits;
}

// The largest move of the tool by snapping, over a thousand configurations [m].
double moved_by_snapping(const Description& printed, const Description& snapped, const JointLimits& limits) {
  Random random(Key(1).with("snapping"));
  Configuration q = Configuration::Zero(limits.lower.size());
  const JointLimits range = limits.around(q);
  double farthest = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    for (Eigen::Index j = 0; j < q.size(); ++j) q[j] = random.uniform(range.lower[j], range.upper[j]);
    const Eigen::Vector3d moved = pose_of(printed, q).translation() - pose_of(snapped, q).translation();
    farthest = std::max(farthest, moved.norm());
  }
  return farthest;
}

const XMLElement& parsed(tinyxml2::XMLDocument& document, std::string_view text, const Place& place) {
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    place.fail(std::max(document.ErrorLineNum(), 1),
               document.ErrorID() == tinyxml2::XML_ERROR_EMPTY_DOCUMENT
                   ? "the file is empty; expected a <robot>"
                   : fmt::format("not XML: {}", tinyxml2::XMLDocument::ErrorIDToName(document.ErrorID())));
  }
  XacroFinder xacro;
  document.Accept(&xacro);
  if (xacro.line > 0) place.fail(xacro.line, "this is xacro; " + expand_command(place.file()));
  const XMLElement* const robot = document.RootElement();
  if (robot == nullptr || std::string_view(robot->Name()) != "robot") {
    place.fail(robot == nullptr ? 1 : robot->GetLineNum(), "expected a URDF file, whose outermost element is <robot>");
  }
  return *robot;
}

}  // namespace

bool is_urdf_file(std::string_view name) { return name.ends_with(".urdf") || name.ends_with(".xacro"); }

Robot parse_urdf(std::string_view text, const std::filesystem::path& file, const UrdfChoice& choice) {
  const Place place(file);
  if (file.extension() == ".xacro") place.fail(1, "this is xacro; " + expand_command(file));
  tinyxml2::XMLDocument document;
  const XMLElement& robot = parsed(document, text, place);
  const std::string name = place.name(robot, "name");
  const Tree tree(robot, place);
  for (const auto& [key, link] : {std::pair{"base", choice.base}, std::pair{"tip", choice.tip}}) {
    if (!link.empty()) tree.expect_link(key, link);
  }
  const std::string base = !choice.base.empty()  ? choice.base
                           : !choice.tip.empty() ? tree.root_of(choice.tip)
                                                 : tree.root();
  const std::string tip = choice.tip.empty() ? tree.deepest(base) : choice.tip;

  Description printed;
  std::vector<Eigen::Vector2d> limits;
  std::vector<std::string> notes;
  if (choice.tip.empty()) notes.push_back(tree.note_on_ends(base, tip));
  std::erase(notes, "");
  for (const XMLElement* const joint : tree.path(base, tip)) {
    printed.push_back(described(*joint, place));
    if (printed.back().motion == Motion::none) continue;
    limits.push_back(limits_of(*joint, place, choice.limits));
    const bool has_limit = joint->FirstChildElement("limit") != nullptr &&
                           (joint->FirstChildElement("limit")->Attribute("lower") != nullptr ||
                            joint->FirstChildElement("limit")->Attribute("upper") != nullptr);
    if (!limits.back().allFinite() && has_limit) {
      notes.push_back(fmt::format("joint \"{}\" is continuous: its limits are ignored", printed.back().name));
    }
  }
  Description snapped = printed;
  const int angles = snap(snapped, choice.snap);
  try {
    Robot arm{.name = file.stem().string(),
              .summary = fmt::format("{} from {} to {}", name, base, tip),
              .source = file.filename().string(),
              .chain = chain_of(snapped)};
    arm.limits.lower.resize(arm.joints());
    arm.limits.upper.resize(arm.joints());
    for (Eigen::Index j = 0; j < arm.joints(); ++j) {
      arm.limits.lower[j] = limits[static_cast<std::size_t>(j)][0];
      arm.limits.upper[j] = limits[static_cast<std::size_t>(j)][1];
    }
    if (angles > 0) {
      arm.snapped = moved_by_snapping(printed, snapped, arm.limits);
      notes.push_back(
          fmt::format("{} angles are snapped, which moves the tool by at most {:.2g} um", angles, 1e6 * arm.snapped));
    }
    arm.base = base;
    arm.tip = tip;
    arm.description = std::move(snapped);
    arm.notes = std::move(notes);
    return arm;
  } catch (const std::invalid_argument& error) {
    place.fail(robot, error.what());
  }
}

}  // namespace ikbench::robots
