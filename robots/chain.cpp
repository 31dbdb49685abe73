#include "robots/chain.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "numerics/functions.hpp"
#include "numerics/instruction_set.hpp"

namespace ikbench::robots {

using namespace numerics;

IKBENCH_DEFINE_KERNELS

namespace {

// cos(pi/2) is 6e-17 in doubles; a quarter turn is meant to be exact.
double exact_if_tiny(double value) { return std::abs(value) < 1e-15 ? 0.0 : value; }

KernelLink::Twist kind(double cosine, double sine) {
  if (cosine == 0) return sine > 0 ? KernelLink::quarter : KernelLink::minus_quarter;
  return cosine == 1 && sine == 0 ? KernelLink::none : KernelLink::general;
}

}  // namespace

Chain::Chain(std::vector<DhLink> links, Eigen::Vector3d tip) : links_(std::move(links)), tip_(std::move(tip)) {
  if (links_.size() > most_joints) {
    throw std::invalid_argument(fmt::format("an arm of {} joints; at most {}", links_.size(), most_joints));
  }
  for (const DhLink& link : links_) {
    const SinCos alpha = sin_cos(link.alpha);
    twists_.push_back({exact_if_tiny(alpha.cosine), exact_if_tiny(alpha.sine)});
    const auto [cosine, sine] = twists_.back();
    kernel_links_.push_back({kind(cosine, sine), true, cosine, sine, link.a, link.d, link.offset});
  }
  // Which of the point's coordinates are 0 whatever the angles: on a joint's own axis nothing turns.
  bool x_is_0 = tip_.x() == 0, y_is_0 = tip_.y() == 0, z_is_0 = tip_.z() == 0;
  for (auto link = kernel_links_.rbegin(); link != kernel_links_.rend(); ++link) {
    if (link->twist == KernelLink::general) {
      y_is_0 = z_is_0 = y_is_0 && z_is_0;
    } else if (link->twist != KernelLink::none) {
      std::swap(y_is_0, z_is_0);
    }
    x_is_0 = x_is_0 && link->a == 0;
    z_is_0 = z_is_0 && link->d == 0;
    link->turns = !(x_is_0 && y_is_0);
    if (link->turns) x_is_0 = y_is_0 = false;
  }
}

template <class Visit>
Pose Chain::follow(const ConfigurationRef& q, Visit&& visit) const {
  if (q.size() != joints()) {
    throw std::invalid_argument(fmt::format("{} angles for an arm of {} joints", q.size(), joints()));
  }
  Configuration angles = q, sines(q.size()), cosines(q.size());
  for (int j = 0; j < joints(); ++j) angles[j] += links_[static_cast<std::size_t>(j)].offset;
  sines_and_cosines(angles, sines, cosines);

  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  for (int j = 0; j < joints(); ++j) {
    visit(j, R, p);
    const DhLink& link = links_[static_cast<std::size_t>(j)];
    const auto [ca, sa] = twists_[static_cast<std::size_t>(j)];
    // R, p times the link's transform, Eqs. 18 and 26; in Eq. 18, element (2,3) is -cos(theta) sin(alpha).
    const double c = cosines[j], s = sines[j];
    const Eigen::Vector3d x = c * R.col(0) + s * R.col(1);
    const Eigen::Vector3d y = c * R.col(1) - s * R.col(0);
    const Eigen::Vector3d z = R.col(2);
    p += link.d * z + link.a * x;
    R.col(0) = x;
    R.col(1) = ca * y + sa * z;
    R.col(2) = ca * z - sa * y;
  }
  Pose T_base_tool = Pose::Identity();
  T_base_tool.linear() = R;
  T_base_tool.translation() = p + (tip_.x() * R.col(0) + tip_.y() * R.col(1) + tip_.z() * R.col(2));
  return T_base_tool;
}

Pose Chain::forward(const ConfigurationRef& q) const {
  return follow(q, [](int, const Eigen::Matrix3d&, const Eigen::Vector3d&) {});
}

Eigen::Vector3d Chain::linearize(const ConfigurationRef& q, Eigen::Ref<Eigen::Matrix3Xd> jacobian) const {
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, most_joints> origins(3, joints());
  const Pose T_base_tool = follow(q, [&](int j, const Eigen::Matrix3d& R, const Eigen::Vector3d& p) {
    jacobian.col(j) = R.col(2);
    origins.col(j) = p;
  });
  const Eigen::Vector3d tool = T_base_tool.translation();
  for (int j = 0; j < joints(); ++j) {
    const Eigen::Vector3d axis = jacobian.col(j);
    jacobian.col(j) = axis.cross(tool - origins.col(j));
  }
  return tool;
}

void Chain::position_errors(const CandidatesRef& q, const Eigen::Vector3d& target,
                            Eigen::Ref<Eigen::VectorXd> errors) const {
  if (q.rows() != joints() || errors.size() != q.cols()) {
    throw std::invalid_argument(fmt::format("{} candidates of {} joints and {} errors for an arm of {} joints",
                                            q.cols(), q.rows(), errors.size(), joints()));
  }
  const KernelChain chain{kernel_links_.data(), joints(), {tip_.x(), tip_.y(), tip_.z()}};
  kernels().position_errors(chain, target.data(), q.data(), q.outerStride(), q.cols(), errors.data());
}

Kinematics::Ball Chain::reach() const {
  Ball ball{Eigen::Vector3d::Zero(), tip_.norm()};
  for (const DhLink& link : links_) ball.radius += std::sqrt(link.a * link.a + link.d * link.d);
  if (!links_.empty()) {  // the first link's d lies along the base's axis and moves nothing
    const DhLink& first = links_.front();
    ball.centre.z() = first.d;
    ball.radius += std::abs(first.a) - std::sqrt(first.a * first.a + first.d * first.d);
  }
  return ball;
}

std::string Chain::definition() const {
  std::string text;
  for (const DhLink& link : links_) text += fmt::format("{} {} {} {} ", link.a, link.alpha, link.d, link.offset);
  return text + fmt::format("{} {} {} ", tip_.x(), tip_.y(), tip_.z());
}

}  // namespace ikbench::robots
