// An arm as a serial chain of links in standard Denavit-Hartenberg form, and where its tool is. Metres and radians
// throughout.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <vector>

#include "robots/kernels.hpp"
#include "robots/rotation.hpp"

namespace ikbench::robots {

using Pose = Eigen::Isometry3d;
using Matrix6Xd = Eigen::Matrix<double, 6, Eigen::Dynamic>;

// Candidates as columns, joint-contiguous: row j holds joint j of every candidate.
using Candidates = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using CandidatesRef = Eigen::Ref<const Candidates, 0, Eigen::OuterStride<>>;
// One configuration, an element a joint; it takes no memory from the heap.
using Configuration = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_joints, 1>;
// A Configuration, another vector, or a column of Candidates without a copy.
using ConfigurationRef = Eigen::Ref<const Eigen::VectorXd, 0, Eigen::InnerStride<>>;

struct DhLink {
  double a = 0;       // [m] along x
  double alpha = 0;   // [rad] about x
  double d = 0;       // [m] along z
  double offset = 0;  // [rad] added to the joint's angle
  Joint joint = Joint::turns;

  bool operator==(const DhLink&) const = default;
};

// A frame in another one: at `position`, turned by Rz(yaw) Ry(pitch) Rx(roll).
struct Frame {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // [m]
  Eigen::Vector3d rpy = Eigen::Vector3d::Zero();       // roll, pitch, yaw [rad]

  Pose pose() const;
  bool operator==(const Frame&) const = default;
};

class Chain {
 public:
  // `base` is the frame of the first joint, `tool` that of the tool in the frame of the last link.
  // std::invalid_argument for more than 64 links.
  Chain(std::vector<DhLink> links, Frame base, Frame tool);
  explicit Chain(std::vector<DhLink> links, const Eigen::Vector3d& tip = Eigen::Vector3d::Zero())
      : Chain(std::move(links), Frame(), Frame{.position = tip}) {}

  const std::vector<DhLink>& links() const { return links_; }
  const Frame& base() const { return base_; }
  const Frame& tool() const { return tool_; }
  bool operator==(const Chain& other) const {
    return links_ == other.links_ && base_ == other.base_ && tool_ == other.tool_;
  }

  int joints() const { return static_cast<int>(links_.size()); }
  // T_base_tool: the product of the link transforms, Eqs. 18 and 26.
  Pose forward(const ConfigurationRef& q) const;
  // Position of the tool point alone: forward(q).translation().
  Eigen::Vector3d position(const ConfigurationRef& q) const { return forward(q).translation(); }
  // The tool's position, and d position / d q into `jacobian`, 3 x joints.
  Eigen::Vector3d position_jacobian(const ConfigurationRef& q, Eigen::Ref<Eigen::Matrix3Xd> jacobian) const;
  // The tool's pose; and how position [m] and orientation [rad] move with the joints, in the axes of the base, into the
  // upper and the lower three rows of `jacobian`, 6 x joints: the geometric Jacobian.
  Pose pose_jacobian(const ConfigurationRef& q, Eigen::Ref<Matrix6Xd> jacobian) const;
  // Distance of each candidate's tool point to the target, Eq. 1; `errors` has one element a candidate. It is not a
  // finite number where a joint or the target is not, or an angle is 2^51 quarter turns (3.5e15 rad) or more.
  void position_errors(const CandidatesRef& q, const Eigen::Vector3d& target, Eigen::Ref<Eigen::VectorXd> errors) const;
  // How far each candidate's tool is from a pose: the root mean square [m] of the distances of three points of the
  // tool, its own and those `rotation_weight` [m] along its x and y axes, from where the pose has them. It is smooth
  // but where it is 0, which is at the pose alone. Where it is not finite: as above.
  void pose_errors(const CandidatesRef& q, const Pose& target, double rotation_weight,
                   Eigen::Ref<Eigen::VectorXd> errors) const;
  // Every reachable tool point lies in this ball, about the shoulder, which is a point of the first joint's axis: the
  // sum of the lengths between points of the axes, which stay where they are on a link whatever the joints do.
  // Infinite where a joint slides.
  struct Ball {
    Eigen::Vector3d centre;
    double radius;
  };
  Ball reach() const;
  // All that decides its positions, each number with all its digits: two arms of one definition are the same arm.
  std::string definition() const;

 private:
  struct Twist {
    double cosine, sine;
  };
  // The frames on the way from the first joint to the tool, whose own turn is left out; `visit` gets each joint's
  // number and frame before it moves, and of a coupled link the way from its joint to its end, in that frame, else
  // null.
  template <class Visit>
  Pose follow(const ConfigurationRef& q, Visit&& visit) const;
  // From the pose that `follow` gives to that of the tool in the frame of the base.
  Pose whole(Pose T_first_last) const;
  // `follow`, and how each joint moves the tool's point and about which axis it turns it, in the axes of the base.
  Pose follow_motions(const ConfigurationRef& q, Eigen::Ref<Eigen::Matrix3Xd> motions,
                      Eigen::Ref<Eigen::Matrix3Xd> axes) const;
  void check_sizes(const CandidatesRef& q, const Eigen::Ref<Eigen::VectorXd>& errors) const;
  KernelChain kernel_chain() const;
  // A point, seen from an axis: how far along and beside it.
  struct Seen {
    double along, beside;
  };
  // The tool, or the point on the next axis, seen from a joint's axis.
  Seen after(std::size_t joint, double along_next) const;
  // A point on each axis, from the frame of its joint, so that the sum of the lengths between them is small. Where axes
  // are nearly parallel, the frames of the table are far away.
  std::vector<double> points_on_axes() const;
  enum class Kind { all_turn, any };
  template <Kind kind, class Visit>
  Pose follow_kind(const ConfigurationRef& q, Visit& visit) const;

  std::vector<DhLink> links_;
  Frame base_, tool_;
  Pose T_base_first_, T_first_base_, T_last_tool_;
  bool has_base_, tool_is_turned_;  // else no arithmetic is spent on them, nor a bit changed
  std::vector<Twist> twists_;       // of alpha; exact for multiples of a quarter turn
  std::vector<KernelLink> kernel_links_;
  bool all_turn_ = true;
};

}  // namespace ikbench::robots
