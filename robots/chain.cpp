#include "robots/chain.hpp"

#include <cmath>

namespace ikbench {

namespace {

// cos(pi/2) is 6e-17 in doubles; a quarter turn is meant to be exact.
double exact_if_tiny(double value) { return std::abs(value) < 1e-15 ? 0.0 : value; }

}  // namespace

Chain::Chain(std::vector<DhLink> links, Eigen::Vector3d tip) : links_(std::move(links)), tip_(std::move(tip)) {
  for (const DhLink& link : links_) {
    twists_.push_back({exact_if_tiny(std::cos(link.alpha)), exact_if_tiny(std::sin(link.alpha))});
  }
}

Pose Chain::link_transform(int joint, double angle) const {
  const DhLink& link = links_[static_cast<std::size_t>(joint)];
  const auto [ca, sa] = twists_[static_cast<std::size_t>(joint)];
  const double c = std::cos(angle + link.offset);
  const double s = std::sin(angle + link.offset);
  Pose T;
  T.matrix() << c, -s * ca, s * sa, link.a * c,  // Eq. 18; element (2,3) is -cos(theta) sin(alpha)
      s, c * ca, -c * sa, link.a * s,            //
      0, sa, ca, link.d,                         //
      0, 0, 0, 1;
  return T;
}

Pose Chain::forward(const ConfigurationRef& q) const {
  Pose T_base_tool = Pose::Identity();
  for (int j = 0; j < joints(); ++j) T_base_tool = T_base_tool * link_transform(j, q[j]);  // Eq. 26
  return T_base_tool * Eigen::Translation3d(tip_);
}

Eigen::Vector3d Chain::position(const ConfigurationRef& q) const {
  // One point, carried from the tip to the base: a plane rotation a joint instead of a matrix product.
  double x = tip_.x(), y = tip_.y(), z = tip_.z();
  for (int j = joints() - 1; j >= 0; --j) {
    const DhLink& link = links_[static_cast<std::size_t>(j)];
    const auto [ca, sa] = twists_[static_cast<std::size_t>(j)];
    const double y_twisted = ca * y - sa * z;
    z = sa * y + ca * z + link.d;
    x += link.a;
    const double c = std::cos(q[j] + link.offset);
    const double s = std::sin(q[j] + link.offset);
    y = s * x + c * y_twisted;
    x = c * x - s * y_twisted;
  }
  return {x, y, z};
}

void Chain::position_jacobian(const ConfigurationRef& q, Eigen::Ref<Eigen::Matrix3Xd> jacobian) const {
  const Eigen::Vector3d tool = position(q);
  Pose T_base_link = Pose::Identity();
  for (int j = 0; j < joints(); ++j) {
    const Eigen::Vector3d axis = T_base_link.linear().col(2);
    jacobian.col(j) = axis.cross(tool - T_base_link.translation());
    T_base_link = T_base_link * link_transform(j, q[j]);
  }
}

void Chain::position_errors(const CandidatesRef& q, const Eigen::Vector3d& target,
                            Eigen::Ref<Eigen::VectorXd> errors) const {
  for (Eigen::Index i = 0; i < q.cols(); ++i) {
    errors[i] = (position(q.col(i)) - target).norm();  // Eq. 1
  }
}

Chain::Ball Chain::reach() const {
  Ball ball{Eigen::Vector3d::Zero(), tip_.norm()};
  for (const DhLink& link : links_) ball.radius += std::hypot(link.a, link.d);
  if (!links_.empty()) {  // the first link's d lies along the base's axis and moves nothing
    const DhLink& first = links_.front();
    ball.centre.z() = first.d;
    ball.radius += std::abs(first.a) - std::hypot(first.a, first.d);
  }
  return ball;
}

}  // namespace ikbench
