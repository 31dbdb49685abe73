#include "robots/spherical_wrist.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/units.hpp"
#include "numerics/functions.hpp"

namespace ikbench::robots {

using namespace numerics;

namespace {

constexpr double exact = 1e-10;  // [m], [rad]: so little stays below what an answer may be off by rounding

// How far the axes of the last three joints are from a common point [m], and from right angles to the next [rad].
struct Misfit {
  double length, angle;
};
Misfit misfit_of(const Chain& whole) {
  const DhLink* last = &whole.links().back();
  const DhLink &first = last[-2], &middle = last[-1];
  const auto from_right_angle = [](const DhLink& link) {
    const double cosine = sin_cos(link.alpha).cosine;
    return std::abs(arc_tangent(cosine, std::sqrt(1 - cosine * cosine)));
  };
  return {std::max({std::abs(first.a), std::abs(middle.a), std::abs(middle.d)}),
          std::max(from_right_angle(first), from_right_angle(middle))};
}

// Returns true if the closed form applies to the last three joints: it knows no beta, and takes the sense of an angle
// from the sign of its alpha.
bool ends_in_revolute_joints(const Chain& whole) {
  if (whole.joints() < 4) return false;
  return std::all_of(whole.links().end() - 3, whole.links().end(), [](const DhLink& link) {
    return link.joint == Joint::turns && link.beta == 0 && std::abs(link.alpha) <= std::numbers::pi;
  });
}

Chain arm_of(const Chain& whole) {
  if (!SphericalWrist::fits(whole))
    throw std::invalid_argument("the last three axes of this arm do not form a spherical wrist");
  const std::vector<DhLink>& links = whole.links();
  return Chain({links.begin(), links.end() - 3}, whole.base(), {.position = {0, 0, links[links.size() - 3].d}});
}

}  // namespace

bool SphericalWrist::fits(const Chain& whole) {
  if (!ends_in_revolute_joints(whole)) return false;
  const Misfit off = misfit_of(whole);
  return off.length < exact && off.angle < exact;
}

std::string SphericalWrist::misfit(const Chain& whole) {
  if (!ends_in_revolute_joints(whole) || fits(whole)) return "";
  const Misfit off = misfit_of(whole);
  const double length = off.length < exact ? 0 : off.length, angle = off.angle < exact ? 0 : off.angle;
  const bool may_be_rounded = length < 1e-4 && angle > 0 && angle < 1e-3;
  std::vector<std::string> reasons;
  if (length > 0) reasons.push_back(fmt::format("{:.3g} mm from a common point", 1000 * length));
  if (angle > 0) reasons.push_back(fmt::format("{:.3g} deg from right angles", angle / base::degree));
  return fmt::format(
      "its last three axes are {}{}", fmt::join(reasons, " and "),
      may_be_rounded ? " (with exact angles in its file, such as 1.5707963267948966, it may have one)" : "");
}

SphericalWrist::SphericalWrist(const Chain& whole) : arm_(arm_of(whole)) {
  const DhLink* last = &whole.links().back();
  const DhLink &first = last[-2], &middle = last[-1], &third = last[0];
  offsets_ = {first.offset, middle.offset, third.offset};
  if (first.alpha * middle.alpha > 0)
    offsets_ += Eigen::Vector3d(0, std::numbers::pi, -std::numbers::pi);  // as with -middle.alpha
  sense_ = first.alpha < 0 ? 1 : -1;
  tool_in_tool_ = whole.tool().position + Eigen::Vector3d(0, 0, third.d);
  if (whole.tool().rpy.isZero(0) && third.alpha == 0 && third.beta == 0 && third.a == 0) return;
  // Everything behind the last axis as one frame: it counts as a tool that is turned.
  const Pose T_axis_tool =
      Chain({{.a = third.a, .alpha = third.alpha, .d = third.d, .beta = third.beta}}, {}, whole.tool())
          .forward(Eigen::VectorXd::Zero(1));
  R_tool_last_ = T_axis_tool.linear().transpose();
  tool_in_tool_ = *R_tool_last_ * T_axis_tool.translation();
}

Eigen::Vector3d SphericalWrist::centre(const Pose& T_base_tool) const {
  return T_base_tool.translation() - T_base_tool.linear() * tool_in_tool_;  // Eq. 15
}

std::array<Eigen::Vector3d, 2> SphericalWrist::angles(const ConfigurationRef& q_arm, const Eigen::Matrix3d& R_base_tool,
                                                      const Eigen::Vector3d& near) const {
  const Eigen::Matrix3d R_base_arm = arm_.forward(q_arm).linear();  // Eq. 16
  Eigen::Matrix3d R = R_base_arm.transpose() * R_base_tool;         // Eq. 17: Rz(t5) Ry(t6) Rz(t7)
  if (R_tool_last_) R = (R * *R_tool_last_).eval();
  const auto branch = [&](double t5) -> Eigen::Vector3d {
    const auto [s5, c5] = sin_cos(t5);
    // Rz(-t5) R = Ry(t6) Rz(t7): well conditioned for every t5, also next to the singular case.
    const double t6 = arc_tangent(c5 * R(0, 2) + s5 * R(1, 2), R(2, 2));
    const double t7 = arc_tangent(c5 * R(1, 0) - s5 * R(0, 0), c5 * R(1, 1) - s5 * R(0, 1));
    return Eigen::Vector3d(t5, sense_ * t6, t7) - offsets_;
  };
  const bool singular = R(0, 2) * R(0, 2) + R(1, 2) * R(1, 2) < 1e-24;  // t6 = 0 or pi: only t5 +- t7 is fixed
  const double t5 = singular ? near[0] + offsets_[0] : arc_tangent(R(1, 2), R(0, 2));
  std::array<Eigen::Vector3d, 2> both{branch(t5), branch(t5 + std::numbers::pi)};
  if (!singular && both[0][1] < both[1][1]) std::swap(both[0], both[1]);
  for (Eigen::Vector3d& angles : both)
    for (double& angle : angles) angle = std::remainder(angle, 2 * std::numbers::pi);
  return both;
}

}  // namespace ikbench::robots
