#include "robots/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/number.hpp"
#include "numerics/functions.hpp"

namespace ikbench::robots {

using namespace base;
using namespace numerics;

namespace {

using Motion = DescribedJoint::Motion;

constexpr double tiny = 1e-14;            // [rad], [m]: rounding of computations, not of printed numbers
constexpr double almost_parallel = 0.05;  // the sine below which two axes have no common normal that is near

double meant_length(double length) { return std::abs(length) < tiny ? 0 : length; }

// Returns the nearest multiple of 15 degrees if the angle differs from it by rounding only; otherwise the angle.
double meant_angle(double angle) {
  const double multiple = std::round(angle / (15 * degree)) * 15 * degree;
  return std::abs(angle - multiple) < tiny ? multiple : angle;
}

// Returns the meant angle as a file in degrees can have it, so that a stored arm is the same bit for bit.
double angle_in_files(double angle) { return in_unit(meant_angle(angle), degree) * degree; }

Eigen::Matrix3d turned_about(const Eigen::Vector3d& axis, double angle) {
  const auto [sine, cosine] = sin_cos(angle);
  const double x = axis.x(), y = axis.y(), z = axis.z();
  const Eigen::Matrix3d cross{{0, -z, y}, {z, 0, -x}, {-y, x, 0}};
  return Eigen::Matrix3d::Identity() + sine * cross + (1 - cosine) * (cross * cross);  // Rodrigues
}

// An axis in space, with all joints at 0.
struct Axis {
  Eigen::Vector3d point, direction;
  Motion motion;
};

// Returns the first frame: z is along the first axis, and the origin is the point of the axis that is nearest the base.
Pose first_frame(const Axis& first) {
  const Eigen::Vector3d z = first.direction;
  const Eigen::Vector3d across = std::abs(z.x()) < 0.9 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitZ();
  Pose frame = Pose::Identity();
  frame.linear().col(0) = (across - dot(z, across) * z).normalized();
  frame.linear().col(1) = z.cross(frame.linear().col(0));
  frame.linear().col(2) = z;
  frame.translation() = first.point - dot(z, first.point) * z;
  return frame;
}

// Returns the link from a frame, whose z is its joint's axis, to an axis that is almost parallel. The common normal of
// the two is far away, at a place that hangs on the last digits. So this link goes straight to the point of the axis,
// and turns about x and then about y.
DhLink leaning_link_to(const Axis& next, const Eigen::Vector3d& way, const Eigen::Matrix3d& axes) {
  const Eigen::Vector3d x = axes.col(0), y = axes.col(1), z = axes.col(2), beside = way - dot(z, way) * z;
  DhLink link{.a = meant_length(beside.norm()), .d = meant_length(dot(way, z))};
  if (link.a > 0) link.offset = angle_in_files(arc_tangent(dot(beside, y), dot(beside, x)));
  const auto [sine, cosine] = sin_cos(link.offset);
  const double along_x = dot(next.direction, cosine * x + sine * y),
               along_y = dot(next.direction, cosine * y - sine * x);
  const double along_z = dot(next.direction, z);
  link.alpha = angle_in_files(arc_tangent(-along_y, along_z));
  link.beta = angle_in_files(arc_tangent(along_x, std::sqrt(along_y * along_y + along_z * along_z)));
  return link;
}

// Returns the link from a frame, whose z is its joint's axis, to the next axis along the common normal. The normal
// points along the frame's x if possible.
DhLink link_to(const Axis& next, const Pose& frame) {
  const Eigen::Vector3d x = frame.linear().col(0), y = frame.linear().col(1), z = frame.linear().col(2);
  const Eigen::Vector3d way = next.point - frame.translation(), cross = z.cross(next.direction);
  const double sine = cross.norm(), cosine = dot(z, next.direction);
  if (sine >= tiny && sine < almost_parallel) return leaning_link_to(next, way, frame.linear());
  DhLink link;
  Eigen::Vector3d normal;
  if (sine < tiny) {
    normal = way - dot(z, way) * z;
    normal = normal.norm() < tiny ? x : normal.normalized();
  } else {
    normal = cross / sine;
    link.d = meant_length(dot(way.cross(next.direction), cross) / (sine * sine));
  }
  if (dot(normal, x) < -tiny) normal = -normal;
  link.a = meant_length(dot(way, normal));
  link.offset = angle_in_files(arc_tangent(dot(normal, y), dot(normal, x)));
  link.alpha = angle_in_files(arc_tangent(dot(cross, normal), cosine));
  return link;
}

}  // namespace

Frame frame_of(const Pose& pose) {
  const Eigen::Matrix3d R = pose.linear();
  const double level = std::sqrt(R(0, 0) * R(0, 0) + R(1, 0) * R(1, 0));  // 0 where x points up or down
  const double yaw = level > tiny ? arc_tangent(R(1, 0), R(0, 0)) : 0;
  const Eigen::Vector3d y(-sin_cos(yaw).sine, sin_cos(yaw).cosine, 0);  // of the frame before it rolls
  const double roll = arc_tangent(dot(R.col(1), R.col(0).cross(y)), dot(R.col(1), y));
  Frame frame{pose.translation(), {roll, arc_tangent(-R(2, 0), level), yaw}};
  frame.position = frame.position.unaryExpr(&meant_length);
  frame.rpy = frame.rpy.unaryExpr(&angle_in_files);
  return frame;
}

std::vector<std::string> joint_names(const Description& description) {
  std::vector<std::string> names;
  for (const DescribedJoint& joint : description)
    if (joint.motion != DescribedJoint::Motion::none) names.push_back(joint.name);
  return names;
}

Pose pose_of(const Description& description, const ConfigurationRef& q) {
  Pose pose = Pose::Identity();
  Eigen::Index moving = 0;
  for (const DescribedJoint& joint : description) {
    pose = pose * joint.origin.pose();
    if (joint.motion == Motion::turns) pose.linear() = (pose.linear() * turned_about(joint.axis, q[moving++])).eval();
    if (joint.motion == Motion::slides) pose.translation() += q[moving++] * (pose.linear() * joint.axis);
  }
  return pose;
}

Chain chain_of(const Description& description) {
  std::vector<Axis> axes;
  Pose pose = Pose::Identity();
  for (const DescribedJoint& joint : description) {
    pose = pose * joint.origin.pose();
    if (joint.motion != Motion::none)
      axes.push_back({pose.translation(), (pose.linear() * joint.axis).normalized(), joint.motion});
  }
  if (axes.empty() || axes.size() > max_joints)
    throw std::invalid_argument(
        fmt::format("{} joints move between base and tip; expected 1 to {}", axes.size(), max_joints));
  const Frame base = frame_of(first_frame(axes.front()));
  Pose frame = base.pose();
  std::vector<DhLink> links;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    // Only the tool follows the last axis.
    DhLink link = i + 1 < axes.size() ? link_to(axes[i + 1], frame) : DhLink{};
    frame = frame * Chain({link}).forward(Eigen::VectorXd::Zero(1));
    if (axes[i].motion == Motion::slides) link.joint = Joint::slides;
    links.push_back(link);
  }
  return Chain(links, base, frame_of(frame.inverse() * pose));
}

}  // namespace ikbench::robots
