#include "analysis/figures/arm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ikbench::figures {

using namespace inference;

namespace {

Point along(const Point& from, double length, const Point& direction) {
  Point to = from;
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += length * direction[i];
  return to;
}

// u cos(angle) + v sin(angle)
Point turned(const Point& u, const Point& v, double angle) {
  return along(along({0, 0, 0}, std::cos(angle), u), std::sin(angle), v);
}

// Denavit and Hartenberg's: about z by the joint's angle, d along z, a along x, about x by alpha.
std::vector<Point> chain_points(const Definition& definition, const std::vector<double>& angles_rad) {
  std::vector<Point> points{{0, 0, 0}};
  Point x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  for (std::size_t joint = 0; joint < angles_rad.size(); ++joint) {
    const auto link = [&](const char* field) {
      return definition.number(fmt::format("/arm/links/{}/{}", joint, field));
    };
    const double angle = angles_rad[joint] + link("offset_rad");
    const Point x_before = x;
    x = turned(x, y, angle);
    y = turned(y, along({0, 0, 0}, -1, x_before), angle);
    points.push_back(along(points.back(), link("d_m"), z));
    points.push_back(along(points.back(), link("a_m"), x));
    const Point y_before = y;
    y = turned(y, z, link("alpha_rad"));
    z = turned(z, along({0, 0, 0}, -1, y_before), link("alpha_rad"));
  }
  const std::vector<double> tip = definition.numbers("/arm/tip_m");
  if (tip.size() == 3) points.push_back(along(along(along(points.back(), tip[0], x), tip[1], y), tip[2], z));
  points.erase(std::unique(points.begin(), points.end()), points.end());  // a length of 0 is no corner
  return points;
}

// The linkage holds the forearm's angle to the horizontal, whatever the upper arm does, and the tool level.
std::vector<Point> dobot_points(const Definition& definition, const std::vector<double>& angles_rad) {
  if (angles_rad.size() < 3) return {};
  const auto length = [&](const char* field) { return definition.number(fmt::format("/arm/{}", field)); };
  const Point up{0, 0, 1}, down{0, 0, -1};
  const Point level = turned({1, 0, 0}, {0, 1, 0}, angles_rad[0]);
  std::vector<Point> points{{0, 0, 0}, {0, 0, length("height_m")}};
  points.push_back(along(points.back(), length("upper_arm_m"), turned(up, level, angles_rad[1])));
  points.push_back(along(points.back(), length("forearm_m"), turned(level, down, angles_rad[2])));
  points.push_back(along(points.back(), length("wrist_to_tool_m"), level));
  return points;
}

}  // namespace

std::vector<Point> arm_points(const Definition& definition, const std::vector<double>& angles_rad) {
  std::vector<Point> points;
  const std::string kind = definition.text("/arm/kind");
  if (kind == "denavit_hartenberg") points = chain_points(definition, angles_rad);
  if (kind == "dobot_magician") points = dobot_points(definition, angles_rad);
  const auto is_finite = [](const Point& point) {
    return std::ranges::all_of(point, [](double coordinate) { return std::isfinite(coordinate); });
  };
  return std::ranges::all_of(points, is_finite) ? points : std::vector<Point>();
}

}  // namespace ikbench::figures
