#include "experiments/verifier.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/functions.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;
using namespace results;
using solvers::StopRule;

namespace {

using Matrix = Eigen::Matrix4d;

constexpr double rounding = 1e-9;  // [m], [rad]

// Returns the product of two matrices. It adds in the order of the elements; the product of Eigen may add in another.
Matrix product(const Matrix& left, const Matrix& right) {
  Matrix result = Matrix::Zero();
  for (Eigen::Index row = 0; row < 4; ++row) {
    for (Eigen::Index k = 0; k < 4; ++k) {
      for (Eigen::Index column = 0; column < 4; ++column) result(row, column) += left(row, k) * right(k, column);
    }
  }
  return result;
}

// Returns the sine and cosine of numerics/, which have the same bits everywhere. Returns NaN for both if they differ
// from those of the C library.
SinCos witnessed_sin_cos(double angle) {
  const SinCos computed = sin_cos(angle);
  const bool is_same =
      std::abs(computed.sine - std::sin(angle)) <= 1e-15 && std::abs(computed.cosine - std::cos(angle)) <= 1e-15;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return is_same ? computed : SinCos{none, none};
}

enum Axis : Eigen::Index { x_axis, y_axis, z_axis };

Matrix turned_about(Axis axis, double angle) {
  const auto [sine, cosine] = witnessed_sin_cos(angle);
  const Eigen::Index first = (axis + 1) % 3;
  const Eigen::Index second = (axis + 2) % 3;
  Matrix turn = Matrix::Identity();
  turn(first, first) = cosine;
  turn(second, second) = cosine;
  turn(first, second) = -sine;
  turn(second, first) = sine;
  return turn;
}

Matrix moved(double x, double y, double z) { return Matrix{{1, 0, 0, x}, {0, 1, 0, y}, {0, 0, 1, z}, {0, 0, 0, 1}}; }

// Returns the largest element, at least 0. Returns NaN if the vector is not finite, which maxCoeff may pass over.
double largest(const Eigen::VectorXd& values) {
  return values.allFinite() ? std::max(0.0, values.maxCoeff()) : std::numeric_limits<double>::quiet_NaN();
}

// Returns the values of all prismatic joints, or of all revolute ones, with 0 for the others. So radians and metres
// stay apart.
Eigen::VectorXd values_of_type(const Robot& robot, Eigen::VectorXd values, bool is_prismatic) {
  for (Eigen::Index j = 0; j < values.size(); ++j) {
    if (robot.chain.slides(j) != is_prismatic) values[j] = 0;
  }
  return values;
}

// Returns the move from start to answer. A continuous joint goes the shorter way round.
Eigen::VectorXd move_between(const JointLimits& limits, const Eigen::VectorXd& start, const Eigen::VectorXd& answer) {
  Eigen::VectorXd move = answer - start;
  for (Eigen::Index j = 0; j < move.size(); ++j) {
    if (is_endless(limits.lower[j], limits.upper[j])) move[j] = std::remainder(move[j], whole_turn);
  }
  return move;
}

double beyond_rounding(double violation) { return violation <= rounding ? 0 : violation; }

// Returns the angle between two rotations whose difference has the norm sqrt(8) sin(angle / 2).
double angle_of(double difference) {
  const double sine = difference / std::sqrt(8.0);
  return 2 * arc_tangent(sine, std::sqrt(std::max(0.0, 1 - sine * sine)));
}

// Returns the root mean square distance [m] of three points of the tool: its own point, and two points `weight` [m]
// from it. The two lie on the x and y axes, or on both sides of the z axis if the turn about that axis is free.
double pose_error(const Verification& verified, double weight) {
  const auto& difference = verified.pose_difference;
  const Eigen::Vector3d off = difference.col(3);
  const Eigen::Vector3d first = difference.col(verified.is_axis_free ? 2 : 0);
  const Eigen::Vector3d second = verified.is_axis_free ? Eigen::Vector3d(-first) : Eigen::Vector3d(difference.col(1));
  const double squares =
      off.squaredNorm() + (off + weight * first).squaredNorm() + (off + weight * second).squaredNorm();
  return std::sqrt(squares / 3);
}

Matrix pose_of(const Frame& frame) {
  if (frame.position.isZero(0) && frame.rpy.isZero(0)) return Matrix::Identity();
  Matrix pose = moved(frame.position.x(), frame.position.y(), frame.position.z());
  pose = product(product(pose, turned_about(z_axis, frame.rpy.z())), turned_about(y_axis, frame.rpy.y()));
  return product(pose, turned_about(x_axis, frame.rpy.x()));
}

// Returns the motion along or about the axis of a joint, by the elements of Rodrigues' formula.
Matrix motion_of(const DescribedJoint& joint, double value) {
  const double x = joint.axis.x(), y = joint.axis.y(), z = joint.axis.z();
  if (joint.motion == DescribedJoint::Motion::slides) return moved(value * x, value * y, value * z);
  const auto [s, c] = witnessed_sin_cos(value);
  const double v = 1 - c;
  return Matrix{{x * x * v + c, x * y * v - z * s, x * z * v + y * s, 0},
                {y * x * v + z * s, y * y * v + c, y * z * v - x * s, 0},
                {z * x * v - y * s, z * y * v + x * s, z * z * v + c, 0},
                {0, 0, 0, 1}};
}

// Returns the frame behind a link from the frame before the link.
Matrix frame_behind(const DhLink& link, double joint, const Matrix& before) {
  const double angle = link.joint == Joint::slides ? link.offset : joint + link.offset;
  const double along_z = link.joint == Joint::slides ? link.d + joint : link.d;
  const bool is_coupled = link.joint == Joint::coupled;
  Matrix pose = product(before, turned_about(is_coupled ? y_axis : z_axis, angle));
  pose = product(pose, moved(link.a, 0, along_z));
  if (is_coupled) pose = product(pose, turned_about(y_axis, -angle));  // a parallelogram turns back after the link
  pose = product(pose, turned_about(x_axis, link.alpha));
  return link.beta == 0 ? pose : product(pose, turned_about(y_axis, link.beta));
}

}  // namespace

Eigen::Matrix4d reference_pose(const Chain& arm, const Eigen::VectorXd& q) {
  Matrix pose = pose_of(arm.base());
  Eigen::Index joint = 0;
  for (const DhLink& link : arm.links()) pose = frame_behind(link, q[joint++], pose);
  return product(pose, pose_of(arm.tool()));
}

Eigen::Matrix4d reference_pose(const Robot& arm, const Eigen::VectorXd& q) {
  if (arm.description.empty()) return reference_pose(arm.chain, q);
  Matrix pose = Matrix::Identity();
  Eigen::Index moving = 0;
  for (const DescribedJoint& joint : arm.description) {
    pose = product(pose, pose_of(joint.origin));
    if (joint.motion != DescribedJoint::Motion::none) pose = product(pose, motion_of(joint, q[moving++]));
  }
  return pose;
}

Verification verify(const Robot& robot, const Answered& answered) {
  const auto& [target, start, answer, is_axis_free, motion_joints] = answered;
  const Eigen::Matrix4d reached = reference_pose(robot, answer), wanted = target.matrix();
  const Eigen::Matrix3d R = reached.topLeftCorner<3, 3>(), R_wanted = wanted.topLeftCorner<3, 3>();
  // After the free turn only the z axis is off, by 2 sin(angle / 2).
  const double turned_off = is_axis_free ? std::sqrt(2.0) * (R - R_wanted).col(2).norm() : (R - R_wanted).norm();
  const Eigen::VectorXd move = move_between(robot.limits, start, answer);
  const Eigen::VectorXd outside =
      answer.allFinite() ? (robot.limits.lower - answer).cwiseMax(answer - robot.limits.upper).cwiseMax(0) : answer;
  const Eigen::VectorXd turned = values_of_type(robot, move, false), slid = values_of_type(robot, move, true);
  const Eigen::Index counted = motion_joints == 0 ? move.size() : std::min<Eigen::Index>(motion_joints, move.size());
  return {.reached = reached.topRightCorner<3, 1>(),
          .position_error = (reached - wanted).topRightCorner<3, 1>().norm(),
          .is_axis_free = is_axis_free,
          .orientation_error = turned_off / R_wanted.norm(),
          .angle = angle_of(turned_off),
          .pose_difference = (reached - wanted).topRows<3>(),
          .joint_motion = turned.head(counted).norm(),
          .joint_motion_m = slid.norm(),
          .largest_move = largest(turned.cwiseAbs()),
          .limit_violation = beyond_rounding(largest(values_of_type(robot, outside, false))),
          .limit_violation_m = beyond_rounding(largest(values_of_type(robot, outside, true)))};
}

bool exceeds_budget(const ResourceUse& used, const StopRule& budget) {
  const auto exceeds = [](double spent, double given) { return given > 0 && spent > max_budget_ratio * given; };
  return exceeds(used.seconds, budget.seconds) ||
         exceeds(static_cast<double>(used.evaluations), static_cast<double>(budget.evaluations)) ||
         exceeds(static_cast<double>(used.iterations), budget.iterations);
}

Status classify(const Verification& verified, const AcceptanceCriteria& criteria) {
  if (!std::isfinite(verified.position_error) || !std::isfinite(verified.orientation_error)) return Status::not_finite;
  const bool error_holds = std::abs(verified.position_error - criteria.reported_error) <=
                           rounding + criteria.report_tolerance;  // false for NaN
  const bool pose_error_holds =
      criteria.rotation_weight == 0 ||
      std::abs(pose_error(verified, criteria.rotation_weight) - criteria.reported_pose_error) <= rounding;
  const bool is_turned_wrong = criteria.orientation_is_exact && verified.orientation_error > rounding;
  if (!error_holds || !pose_error_holds || is_turned_wrong) return Status::misreported;
  if (verified.limit_violation > 0 || verified.limit_violation_m > 0)
    return criteria.limits_are_enforced ? Status::refused : Status::limit_violated;
  const bool is_met = criteria.stop.is_met(verified.position_error, verified.angle, rounding);
  return is_met ? Status::ok : Status::tolerance_missed;
}

}  // namespace ikbench::experiments
