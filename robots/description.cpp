#include "robots/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/number.hpp"
#include "numerics/functions.hpp"
#include "numerics/random.hpp"

namespace ikbench::robots {

using namespace base;
using namespace numerics;

namespace {

using Motion = DescribedJoint::Motion;

constexpr double all_but_parallel = 5e-10;  // [rad]: moves a tool a metre away by less than `allowed`
constexpr double tiny = 1e-12;              // [rad], [m]: rounding of computations, not of printed numbers

double meant_length(double length) { return std::abs(length) < tiny ? 0 : length; }

// The nearest multiple of 15 degrees, if it is within `within`.
double meant_angle(double angle, double within) {
  const double multiple = std::round(angle / (15 * degree)) * 15 * degree;
  return std::abs(angle - multiple) < within ? multiple : angle;
}

// Meant, and one that a file in degrees can say, so that a stored arm is the same to the bit.
double angle_in_files(double angle) { return in_unit(meant_angle(angle, tiny), degree) * degree; }

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

// The first frame: its z is along the first axis, its origin the axis' point nearest the base.
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

// The link from a frame, whose z is its joint's axis, to the next axis along the common normal. The normal points along
// the frame's x if possible.
DhLink link_to(const Axis& next, const Pose& frame) {
  const Eigen::Vector3d x = frame.linear().col(0), y = frame.linear().col(1), z = frame.linear().col(2);
  const Eigen::Vector3d way = next.point - frame.translation(), cross = z.cross(next.direction);
  const double sine = cross.norm(), cosine = dot(z, next.direction);
  DhLink link;
  Eigen::Vector3d normal;
  if (sine < all_but_parallel) {
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
  if (axes.empty() || axes.size() > most_joints)
    throw std::invalid_argument(
        fmt::format("{} joints move between base and tip; expected 1 to {}", axes.size(), most_joints));
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
  Chain chain(links, base, frame_of(frame.inverse() * pose));

  constexpr double allowed = 1e-9;  // [m], [rad]
  const auto farthest = std::ranges::max_element(links, {}, [](const DhLink& link) { return std::abs(link.d); });
  const bool is_bounded = std::max(std::abs(farthest->d), chain.tool().position.norm()) <= longest_m;
  Random random(Key(1).with("conversion"));
  Configuration q(chain.joints());
  for (int trial = 0; trial < 100; ++trial) {
    for (double& joint : q) joint = random.uniform(-180 * degree, 180 * degree);
    const double difference = (chain.forward(q).matrix() - pose_of(description, q).matrix()).cwiseAbs().maxCoeff();
    if (is_bounded && difference < allowed) continue;
    throw std::invalid_argument(fmt::format(
        "the axes of joints {} and {} are almost parallel, to {:.2g} deg: too little for a common normal, too much for "
        "none; expected axes that are parallel, or a snap_deg of [urdf] above it",
        farthest - links.begin() + 1, farthest - links.begin() + 2,
        std::abs(farthest->alpha - std::round(farthest->alpha / std::numbers::pi) * std::numbers::pi) / degree));
  }
  return chain;
}

std::vector<std::string> snap(Description& description, double within) {
  std::vector<std::string> changed;
  const auto allowed = [&](double digits) {
    return within > least_snap ? within : std::min(within, std::max(tiny, 0.99 * digits));
  };
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();  // from the last moving joint
  double squares = 0;                               // of the digits of its axis and of the angles since
  const DescribedJoint* last = nullptr;
  for (DescribedJoint& joint : description) {
    for (int i = 0; i < 3; ++i) {
      double& angle = joint.origin.rpy[i];
      const double meant = meant_angle(angle, allowed(joint.rpy_digits[i]));
      if (std::abs(meant - angle) > tiny) changed.push_back(joint.name);
      if (meant != angle) joint.rpy_digits[i] = 0;
      angle = meant;
    }
    R = (R * rotation_from_rpy(joint.origin.rpy)).eval();
    squares += joint.rpy_digits.squaredNorm();
    if (joint.motion == Motion::none) continue;
    const auto set_axis = [&](const Eigen::Vector3d& meant, double digits) {
      const double angle = (meant - joint.axis).norm();
      if (angle >= allowed(digits)) return;
      if (angle > tiny) changed.push_back(joint.name);
      joint.axis = meant;
      joint.axis_digits.setZero();
    };
    Eigen::Index largest = 0;
    joint.axis.cwiseAbs().maxCoeff(&largest);
    set_axis(Eigen::Vector3d::Unit(largest) * (joint.axis[largest] < 0 ? -1 : 1), joint.axis_digits.norm());
    if (last != nullptr) {
      const Eigen::Vector3d before = R.transpose() * last->axis;
      set_axis((dot(before, joint.axis) < 0 ? -before : before).normalized(),
               std::sqrt(squares + joint.axis_digits.squaredNorm()));
    }
    last = &joint;
    R.setIdentity();
    squares = joint.axis_digits.squaredNorm();
  }
  return changed;
}

}  // namespace ikbench::robots
