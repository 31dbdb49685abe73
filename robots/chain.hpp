// A serial chain of revolute joints in standard Denavit-Hartenberg form, and its forward kinematics.
// Metres and radians throughout.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "robots/kernels.hpp"

namespace ikbench {

using Pose = Eigen::Isometry3d;

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
};

class Chain {
 public:
  // `tip` is the tool point in the frame of the last link. std::invalid_argument for more than 64 links.
  explicit Chain(std::vector<DhLink> links, Eigen::Vector3d tip = Eigen::Vector3d::Zero());

  int joints() const { return static_cast<int>(links_.size()); }
  const std::vector<DhLink>& links() const { return links_; }
  const Eigen::Vector3d& tip() const { return tip_; }

  // T_base_tool: the product of the link transforms, Eqs. 18 and 26.
  Pose forward(const ConfigurationRef& q) const;
  // Position of the tool point alone: forward(q).translation().
  Eigen::Vector3d position(const ConfigurationRef& q) const;
  // The position, and d position / d q into `jacobian`, 3 x joints.
  Eigen::Vector3d linearize(const ConfigurationRef& q, Eigen::Ref<Eigen::Matrix3Xd> jacobian) const;
  // Distance of each candidate's tool point to the target, Eq. 1; `errors` has one element a candidate. It is not a
  // finite number where an angle or the target is none, or an angle is 2^51 quarter turns (3.5e15 rad) or more.
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
  // The frames on the way from the base to the tip; `visit` gets each link's before its joint turns.
  template <class Visit>
  Pose follow(const ConfigurationRef& q, Visit&& visit) const;

  std::vector<DhLink> links_;
  std::vector<Twist> twists_;  // of alpha; exact for multiples of a quarter turn
  std::vector<KernelLink> kernel_links_;
  Eigen::Vector3d tip_;
};

}  // namespace ikbench
