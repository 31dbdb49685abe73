// A serial chain of revolute joints in standard Denavit-Hartenberg form, and its forward kinematics.
// Metres and radians throughout.
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace ikbench {

using Pose = Eigen::Isometry3d;

// Candidates as columns, joint-contiguous: row j holds joint j of every candidate.
using Candidates = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using CandidatesRef = Eigen::Ref<const Candidates, 0, Eigen::OuterStride<>>;
// One configuration: a vector, or a column of Candidates without a copy.
using ConfigurationRef = Eigen::Ref<const Eigen::VectorXd, 0, Eigen::InnerStride<>>;

struct DhLink {
  double a = 0;       // [m] along x
  double alpha = 0;   // [rad] about x
  double d = 0;       // [m] along z
  double offset = 0;  // [rad] added to the joint's angle
};

class Chain {
 public:
  // `tip` is the tool point in the frame of the last link.
  explicit Chain(std::vector<DhLink> links, Eigen::Vector3d tip = Eigen::Vector3d::Zero());

  int joints() const { return static_cast<int>(links_.size()); }
  const std::vector<DhLink>& links() const { return links_; }
  const Eigen::Vector3d& tip() const { return tip_; }

  // T_base_tool: the product of the link transforms, Eqs. 18 and 26.
  Pose forward(const ConfigurationRef& q) const;
  // Position of the tool point alone; the same as forward(q).translation() to rounding.
  Eigen::Vector3d position(const ConfigurationRef& q) const;
  // d position / d q into `jacobian`, 3 x joints.
  void position_jacobian(const ConfigurationRef& q, Eigen::Ref<Eigen::Matrix3Xd> jacobian) const;
  // Distance of each candidate's tool point to the target, Eq. 1; `errors` has one element a candidate.
  void position_errors(const CandidatesRef& q, const Eigen::Vector3d& target, Eigen::Ref<Eigen::VectorXd> errors) const;
  // Every reachable tool point lies in this ball, about the shoulder (the base's axis at the first link's height).
  struct Ball {
    Eigen::Vector3d centre;
    double radius;
  };
  Ball reach() const;

 private:
  struct Twist {
    double cosine, sine;
  };
  Pose link_transform(int joint, double angle) const;

  std::vector<DhLink> links_;
  std::vector<Twist> twists_;  // of alpha; exact for multiples of a quarter turn
  Eigen::Vector3d tip_;
};

}  // namespace ikbench
