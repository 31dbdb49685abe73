// A grid of poses in a plane through the shoulder, which shows where an arm is solved. What the arm certainly does not
// reach is left out.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "base/units.hpp"
#include "experiments/study/path.hpp"
#include "numerics/functions.hpp"
#include "robots/reach.hpp"

namespace ikbench::experiments {

using namespace base;
using namespace robots;
using results::TargetGrid;

namespace {

// The unit vectors of a plane, in the base's frame.
struct Plane {
  Eigen::Vector3d across, up, normal;
};

Plane plane_across(const Eigen::Vector3d& across, const Eigen::Vector3d& up) { return {across, up, across.cross(up)}; }

// Returns 1, 2 or 5 times a power of ten [m]: the nearest by ratio, or the next that is at least `length`.
double round_step(double length, bool is_upwards) {
  double decade = centimetre;
  while (length < decade) decade /= 10;
  while (length >= 10 * decade) decade *= 10;
  double below = decade;
  for (const double digit : {2.0, 5.0, 10.0}) {
    const double above = digit * decade;
    if (length > above) {
      below = above;
      continue;
    }
    return length > below && (is_upwards || length * length > below * above) ? above : below;
  }
  return below;
}

// Returns a turn [rad] about a unit vector.
Eigen::Matrix3d turn_about(const Eigen::Vector3d& axis, double angle) {
  const auto [sine, cosine] = numerics::sin_cos(angle);
  Eigen::Matrix3d cross;
  cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  return cosine * Eigen::Matrix3d::Identity() + sine * cross + (1 - cosine) * axis * axis.transpose();
}

// Returns the direction of all axes if they are parallel; nullopt if they are not, or if a joint is coupled.
std::optional<Eigen::Vector3d> common_axis(const Chain& arm) {
  constexpr double parallel = 1e-6;  // [rad]
  Matrix6Xd jacobian(6, arm.joints());
  arm.pose_jacobian(Configuration::Zero(arm.joints()), jacobian);
  std::optional<Eigen::Vector3d> common;
  for (Eigen::Index j = 0; j < arm.joints(); ++j) {
    const Joint joint = arm.links()[static_cast<std::size_t>(j)].joint;
    if (joint == Joint::coupled) return std::nullopt;
    const Eigen::Vector3d axis =
        joint == Joint::slides ? jacobian.col(j).head<3>().eval() : jacobian.col(j).tail<3>().eval();
    if (!common) common = axis;
    if (common->cross(axis).norm() > parallel) return std::nullopt;
  }
  return common;
}

// Returns the place of the tool at zero joint angles, with each prismatic joint in the middle of its range.
Eigen::Vector3d place_of_tool(const Robot& arm) {
  Configuration q = Configuration::Zero(arm.chain.joints());
  for (Eigen::Index j = 0; j < q.size(); ++j)
    if (arm.chain.links()[static_cast<std::size_t>(j)].joint == Joint::slides)
      q[j] = (arm.limits.lower[j] + arm.limits.upper[j]) / 2;
  return arm.chain.forward(q).translation();
}

// Returns the plane normal to an axis: one of the base's planes if the axis is an axis of the base.
Plane plane_normal_to(const Eigen::Vector3d& axis) {
  constexpr double nearly = 1 - 1e-12;
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
  if (std::abs(axis.z()) > nearly) return plane_across(x, y);
  if (std::abs(axis.y()) > nearly) return plane_across(x, z);
  if (std::abs(axis.x()) > nearly) return plane_across(y, z);
  const Eigen::Vector3d across = axis.cross(z).normalized();
  const Eigen::Vector3d up = across.cross(axis).normalized();
  return plane_across(across, up);
}

bool has_direction(const Aim& aim) {
  return aim.search == results::Search::pose || aim.search == results::Search::axis;
}

class Grid final : public TargetSet {
 public:
  std::string_view name() const override { return "grid"; }
  std::string_view summary() const override { return "a grid of poses in a plane: where an arm is solved"; }

  void list_fields(Fields& io) override {
    io.choice("plane", plane_, {"auto", "xz", "xy", "yz"},
              "plane of the base through the shoulder. auto: xz, or the plane normal to the axes if all are parallel");
    io.number("step_cm", step_, centimetre, {0, 1e8}, "distance of the poses; 0: the reach / 25, as 1, 2 or 5 cm");
    io.choice(
        "tool", tool_, {"down", "directions"},
        "down: along minus the base's z, or as at zero joint angles if all axes are parallel; directions: eight within the plane");
  }

  void lay_out(const Robot& arm, const Aim& aim) override {
    const std::optional<Eigen::Vector3d> axis = common_axis(arm.chain);
    const Chain::Ball ball = reach_within(arm.chain, arm.limits);
    check_reach(arm, ball.radius, aim);
    const Plane plane = plane_of(axis);
    grid_ = TargetGrid();
    grid_.tool = axis ? TargetGrid::Tool::zero : TargetGrid::Tool::down;
    grid_.step = step_ > 0 ? step_ : round_step(ball.radius / 25, false);
    if (tool_ == Tool::directions) {
      grid_.tool = TargetGrid::Tool::directions;
      grid_.directions = directions;
    }
    grid_.across = {plane.across.begin(), plane.across.end()};
    grid_.up = {plane.up.begin(), plane.up.end()};
    Eigen::Vector3d centre = ball.centre;
    // Only prismatic joints leave the plane that is normal to all axes, in which they keep the tool at half their
    // range.
    if (axis && plane.normal.cross(*axis).norm() < 1e-6) centre += axis->dot(place_of_tool(arm) - centre) * *axis;
    for (const double place : centre) grid_.shoulder.push_back(std::round(place * 1e9) / 1e9 + 0.0);
    grid_.reach = ball.radius;
    check_step(arm.name);
    const Eigen::Matrix3d held = axis ? arm.chain.forward(Configuration::Zero(arm.joints())).linear() : held_in(plane);
    if (axis) check_directions(arm.name, *axis, held.col(2), aim);
    place(plane, held, aim);
    leave_out(arm, aim);
    if (poses_.empty())
      throw std::invalid_argument(fmt::format(
          "path.kind is \"grid\", but {} certainly reaches none of its {} poses; expected another plane, tool or step",
          arm.name, grid_.left_out));
  }

  const TargetGrid* grid() const override { return &grid_; }
  int points() const override { return static_cast<int>(poses_.size()); }
  std::vector<Pose> poses(const Robot&, Random&) const override { return poses_; }

 private:
  enum class PlaneChoice { automatic, xz, xy, yz };
  enum class Tool { down, directions };
  static constexpr int directions = 8;

  Plane plane_of(const std::optional<Eigen::Vector3d>& axis) const {
    switch (plane_) {
      case PlaneChoice::xy:
        return plane_normal_to(Eigen::Vector3d::UnitZ());
      case PlaneChoice::yz:
        return plane_normal_to(Eigen::Vector3d::UnitX());
      case PlaneChoice::automatic:
        if (axis) return plane_normal_to(*axis);
        break;
      case PlaneChoice::xz:
        break;
    }
    return plane_normal_to(Eigen::Vector3d::UnitY());
  }

  // Returns the tool's first attitude: down, or along the plane if its directions are in a plane without the vertical.
  Eigen::Matrix3d held_in(const Plane& plane) const {
    if (tool_ == Tool::down || plane.normal.z() == 0) return tool_rotation(ToolOrientation::down);
    Eigen::Matrix3d along;
    along << plane.up, plane.normal, plane.across;
    return along;
  }

  void check_reach(const Robot& arm, double reach, const Aim& aim) const {
    if (!std::isfinite(reach))
      throw std::invalid_argument(fmt::format(
          "path.kind is \"grid\", but the reach of {} is not known, because a prismatic joint has no limits; "
          "expected another kind",
          arm.name));
    constexpr double min_reach = 1e-6;  // [m]
    if (reach < min_reach)
      throw std::invalid_argument(
          fmt::format("path.kind is \"grid\", but the reach of {} is 0; expected another kind", arm.name));
    if (tool_ == Tool::directions && !has_direction(aim))
      throw std::invalid_argument(
          "path.tool is \"directions\", but only the position is searched; expected search = \"pose\" or \"axis\"");
  }

  // Refuses directions of a tool whose axis no joint turns, because it is parallel to all axes of the arm.
  void check_directions(const std::string& arm, const Eigen::Vector3d& common_axis, const Eigen::Vector3d& tool,
                        const Aim& aim) const {
    constexpr double parallel = 1e-6;  // [rad]
    if (tool_ != Tool::directions || aim.search != results::Search::axis) return;
    if (common_axis.cross(tool).norm() > parallel) return;
    throw std::invalid_argument(
        fmt::format("path.tool is \"directions\", but the tool's axis is parallel to all axes of {}, so that no joint "
                    "turns it; expected tool = \"down\"",
                    arm));
  }

  // Refuses a step that makes too many targets, before one is made, or only one.
  void check_step(const std::string& arm) const {
    if (grid_.step > grid_.reach)
      throw std::invalid_argument(
          fmt::format("path.step_cm is {:g}, and the reach of {} is {:.3g} cm; expected a smaller step, or 0",
                      grid_.step / centimetre, arm, grid_.reach / centimetre));
    const auto count = [&](double step) {
      return std::numbers::pi * (grid_.reach / step + 1) * (grid_.reach / step + 1) * grid_.directions;
    };
    const auto most = static_cast<double>(point_count_range.second);
    if (count(grid_.step) <= most) return;
    double larger = round_step(grid_.step, true);
    while (count(larger) > most) larger = round_step(1.5 * larger, true);
    throw std::invalid_argument(
        fmt::format("path.step_cm is {:g}, which makes about {:.2g} targets; expected at most {}: step_cm = {:g}",
                    grid_.step / centimetre, count(grid_.step), point_count_range.second, larger / centimetre));
  }

  // Makes the targets that may be reached, row by row.
  void place(const Plane& plane, const Eigen::Matrix3d& held, const Aim& aim) {
    const Eigen::Vector3d shoulder = Eigen::Map<const Eigen::Vector3d>(grid_.shoulder.data());
    const double reach = grid_.reach + aim.tolerance, cells = std::floor(reach / grid_.step);
    std::vector<Eigen::Matrix3d> attitudes;
    for (int k = 0; k < grid_.directions; ++k) {
      const double angle = 2 * std::numbers::pi * k / grid_.directions;
      attitudes.emplace_back(k == 0 ? held : turn_about(plane.normal, angle) * held);
    }
    poses_.clear();
    for (double row = -cells; row <= cells; ++row) {
      for (double column = -cells; column <= cells; ++column) {
        if (std::sqrt(row * row + column * column) * grid_.step > reach) continue;
        Pose pose = Pose::Identity();
        pose.translation() = shoulder + column * grid_.step * plane.across + row * grid_.step * plane.up;
        for (const Eigen::Matrix3d& attitude : attitudes) {
          pose.linear() = attitude;
          poses_.push_back(pose);
        }
      }
    }
  }

  // Leaves out the targets that the arm certainly does not reach, not even within the tolerances.
  void leave_out(const Robot& arm, const Aim& aim) {
    const std::optional<LastAxis> last = last_axis_of(arm);
    if (!last || !has_direction(aim)) return;
    const double margin = aim.tolerance + aim.angle_tolerance * last->in_tool.norm();
    const auto is_beyond = [&](const Pose& pose) {
      return (aim.search == results::Search::pose ? last->beyond(pose) : last->beyond_of_axis(pose)) > margin;
    };
    grid_.left_out = static_cast<int>(std::erase_if(poses_, is_beyond));
  }

  PlaneChoice plane_ = PlaneChoice::automatic;
  double step_ = 0;
  Tool tool_ = Tool::down;
  TargetGrid grid_;
  std::vector<Pose> poses_;
};

}  // namespace

std::unique_ptr<TargetSet> grid_path() { return std::make_unique<Grid>(); }

}  // namespace ikbench::experiments
