// An arm as a serial chain of links in standard Denavit-Hartenberg form, with its tool. Metres and radians throughout.
// Where axes are almost parallel, their common normal is far away; there a link has Hayati's form, with a second turn.
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
// A configuration, with one element per joint. It takes no memory from the heap.
using Configuration = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, max_joints, 1>;
// A reference, without a copy, to a Configuration, another vector, or a column of Candidates.
using ConfigurationRef = Eigen::Ref<const Eigen::VectorXd, 0, Eigen::InnerStride<>>;

// A row of a Denavit-Hartenberg table.
struct DhLink {
  double a = 0;       // [m] along x
  double alpha = 0;   // [rad] about x
  double d = 0;       // [m] along z
  double offset = 0;  // [rad] added to the joint's angle
  Joint joint = Joint::turns;
  double beta = 0;  // [rad] about y, after alpha: Hayati's parameter; 0 in a table of Denavit and Hartenberg

  bool operator==(const DhLink&) const = default;
};

// A frame relative to another: at `position`, turned by Rz(yaw) Ry(pitch) Rx(roll).
struct Frame {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  // [m]
  Eigen::Vector3d rpy = Eigen::Vector3d::Zero();       // roll, pitch, yaw [rad]

  Pose pose() const;
  bool operator==(const Frame&) const = default;
};

// A serial chain with its forward kinematics, its Jacobians and the errors of candidates. Immutable.
class Chain {
 public:
  // Makes a chain of at least one link. `base` is the frame of the first joint, and `tool` the tool's frame relative to
  // the last link. Throws std::invalid_argument for more than 64 links.
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
  bool slides(Eigen::Index joint) const { return links_[static_cast<std::size_t>(joint)].joint == Joint::slides; }
  // Returns T_base_tool, the product of the link transforms, Eqs. 18 and 26.
  Pose forward(const ConfigurationRef& q) const;
  // Returns the tool's position [m].
  Eigen::Vector3d position(const ConfigurationRef& q) const { return forward(q).translation(); }
  // Returns the tool's position and writes d position / d q into `jacobian`, 3 x joints.
  Eigen::Vector3d position_jacobian(const ConfigurationRef& q, Eigen::Ref<Eigen::Matrix3Xd> jacobian) const;
  // Returns the tool's pose and writes the geometric Jacobian, 6 x joints, in the axes of the base: the upper three
  // rows are the motion of the position [m], and the lower three that of the orientation [rad].
  Pose pose_jacobian(const ConfigurationRef& q, Eigen::Ref<Matrix6Xd> jacobian) const;
  // Writes the distance [m] of each candidate's tool point from the target, Eq. 1; `errors` has one element per
  // candidate. An error is not finite if a joint or the target is not, or if an angle is 2^51 quarter turns (3.5e15
  // rad) or more.
  void position_errors(const CandidatesRef& q, const Eigen::Vector3d& target, Eigen::Ref<Eigen::VectorXd> errors) const;
  // Writes the distance of each candidate's tool from a pose: the root mean square [m] of the distances of three points
  // of the tool from their places in the pose. The points are the tool's own and those `rotation_weight` [m] along its
  // x and y axes. If `is_of_axis`, the turn about the tool's z axis does not matter, and the points are the tool's own
  // and those along z, both ways. The distance is smooth except at 0, which only the pose itself has. An error is not
  // finite in the same cases as those of position_errors.
  void pose_errors(const CandidatesRef& q, const Pose& target, double rotation_weight,
                   Eigen::Ref<Eigen::VectorXd> errors, bool is_of_axis = false) const;
  // A ball that contains every reachable tool point.
  struct Ball {
    Eigen::Vector3d centre;  // the shoulder, a point of the first joint's axis
    double radius;           // [m]; infinite: a joint is prismatic
  };
  // Returns a ball whose radius is the sum of the lengths between points of successive axes, which no joint changes.
  Ball reach() const;
  // Returns the smallest such ball, to a millimetre. Takes about a millisecond.
  Ball smallest_ball() const;
  // Returns everything that decides the positions of the arm as text, each number with all its digits. Arms with equal
  // definitions are the same arm.
  std::string definition() const;

 private:
  // Follows the frames from the first joint to the tool, without the tool's own turn. `visit` gets each joint's number
  // and the x, z and place of its frame before the joint moves. For a coupled link it also gets the way from the joint
  // to the end of the link, in that frame; otherwise null.
  template <class Visit>
  Pose follow(const ConfigurationRef& q, Visit&& visit) const;
  // Turns the pose that `follow` gives into the tool's pose in the frame of the base.
  Pose whole(Pose T_first_last) const;
  // Calls `follow` and writes, in the axes of the base, each joint's motion of the tool's point and its axis of
  // turning.
  Pose follow_motions(const ConfigurationRef& q, Eigen::Ref<Eigen::Matrix3Xd> motions,
                      Eigen::Ref<Eigen::Matrix3Xd> axes) const;
  void check_sizes(const CandidatesRef& q, const Eigen::Ref<Eigen::VectorXd>& errors) const;
  KernelChain kernel_chain() const;
  // A point seen from an axis: its distances [m] along the axis and beside the axis.
  struct Seen {
    double along, beside;
  };
  // Returns the point on the next axis (or the tool), seen from a joint's axis.
  Seen after(std::size_t joint, double along_next) const;
  // Returns the point on the axis before, seen from a joint's axis.
  Seen before(std::size_t joint, double along_last) const;
  // The points that `points_on_axes` begins with.
  // frames: the frames of the table, which are far away if axes are nearly parallel.
  // nearest: on each axis the point that is nearest to the one before.
  enum class Start { frames, nearest };
  // Returns a point on each axis, as a distance [m] from its joint's frame, such that the sum of the lengths between
  // the points is small.
  std::vector<double> points_on_axes(Start start) const;
  // Moves the points so that the sum becomes smaller. Each length counts as the hypotenuse of the length across an axis
  // and the blur [m].
  void shorten(std::vector<double>& at, double blur) const;
  Ball ball_through(const std::vector<double>& points) const;
  enum class Kind { all_turn, any };
  template <Kind kind, class Visit>
  Pose follow_kind(const ConfigurationRef& q, Visit& visit) const;

  std::vector<DhLink> links_;
  Frame base_, tool_;
  Pose T_base_first_, T_first_base_, T_last_tool_;
  bool has_base_, tool_is_turned_;        // if false, they cost no arithmetic and change no bit
  std::vector<KernelLink> kernel_links_;  // their twist is exact for multiples of a quarter turn
  bool all_turn_ = true;
};

}  // namespace ikbench::robots
