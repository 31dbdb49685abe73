#include "analysis/figures/arm.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <string_view>

#include "analysis/statistics/descriptive.hpp"

namespace ikbench::figures {

using namespace statistics;
using namespace inference;

namespace {

using nlohmann::json;

constexpr double degree = std::numbers::pi / 180;
constexpr std::size_t most_joints = 64;

// A number of an arm, or a list of them; it is known where it is within 3600.
bool is_length(const json& value) { return value.is_number() && std::abs(value.get<double>()) <= 3600; }

bool are_lengths(const json& values, std::size_t size) {
  return values.is_array() && values.size() == size && std::ranges::all_of(values, is_length);
}

std::optional<ArmLink> link_of(const json& link) {
  if (!link.is_object()) return std::nullopt;
  const json joint = link.value("joint", json("turns"));
  using enum ArmLink::Joint;
  if (joint != "turns" && joint != "slides" && joint != "coupled") return std::nullopt;
  for (const char* name : {"offset_deg", "d_m", "a_m", "alpha_deg"}) {
    if (!is_length(link.value(name, json()))) return std::nullopt;
  }
  const auto number = [&](const char* name) { return link[name].get<double>(); };
  ArmLink known{.joint = joint == "slides"    ? slides
                         : joint == "coupled" ? coupled
                                              : turns,
                .offset_rad = number("offset_deg") * degree,
                .d_m = number("d_m"),
                .a_m = number("a_m"),
                .alpha_rad = number("alpha_deg") * degree,
                .lower = not_defined,
                .upper = not_defined};
  const json limits = link.value(known.joint == slides ? "limits_m" : "limits_deg", json());
  const double unit = known.joint == slides ? 1 : degree;
  if (are_lengths(limits, 2)) {
    known.lower = limits[0].get<double>() * unit;
    known.upper = limits[1].get<double>() * unit;
  } else if (limits == "none") {
    known.lower = -std::numeric_limits<double>::infinity();
    known.upper = std::numeric_limits<double>::infinity();
  }
  return known;
}

std::optional<ArmFrame> frame_of(const json& arm, const char* name) {
  const json frame = arm.value(name, json());
  if (!frame.is_object()) return std::nullopt;
  const json position = frame.value("position_m", json()), rpy = frame.value("rpy_deg", json());
  if (!are_lengths(position, 3) || !are_lengths(rpy, 3)) return std::nullopt;
  ArmFrame known{position.get<Point>(), rpy.get<Point>()};
  for (double& angle : known.rpy_rad) angle *= degree;
  return known;
}

Point along(const Point& from, double length, const Point& direction) {
  Point to = from;
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += length * direction[i];
  return to;
}

// A frame that is carried along the arm.
struct Carried {
  Point at{0, 0, 0};
  std::array<Point, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  void move(const Point& by) {
    for (std::size_t axis = 0; axis < 3; ++axis) at = along(at, by[axis], axes[axis]);
  }
  // About one axis, from the one after it to the third.
  void turn(std::size_t about, double angle) {
    Point &u = axes[(about + 1) % 3], &v = axes[(about + 2) % 3];
    const Point u_before = u, none{0, 0, 0};
    u = along(along(none, std::cos(angle), u), std::sin(angle), v);
    v = along(along(none, std::cos(angle), v), -std::sin(angle), u_before);
  }
  void enter(const ArmFrame& frame) {
    move(frame.position_m);
    for (const std::size_t axis : {2U, 1U, 0U}) turn(axis, frame.rpy_rad[axis]);
  }
};

constexpr std::size_t about_x = 0, about_y = 1, about_z = 2;

}  // namespace

std::optional<Arm> arm_of(const StudyFacts& facts) {
  if (!facts.arm.is_object()) return std::nullopt;
  const json links = facts.arm.value("links", json());
  const std::optional<ArmFrame> base = frame_of(facts.arm, "base"), tool = frame_of(facts.arm, "tool");
  if (!links.is_array() || links.empty() || links.size() > most_joints || !base || !tool) return std::nullopt;
  Arm known{.links = {}, .base = *base, .tool = *tool};
  for (const json& each : links) {
    const std::optional<ArmLink> link = link_of(each);
    if (!link) return std::nullopt;
    known.links.push_back(*link);
  }
  return known;
}

std::vector<Point> arm_points(const StudyFacts& facts, const std::vector<double>& angles_rad) {
  const std::optional<Arm> arm = arm_of(facts);
  const auto is_finite = [](double value) { return std::isfinite(value); };
  if (!arm || angles_rad.size() != arm->links.size() || !std::ranges::all_of(angles_rad, is_finite)) return {};
  Carried frame;
  std::vector<Point> points{frame.at};
  const auto corner = [&] { points.push_back(frame.at); };
  frame.enter(arm->base);
  corner();
  for (std::size_t joint = 0; joint < arm->links.size(); ++joint) {
    const ArmLink& link = arm->links[joint];
    const bool slides = link.joint == ArmLink::Joint::slides, is_coupled = link.joint == ArmLink::Joint::coupled;
    const std::size_t about = is_coupled ? about_y : about_z;
    const double angle = slides ? link.offset_rad : angles_rad[joint] + link.offset_rad;
    frame.turn(about, angle);
    frame.move({0, 0, slides ? link.d_m + angles_rad[joint] : link.d_m});
    corner();
    frame.move({link.a_m, 0, 0});
    corner();
    if (is_coupled) frame.turn(about, -angle);
    frame.turn(about_x, link.alpha_rad);
  }
  frame.enter(arm->tool);
  corner();
  points.erase(std::unique(points.begin(), points.end()), points.end());  // a length of 0 is no corner
  return points;
}

}  // namespace ikbench::figures
