#include "robots/urdf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "base/names.hpp"
#include "base/number.hpp"
#include "robots/arm_fields.hpp"
#include "robots/description.hpp"

namespace ikbench::robots {

using namespace base;
using tinyxml2::XMLAttribute;
using tinyxml2::XMLElement;

namespace {

using Motion = DescribedJoint::Motion;

bool is_joint(const XMLElement& element) { return std::string_view(element.Name()) == "joint"; }

// A file, for messages about places in the file.
class Place {
 public:
  explicit Place(const std::filesystem::path& file) : file_(file) {}

  // Names the joint that has the place, too.
  [[noreturn]] void fail(const XMLElement& at, std::string_view message) const {
    const XMLElement* const parent = at.Parent()->ToElement();
    const XMLElement& joint = parent != nullptr && is_joint(*parent) ? *parent : at;
    const char* const name = is_joint(joint) ? joint.Attribute("name") : nullptr;
    fail(at.GetLineNum(),
         name == nullptr ? std::string(message) : fmt::format("joint \"{}\": {}", shown(name), message));
  }
  [[noreturn]] void fail(int line, std::string_view message) const { throw std::invalid_argument(at(line, message)); }
  std::string at(int line, std::string_view message) const {
    return fmt::format("{}:{}: {}", file_.string(), line, message);
  }

  [[noreturn]] void fail_as_xacro(const XMLElement& at) const {
    fail(at, fmt::format("this is xacro; expand it first: xacro {} > expanded.urdf", file_.filename().string()));
  }
  void refuse_xacro(const XMLElement& at, std::string_view text) const {
    if (text.find("${") != std::string_view::npos || text.find("$(") != std::string_view::npos) fail_as_xacro(at);
  }

  // Returns the name in an attribute.
  std::string name(const XMLElement& at, const char* attribute) const {
    const char* const text = at.Attribute(attribute);
    if (text == nullptr || *text == '\0') fail(at, fmt::format("<{}> has no {}", at.Name(), attribute));
    if (!is_plain(text)) fail(at, fmt::format("a {} is not {}", attribute, plain_text));
    return text;
  }

  // Refuses elements that would be left out silently: misspelt or doubled tags, and xacro.
  void refuse_stray(const XMLElement& joint) const {
    const std::vector<std::string> read{"origin", "axis", "limit", "mimic", "parent", "child", "safety_controller"};
    std::set<std::string> seen;
    for (const XMLElement* each = joint.FirstChildElement(); each != nullptr; each = each->NextSiblingElement()) {
      const std::string name = each->Name(), lower = lower_case(name), meant = nearest_name(lower, read);
      if (name.starts_with("xacro:")) fail_as_xacro(*each);
      if (meant.empty() || meant.front() != lower.front()) continue;  // a tag of another program
      if (meant != name) fail(*each, fmt::format("unknown <{}>; did you mean <{}>?", shown(name), meant));
      if (!seen.insert(name).second) fail(*each, fmt::format("a second <{}>; expected one", name));
    }
  }

  // Refuses attributes that are not among these. If the element may have others, refuses only misspelt ones.
  void refuse_unknown(const XMLElement& at, const std::vector<std::string>& known, bool may_have_others) const {
    for (const XMLAttribute* each = at.FirstAttribute(); each != nullptr; each = each->Next()) {
      const bool is_other = may_have_others && nearest_name(lower_case(each->Name()), known).empty();
      if (is_other || std::ranges::count(known, each->Name()) > 0) continue;
      fail(at, fmt::format("<{}> has the unknown attribute \"{}\"; expected {}", at.Name(), shown(each->Name()),
                           fmt::join(known, ", ")));
    }
  }

  Eigen::Vector4d numbers(const XMLElement& at, const char* attribute, int count, double most = 1e6) const {
    const char* const given = at.Attribute(attribute);
    if (given == nullptr) fail(at, fmt::format("<{}> has no {}", at.Name(), attribute));
    const std::string_view text = given;
    refuse_xacro(at, text);
    Eigen::Vector4d values = Eigen::Vector4d::Zero();
    std::istringstream words{std::string(text)};
    std::string number;
    int found = 0;
    for (; words >> number; ++found) {
      const std::optional<double> value = number_from(number);
      if (found == count || !value || !(std::abs(*value) <= most)) break;
      values[found] = *value;
    }
    if (found != count || words)
      fail(at, fmt::format("{} of <{}> is \"{}\"; expected {}", attribute, at.Name(), shown(text),
                           count == 1 ? "a number" : fmt::format("{} numbers within +-{:g}", count, most)));
    return values;
  }

  double limit(const XMLElement& at, const char* attribute, double if_none) const {
    constexpr double any = std::numeric_limits<double>::infinity();
    return at.Attribute(attribute) == nullptr ? if_none : numbers(at, attribute, 1, any)[0];
  }

  static std::string shown(std::string_view text) { return is_plain(text) ? std::string(text) : "(not printable)"; }

 private:
  const std::filesystem::path& file_;
};

// Returns true for an element that may still bring links: xacro that is more than a definition.
bool is_unexpanded(const XMLElement& element) {
  const std::string_view name = element.Name();
  return name.starts_with("xacro:") && name != "xacro:property" && name != "xacro:macro" && name != "xacro:arg";
}

std::string_view type_of(const XMLElement& joint) {
  const char* const type = joint.Attribute("type");
  return type == nullptr || !is_plain(type) ? "no type" : type;
}

bool floats(const XMLElement& joint) { return type_of(joint) == "floating" || type_of(joint) == "planar"; }

bool mimics(const XMLElement& joint) { return joint.FirstChildElement("mimic") != nullptr; }

bool moves(const XMLElement* joint) { return type_of(*joint) != "fixed" && !floats(*joint); }

bool contains_any(std::string name, const std::vector<std::string_view>& words) {
  name = lower_case(name);
  return std::ranges::any_of(words, [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

bool is_called_jaw(const XMLElement& joint) {
  const XMLElement* const child = joint.FirstChildElement("child");
  return contains_any(std::string(joint.Attribute("name")) + child->Attribute("link"), {"grip", "finger", "jaw"});
}

std::pair<double, double> range_of(const XMLElement& joint) {
  const XMLElement* const limit = joint.FirstChildElement("limit");
  if (limit == nullptr) return {0, 0};
  return {limit->DoubleAttribute("lower"), limit->DoubleAttribute("upper")};
}

// Returns true for a joint that turns by less than half a turn, almost all of it to one side of 0, or slides a few
// centimetres.
bool moves_like_jaw(const XMLElement& joint) {
  const auto [lower, upper] = range_of(joint);
  const double range = upper - lower, less = std::min(std::abs(lower), std::abs(upper));
  if (type_of(joint) == "prismatic") return range > 0 && range <= 0.06;
  return type_of(joint) == "revolute" && less <= 0.15 * range && range > 0 && range < half_turn;
}

// The tree of links and the joints between them.
class Tree {
 public:
  Tree(const XMLElement& robot, const Place& place) : place_(place) {
    for (const XMLElement* link = robot.FirstChildElement("link"); link != nullptr;
         link = link->NextSiblingElement("link")) {
      const std::string name = place.name(*link, "name");
      if (!links_.emplace(name, link).second) place.fail(*link, fmt::format("there are two links \"{}\"", name));
    }
    if (links_.empty()) place.fail(robot, "the robot has no links");
    std::set<std::string> joints;
    for (const XMLElement* joint = robot.FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint")) {
      const std::string name = place.name(*joint, "name"), child = end(*joint, "child"), parent = end(*joint, "parent");
      if (!joints.insert(name).second) place.fail(*joint, "there are two joints of this name");
      const auto [known, is_new] = before_.emplace(child, joint);
      if (!is_new)
        place.fail(*joint, fmt::format("its child, \"{}\", is also that of joint \"{}\"; expected a tree", child,
                                       known->second->Attribute("name")));
      after_[parent].push_back(child);
    }
  }

  // Returns the root of the tree above a link. If joints move only behind a floating joint, returns the link after it.
  std::string root_of(std::string link) const {
    bool is_moved = false;
    const std::vector<const XMLElement*> joints = above(link);
    for (const XMLElement* const joint : joints) {
      if (is_moved && floats(*joint)) {
        if (std::any_of(std::ranges::find(joints, joint), joints.end(), moves))
          place_.fail(*joint,
                      fmt::format("it is {}, and joints move before and after it; to use only those after it, add "
                                  "--base {}, or base = \"{}\" in [urdf]",
                                  type_of(*joint), link, link));
        break;
      }
      is_moved = is_moved || moves(joint);
      link = end(*joint, "parent");
    }
    return link;
  }

  std::vector<std::string> roots() const {
    std::vector<std::string> roots;
    for (const auto& [name, link] : links_)
      if (!before_.contains(name)) roots.push_back(name);
    return roots;
  }

  struct End {
    std::string link;
    int joints = 0;          // behind a root, before another end
    std::string other = {};  // a link that moves with it, if there is one
    bool is_doubtful = false;
    bool is_tool = false;  // by its name
  };
  std::string root() const {
    std::vector<End> all;
    for (const std::string& link : roots()) all.push_back({link, most_behind(link)});
    if (all.empty()) place_.fail(1, "the joints form a cycle; expected a tree");
    return with_most(all, "--base", "no joint leads to several links, so the arm may begin at each").link;
  }
  // Returns the end of an arm, which is behind the most joints. If several links move together, the end is the only
  // leaf; if there are several leaves, the tool's frame, otherwise the link that carries them. An arm with a hand ends
  // at the link that carries the hand.
  End end_behind(const std::string& base) const {
    std::vector<End> ends;
    follow(base, 0, ends);
    return with_most(ends, "--tip", "joints branch, so the arm may end at several links");
  }

  // Returns one line per link, indented behind the link before.
  std::string text() const {
    std::string lines;
    for (const auto& [link, depth, moving] : behind(roots())) {
      lines += std::string(2 * std::min<std::size_t>(depth, 40), ' ') + link;
      if (const auto found = before_.find(link); found != before_.end()) {
        const XMLElement& joint = *found->second;
        lines += fmt::format("  ({} {}{})", type_of(joint), joint.Attribute("name"),
                             mimics(joint) ? ", mimics another" : "");
      }
      lines += '\n';
    }
    return lines;
  }

  void expect_link(std::string_view key, const std::string& name) const {
    if (links_.contains(name)) return;
    std::vector<std::string> names;
    for (const auto& [known, link] : links_) names.push_back(known);
    place_.fail(1, fmt::format("{} is \"{}\", which is not a link{}; to see the links: ikbench robot FILE --links", key,
                               name, did_you_mean(name, names)));
  }

  // Returns the joints from the base to the tip.
  std::vector<const XMLElement*> path(const std::string& base, const std::string& tip) const {
    std::vector<const XMLElement*> joints;
    for (const XMLElement* const joint : above(tip)) {
      if (end(*joint, "child") == base) break;
      joints.push_back(joint);
    }
    if (base != tip && (joints.empty() || end(*joints.back(), "parent") != base))
      place_.fail(1, fmt::format("no joints lead from link \"{}\" to link \"{}\"", base, tip));
    std::ranges::reverse(joints);
    return joints;
  }

 private:
  // Returns the link at one end of a joint.
  std::string end(const XMLElement& joint, const char* which) const {
    const XMLElement* const element = joint.FirstChildElement(which);
    if (element == nullptr) place_.fail(joint, fmt::format("it has no <{}>", which));
    std::string link = place_.name(*element, "link");
    if (!links_.contains(link))
      place_.fail(*element, fmt::format("its {} is \"{}\", which is not a link", which, link));
    return link;
  }

  // Returns the joints before a link, the nearest first.
  std::vector<const XMLElement*> above(const std::string& link) const {
    std::vector<const XMLElement*> joints;
    for (auto at = before_.find(link); at != before_.end(); at = before_.find(end(*at->second, "parent"))) {
      if (joints.size() == before_.size())
        place_.fail(1, fmt::format("the joints before link \"{}\" form a cycle; expected a tree", link));
      joints.push_back(at->second);
    }
    return joints;
  }

  // Returns the end with the most joints. Throws LinkQuestion if another end has as many, or more than half as many and
  // the first end is not called a tool, because a sensor may have more joints than an arm.
  End with_most(std::vector<End> ends, const char* option, std::string_view question) const {
    std::ranges::stable_sort(ends, std::greater(), &End::joints);
    const End& first = ends.front();
    const int rivals = ends.size() == 1 ? 0 : ends[1].joints;
    const bool is_clear = rivals < first.joints && (first.is_tool || 2 * rivals <= first.joints);
    if (first.joints == 0 || (is_clear && !first.is_doubtful)) return first;
    std::vector<LinkQuestion::Answer> answers;
    for (const End& each : ends)
      if (each.joints > 0 && answers.size() < 20) answers.push_back({option, each.link, each.joints});
    throw LinkQuestion(place_.at(1, fmt::format("{} (to see the links: ikbench robot FILE --links)", question)),
                       answers);
  }

  int most_behind(const std::string& link) const { return std::ranges::max(behind({link}), {}, &Seen::moving).moving; }

  // Returns the last link on the way to both links.
  std::string fork_before(const std::string& one, std::string other) const {
    std::set<std::string> way{one};
    for (const XMLElement* const joint : above(one)) way.insert(end(*joint, "parent"));
    while (!way.contains(other)) other = end(*before_.at(other), "parent");
    return other;
  }

  // Returns true for joints of a hand: each mimics another, is a jaw or has a twin. Beside two such joints others may
  // differ, as a thumb does.
  bool are_fingers(const std::vector<const XMLElement*>& joints) const {
    std::map<std::string, int> alike;
    std::vector<std::string> others;
    for (const XMLElement* const joint : joints) {
      bool is_jaw = true;
      std::string kind;
      for (const Seen& seen : behind({end(*joint, "child")})) {
        const XMLElement& each = *before_.at(seen.link);
        if (!moves(&each)) continue;
        const auto [lower, upper] = range_of(each);
        kind += fmt::format("{} {:.3g} ", type_of(each), upper - lower);
        const int hints = (is_called_jaw(each) ? 1 : 0) + (moves_like_jaw(each) ? 1 : 0);
        is_jaw = is_jaw && (mimics(each) || hints > (joints.size() == 1 ? 1 : 0));
      }
      ++alike[kind];
      if (!is_jaw) others.push_back(kind);
    }
    std::erase_if(others, [&](const std::string& kind) { return alike[kind] > 1; });
    return others.empty() || joints.size() > others.size() + 1;
  }

  // Adds the ends behind a link, and the links at which joints branch.
  void follow(const std::string& link, int joints, std::vector<End>& ends) const {
    std::vector<std::string> leaves, carriers;  // links that move with it: the last ones, and those before a next joint
    std::vector<const XMLElement*> next;
    int longest = 0;
    for (const Seen& seen : behind({link})) {
      longest = std::max(longest, seen.moving);
      if (seen.moving == 0 && !after_.contains(seen.link)) leaves.push_back(seen.link);
      if (seen.moving != 1 || !moves(before_.at(seen.link))) continue;
      next.push_back(before_.at(seen.link));
      carriers.push_back(end(*next.back(), "parent"));
    }
    const auto is_jaw = [](const std::string& leaf) { return contains_any(leaf, {"jaw", "finger"}); };
    const bool is_beside_jaw = joints > 0 && next.size() == 1 && longest == 1 && is_called_jaw(*next[0]) &&
                               std::ranges::count_if(leaves, is_jaw) == 1;  // which is fixed, so it is the tool
    const bool is_end = next.empty() || joints > max_joints || is_beside_jaw || (joints > longest && are_fingers(next));
    const bool may_be_jaw = !is_end && joints > 0 && next.size() == 1 && longest == 1 &&
                            (is_called_jaw(*next[0]) || moves_like_jaw(*next[0]));
    if (is_end || may_be_jaw || (next.size() > 1 && joints > 0)) {
      const std::vector<std::string>& last = carriers.empty() ? leaves : carriers;
      End& at = ends.emplace_back(End{last.empty() ? link : fork_before(last.front(), last.back()), joints});
      if (is_beside_jaw) at.link = *std::ranges::find_if(leaves, is_jaw);
      for (const auto& words :
           {std::vector<std::string_view>{"tool", "tcp", "end_effector", "ee_", "_ee", "eef"}, {"tool0"}}) {
        const auto is_tool = [&](const std::string& leaf) { return contains_any(leaf, words); };
        if (std::ranges::count_if(leaves, is_tool) != 1) continue;
        at.link = *std::ranges::find_if(leaves, is_tool);
        at.is_tool = true;
      }
      at.other = at.link == link && !leaves.empty() ? leaves.front() : link;
    }
    const std::size_t known = ends.size();
    for (const XMLElement* const joint : next)
      if (!is_end) follow(end(*joint, "child"), joints + 1, ends);
    for (std::size_t i = known; i < ends.size(); ++i) ends[i].is_doubtful |= may_be_jaw;
  }

  struct Seen {
    std::string link;
    std::size_t depth;
    int moving;  // joints before it
  };
  // Returns these links and all links behind them, each after the link before.
  std::vector<Seen> behind(const std::vector<std::string>& links) const {
    std::vector<Seen> all, next;
    for (auto link = links.rbegin(); link != links.rend(); ++link) next.push_back({*link, 0, 0});
    while (!next.empty() && all.size() <= links_.size()) {
      const Seen at = all.emplace_back(next.back());
      next.pop_back();
      if (!after_.contains(at.link)) continue;
      const std::vector<std::string>& children = after_.at(at.link);
      for (auto child = children.rbegin(); child != children.rend(); ++child)
        next.push_back({*child, at.depth + 1, at.moving + (moves(before_.at(*child)) ? 1 : 0)});
    }
    return all;
  }

  const Place& place_;
  std::map<std::string, const XMLElement*> links_;
  std::map<std::string, const XMLElement*> before_;        // joints, by their child
  std::map<std::string, std::vector<std::string>> after_;  // children, by parent
};

Motion motion_of(const XMLElement& joint, const Place& place) {
  const std::string_view type = type_of(joint);
  if (type == "fixed") return Motion::none;
  if (type != "revolute" && type != "continuous" && type != "prismatic")
    place.fail(joint, fmt::format("its type is {}; expected revolute, continuous, prismatic or fixed", type));
  if (mimics(joint)) place.fail(joint, "it mimics another joint; expected joints that move by themselves");
  return type == "prismatic" ? Motion::slides : Motion::turns;
}

void read_origin(const XMLElement& origin, const Place& place, DescribedJoint& joint) {
  const auto has = [&](std::string_view attribute) { return origin.Attribute(attribute.data()) != nullptr; };
  place.refuse_unknown(origin, {"xyz", "rpy", "quat_xyzw"}, false);
  if (has("rpy") && has("quat_xyzw")) place.fail(origin, "<origin> has rpy and quat_xyzw; expected one");
  if (has("rpy")) {
    const Eigen::Vector3d rpy = place.numbers(origin, "rpy", 3).head<3>();
    for (const double value : rpy)
      if (const std::string_view doubt = doubt_of_angle(value, 1); !doubt.empty())
        place.fail(origin, fmt::format("rpy has {}, which {}", value, doubt));
    joint.origin.rpy = rpy;
  } else if (has("quat_xyzw")) {
    const Eigen::Vector4d values = place.numbers(origin, "quat_xyzw", 4);
    if (!(values.norm() > 1e-6)) place.fail(origin, "quat_xyzw is 0; expected a quaternion");
    Pose turned = Pose::Identity();
    turned.linear() = Eigen::Quaterniond(values / values.norm()).toRotationMatrix();
    joint.origin.rpy = frame_of(turned).rpy;
  }
  if (has("xyz")) joint.origin.position = place.numbers(origin, "xyz", 3, lengths_m.second).head<3>();
}

DescribedJoint described(const XMLElement& joint, const Place& place) {
  place.refuse_stray(joint);
  DescribedJoint read{.name = place.name(joint, "name"), .motion = motion_of(joint, place)};
  place.refuse_xacro(joint, read.name);
  if (const XMLElement* const origin = joint.FirstChildElement("origin")) read_origin(*origin, place, read);
  const XMLElement* const axis = joint.FirstChildElement("axis");
  if (read.motion == Motion::none || axis == nullptr) return read;  // the axis of a fixed joint is often 0 0 0
  const Eigen::Vector3d direction = place.numbers(*axis, "xyz", 3).head<3>();
  if (!(direction.norm() > 1e-6)) place.fail(*axis, "its axis has no direction; expected one such as 0 0 1");
  read.axis = direction.normalized();
  return read;
}

// Returns the lower and the upper limit [rad, m]; infinite for a continuous joint.
Eigen::Vector2d limits_of(const XMLElement& joint, const Place& place, UrdfChoice::Limits which) {
  constexpr double infinity = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
  if (type_of(joint) == "continuous") return {-infinity, infinity};
  const bool slides = type_of(joint) == "prismatic";
  const std::string_view advice =
      slides ? "a prismatic joint needs limits in metres, such as <limit lower=\"0\" upper=\"0.5\"/>"
             : "if it has no limits, its type is continuous";
  const XMLElement* const limit = joint.FirstChildElement("limit");
  if (limit == nullptr) place.fail(joint, fmt::format("it is {} and has no <limit>; {}", type_of(joint), advice));
  place.refuse_unknown(*limit, {"lower", "upper"}, true);
  const bool has_some = limit->Attribute("lower") != nullptr || limit->Attribute("upper") != nullptr;
  const double missing = has_some ? 0 : none;  // what the format says of one
  Eigen::Vector2d limits(place.limit(*limit, "lower", missing), place.limit(*limit, "upper", missing));
  const XMLElement* const safety = joint.FirstChildElement("safety_controller");
  if (which == UrdfChoice::Limits::soft && safety != nullptr) {
    limits[0] = std::max(limits[0], place.limit(*safety, "soft_lower_limit", -infinity));
    limits[1] = std::min(limits[1], place.limit(*safety, "soft_upper_limit", infinity));
  }
  const bool are_whole = limits == limits.array().round().matrix();  // as degrees are, beyond three turns
  if (!slides && are_whole && limits.cwiseAbs().maxCoeff() > 6 * half_turn)
    place.fail(*limit, fmt::format("its limits are {:g} and {:g} rad, more than one turn; if these are degrees, write "
                                   "{:.6g} and {:.6g}; {}",
                                   limits[0], limits[1], limits[0] * degree, limits[1] * degree, advice));
  const auto shown = [](double value) { return std::isnan(value) ? "none" : fmt::format("{:g}", value); };
  const double most = slides ? lengths_m.second : angles_deg.second * degree;
  if (!(limits[0] < limits[1]) || !(limits.cwiseAbs().maxCoeff() <= most))
    place.fail(*limit,
               fmt::format("its limits are {} and {}; expected the lower and then the upper, within +-{:.6g} {}; {}",
                           shown(limits[0]), shown(limits[1]), most, slides ? "m" : "rad", advice));
  return limits;
}

// The parser compares each attribute of an element with all before it.
void refuse_many_attributes(std::string_view text, const Place& place) {
  constexpr int most = 1000;
  for (std::size_t at = text.find('<'); at < text.size(); at = text.find('<', at)) {
    const bool is_comment = text.substr(at).starts_with("<!--"), is_data = text.substr(at).starts_with("<![CDATA[");
    if (is_comment || is_data) at = text.find(is_comment ? "-->" : "]]>", at);
    for (int attributes = 0; at < text.size() && text[at] != '>'; ++at) {
      if (text[at] != '"' && text[at] != '\'') continue;
      at = std::min(text.find(text[at], at + 1), text.size() - 1);
      if (++attributes > most)
        place.fail(static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')) + 1,
                   fmt::format("an element has more than {} attributes", most));
    }
  }
}

const XMLElement& parsed(tinyxml2::XMLDocument& document, std::string_view text, const Place& place) {
  if (text.starts_with("version https://git-lfs"))
    place.fail(1, "this is a pointer of Git LFS, not the file; fetch it: git lfs pull");
  refuse_many_attributes(text, place);
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS)
    place.fail(std::max(document.ErrorLineNum(), 1),
               document.ErrorID() == tinyxml2::XML_ERROR_EMPTY_DOCUMENT
                   ? "the file is empty; expected a <robot>"
                   : "not well-formed XML: near this line a tag, a comment or a quote is not closed, or an attribute "
                     "is not NAME=\"VALUE\"");
  const XMLElement* const robot = document.RootElement();
  if (robot == nullptr) place.fail(1, "it has no element; expected a URDF file with a <robot>");
  if (std::string_view(robot->Name()) != "robot")
    place.fail(robot->GetLineNum(),
               fmt::format("this is <{}>; expected a URDF file, whose outermost element is <robot>",
                           Place::shown(robot->Name())));
  return *robot;
}

// Returns the end of the chosen arm. Throws LinkQuestion if the file leaves the end open.
Tree::End end_of(const Tree& tree, const UrdfChoice& choice) {
  if (!choice.tip.empty()) return {.link = choice.tip};
  return tree.end_behind(choice.base.empty() ? tree.root() : choice.base);
}

}  // namespace

bool is_urdf_file(std::string_view name) {
  const std::string ending = lower_case(name.substr(std::min(name.rfind('.'), name.size())));
  return ending == ".urdf" || ending == ".xacro";
}

std::string link_tree(std::string_view text, const std::filesystem::path& file) {
  const Place place(file);
  tinyxml2::XMLDocument document;
  return Tree(parsed(document, text, place), place).text();
}

Robot parse_urdf(std::string_view text, const std::filesystem::path& file, const UrdfChoice& choice) {
  const Place place(file);
  tinyxml2::XMLDocument document;
  const XMLElement& robot = parsed(document, text, place);
  for (const XMLElement* each = robot.FirstChildElement(); each != nullptr; each = each->NextSiblingElement())
    if ((choice.tip.empty() || choice.base.empty()) && is_unexpanded(*each)) place.fail_as_xacro(*each);
  const bool lacks_parts = robot.Attribute("name") == nullptr || robot.FirstChildElement("link") == nullptr;
  if (lacks_parts && text.find("xacro") != std::string_view::npos) place.fail_as_xacro(robot);
  const std::string name = place.name(robot, "name");
  const Tree tree(robot, place);
  for (const auto& [key, link] : {std::pair{"base", choice.base}, std::pair{"tip", choice.tip}})
    if (!link.empty()) tree.expect_link(key, link);
  const Tree::End end = end_of(tree, choice);
  const std::string& tip = end.link;
  const std::string base = choice.base.empty() ? tree.root_of(tip) : choice.base;

  Description joints;
  std::vector<double> lower, upper, velocity;
  int wide = 0;  // joints whose limits are more than a turn
  for (const XMLElement* const joint : tree.path(base, tip)) {
    joints.push_back(described(*joint, place));
    if (joints.back().motion == Motion::none) continue;
    const Eigen::Vector2d limits = limits_of(*joint, place, choice.limits);
    const double unit = joints.back().motion == Motion::slides ? 1 : degree;  // as a stored arm has them
    lower.push_back(in_unit(limits[0], unit) * unit);
    upper.push_back(in_unit(limits[1], unit) * unit);
    const XMLElement* const limit = joint->FirstChildElement("limit");
    const double fastest = limit == nullptr ? 0 : place.limit(*limit, "velocity", 0);
    velocity.push_back(fastest > 0 && fastest < 1000 ? fastest : 0);  // 1000, as we write, or a million stands for none
    if (joints.back().motion == Motion::turns && limits.allFinite() && limits.cwiseAbs().maxCoeff() > 1.01 * whole_turn)
      ++wide;
  }
  if (lower.empty())
    place.fail(1,
               fmt::format("no joint moves between links \"{}\" and \"{}\"; choose others with --base LINK --tip LINK; "
                           "to see the links: ikbench robot FILE --links",
                           base, tip));
  try {
    Robot arm{.name = file.stem().string(),
              .summary = fmt::format("{} from {} to {}", name, base, tip),
              .source = file.filename().string(),
              .chain = chain_of(joints),
              .description = joints,
              .base_link = base,
              .tip_link = tip};
    arm.limits = {Configuration::Map(lower.data(), arm.joints()), Configuration::Map(upper.data(), arm.joints())};
    if (std::ranges::max(velocity) > 0) arm.velocity = Configuration::Map(velocity.data(), arm.joints());
    if (end.other != tip) arm.other_tip = end.other;
    if (wide > 0)
      arm.notes.push_back(fmt::format("{} may turn by more than one turn in each direction", counted(wide, "joints")));
    return arm;
  } catch (const std::invalid_argument& error) {
    place.fail(robot, error.what());
  }
}

}  // namespace ikbench::robots
