// A serial chain of revolute joints in standard Denavit-Hartenberg form, and its forward kinematics.
#pragma once

#include <vector>

#include "robots/kinematics.hpp"

namespace ikbench::robots {

struct DhLink {
  double a = 0;       // [m] along x
  double alpha = 0;   // [rad] about x
  double d = 0;       // [m] along z
  double offset = 0;  // [rad] added to the joint's angle
};

class Chain final : public Kinematics {
 public:
  // `tip` is the tool point in the frame of the last link. std::invalid_argument for more than 64 links.
  explicit Chain(std::vector<DhLink> links, Eigen::Vector3d tip = Eigen::Vector3d::Zero());

  const std::vector<DhLink>& links() const { return links_; }
  const Eigen::Vector3d& tip() const { return tip_; }

  int joints() const override { return static_cast<int>(links_.size()); }
  // The product of the link transforms, Eqs. 18 and 26.
  Pose forward(const ConfigurationRef& q) const override;
  Eigen::Vector3d linearize(const ConfigurationRef& q, Eigen::Ref<Eigen::Matrix3Xd> jacobian) const override;
  void position_errors(const CandidatesRef& q, const Eigen::Vector3d& target,
                       Eigen::Ref<Eigen::VectorXd> errors) const override;
  // About the shoulder: the base's axis at the first link's height.
  Ball reach() const override;
  std::string definition() const override;

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

}  // namespace ikbench::robots
