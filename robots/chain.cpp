#include "robots/chain.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "numerics/functions.hpp"
#include "numerics/instruction_set.hpp"

namespace ikbench::robots {

using namespace numerics;

IKBENCH_DEFINE_KERNELS

namespace {

// cos(pi/2) is 6e-17 in doubles; a quarter turn is meant to be exact.
double exact_if_tiny(double value) { return std::abs(value) < 1e-15 ? 0.0 : value; }

double length(double x, double y) { return std::sqrt(x * x + y * y); }

KernelLink::Twist kind(double cosine, double sine, double beta) {
  if (beta != 0) return KernelLink::leaning;
  if (cosine == 0) return sine > 0 ? KernelLink::quarter : KernelLink::minus_quarter;
  return cosine == 1 && sine == 0 ? KernelLink::none : KernelLink::general;
}

}  // namespace

Pose Frame::pose() const {
  Pose pose = Pose::Identity();
  pose.linear() = rotation_from_rpy(rpy);
  pose.translation() = position;
  return pose;
}

Chain::Chain(std::vector<DhLink> links, Frame base, Frame tool)
    : links_(std::move(links)),
      base_(std::move(base)),
      tool_(std::move(tool)),
      T_base_first_(base_.pose()),
      T_first_base_(T_base_first_.inverse()),
      T_last_tool_(tool_.pose()),
      has_base_(base_ != Frame()),
      tool_is_turned_(!tool_.rpy.isZero(0)) {
  if (links_.size() > max_joints) {
    throw std::invalid_argument(fmt::format("the arm has {} joints; expected at most {}", links_.size(), max_joints));
  }
  for (const DhLink& link : links_) {
    const SinCos alpha = sin_cos(link.alpha), beta = sin_cos(link.beta);
    const double cosine = exact_if_tiny(alpha.cosine), sine = exact_if_tiny(alpha.sine);
    kernel_links_.push_back({kind(cosine, sine, link.beta), true, link.joint, cosine, sine, link.a, link.d, link.offset,
                             beta.cosine, beta.sine});
    all_turn_ = all_turn_ && link.joint == Joint::turns;
  }
  // Finds coordinates of the point that are 0 for all angles: a joint turns nothing that lies on its axis.
  const Eigen::Vector3d& tip = tool_.position;
  bool x_is_0 = tip.x() == 0, y_is_0 = tip.y() == 0, z_is_0 = tip.z() == 0;
  for (auto link = kernel_links_.rbegin(); link != kernel_links_.rend(); ++link) {
    if (link->twist == KernelLink::leaning) {
      x_is_0 = y_is_0 = z_is_0 = x_is_0 && y_is_0 && z_is_0;
    } else if (link->twist == KernelLink::general) {
      y_is_0 = z_is_0 = y_is_0 && z_is_0;
    } else if (link->twist != KernelLink::none) {
      std::swap(y_is_0, z_is_0);
    }
    if (link->joint == Joint::coupled) {
      x_is_0 = z_is_0 = false;
      continue;
    }
    x_is_0 = x_is_0 && link->a == 0;
    z_is_0 = z_is_0 && link->d == 0 && link->joint == Joint::turns;
    link->turns = !(x_is_0 && y_is_0);
    if (link->turns) x_is_0 = y_is_0 = false;
  }
}

template <class Visit>
Pose Chain::follow(const ConfigurationRef& q, Visit&& visit) const {
  if (q.size() != joints()) {
    throw std::invalid_argument(
        fmt::format("{} angles for an arm with {} joints; expected one for each joint", q.size(), joints()));
  }
  return all_turn_ ? follow_kind<Kind::all_turn>(q, visit) : follow_kind<Kind::any>(q, visit);
}

template <Chain::Kind kind, class Visit>
Pose Chain::follow_kind(const ConfigurationRef& q, Visit& visit) const {
  Configuration angles = q, sines(q.size()), cosines(q.size());
  for (int j = 0; j < joints(); ++j) {
    const DhLink& link = links_[static_cast<std::size_t>(j)];
    if (kind == Kind::any && link.joint == Joint::slides) angles[j] = 0;
    angles[j] += link.offset;
  }
  sines_and_cosines(angles, sines, cosines);

  // Separate vectors, because a compiler keeps them in registers.
  Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), p(0, 0, 0);
  [[maybe_unused]] Eigen::Vector3d run = Eigen::Vector3d::Zero();  // the sum of coupled links in a row
  const auto moved = [&](const Eigen::Vector3d& by) -> Eigen::Vector3d {
    return p + (by.x() * x + by.y() * y + by.z() * z);
  };
  const auto twist = [&](const KernelLink& by, const Eigen::Vector3d untwisted) {
    y = by.cosine * untwisted + by.sine * z;
    z = by.cosine * z - by.sine * untwisted;
    if (by.twist != KernelLink::leaning) return;
    const Eigen::Vector3d upright = x;
    x = by.lean_cosine * upright - by.lean_sine * z;
    z = by.lean_cosine * z + by.lean_sine * upright;
  };
  for (int j = 0; j < joints(); ++j) {
    const DhLink& link = links_[static_cast<std::size_t>(j)];
    const KernelLink& twisted = kernel_links_[static_cast<std::size_t>(j)];
    const double c = cosines[j], s = sines[j];
    if constexpr (kind == Kind::any) {
      if (link.joint == Joint::coupled) {
        const Eigen::Vector3d by(link.a * c + link.d * s, 0, link.d * c - link.a * s);
        visit(j, x, z, p, &by);
        run += by;
        if (twisted.twist == KernelLink::none) continue;
      }
      if (!run.isZero(0)) p = moved(run);
      run.setZero();
      if (link.joint == Joint::coupled) {
        twist(twisted, y);
        continue;
      }
    }
    visit(j, x, z, p, nullptr);
    // The frame times the link's transform, Eqs. 18 and 26; in Eq. 18, element (2,3) is -cos(theta) sin(alpha).
    const Eigen::Vector3d turned = c * y - s * x;
    x = c * x + s * y;
    p += link.d * z + link.a * x;
    if (kind == Kind::any && link.joint == Joint::slides) p += q[j] * z;
    twist(twisted, turned);
  }
  Pose T = Pose::Identity();
  T.linear() << x, y, z;
  T.translation() = moved(kind == Kind::any ? Eigen::Vector3d(run + tool_.position) : tool_.position);
  return T;
}

Pose Chain::forward(const ConfigurationRef& q) const {
  return whole(follow(q, [](auto&&...) {}));
}

Pose Chain::whole(Pose T) const {
  if (tool_is_turned_) T.linear() = (T.linear() * T_last_tool_.linear()).eval();
  if (has_base_) T = T_base_first_ * T;
  return T;
}

Eigen::Vector3d Chain::position_jacobian(const ConfigurationRef& q, Eigen::Ref<Eigen::Matrix3Xd> jacobian) const {
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, max_joints> axes(3, joints());
  const Eigen::Vector3d tool = follow_motions(q, jacobian, axes).translation();
  return has_base_ ? T_base_first_ * tool : tool;
}

Pose Chain::pose_jacobian(const ConfigurationRef& q, Eigen::Ref<Matrix6Xd> jacobian) const {
  return whole(follow_motions(q, jacobian.topRows<3>(), jacobian.bottomRows<3>()));
}

Pose Chain::follow_motions(const ConfigurationRef& q, Eigen::Ref<Eigen::Matrix3Xd> motions,
                           Eigen::Ref<Eigen::Matrix3Xd> axes) const {
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, max_joints> origins(3, joints());
  const auto column = [&](int j, const Eigen::Vector3d& x, const Eigen::Vector3d& z, const Eigen::Vector3d& p,
                          const Eigen::Vector3d* coupled) {
    axes.col(j) = z;
    origins.col(j) = p;
    if (coupled != nullptr) motions.col(j) = coupled->z() * x - coupled->x() * z;
  };
  const Pose T = follow(q, column);
  for (int j = 0; j < joints(); ++j) {
    const Joint joint = links_[static_cast<std::size_t>(j)].joint;
    const Eigen::Vector3d axis = axes.col(j);
    if (joint == Joint::turns) motions.col(j) = axis.cross(T.translation() - origins.col(j));
    if (joint == Joint::slides) motions.col(j) = axis;
    if (joint != Joint::turns) axes.col(j).setZero();
    if (!has_base_) continue;
    motions.col(j) = (T_base_first_.linear() * motions.col(j)).eval();
    axes.col(j) = (T_base_first_.linear() * axes.col(j)).eval();
  }
  return T;
}

void Chain::position_errors(const CandidatesRef& q, const Eigen::Vector3d& target,
                            Eigen::Ref<Eigen::VectorXd> errors) const {
  check_sizes(q, errors);
  const Eigen::Vector3d seen = has_base_ ? T_first_base_ * target : target;
  kernels().position_errors(kernel_chain(), {seen.data()}, {q.data(), q.outerStride(), q.cols()}, errors.data());
}

void Chain::pose_errors(const CandidatesRef& q, const Pose& target, double rotation_weight,
                        Eigen::Ref<Eigen::VectorXd> errors, bool is_of_axis) const {
  check_sizes(q, errors);
  Eigen::Matrix<double, 3, 2> points{{rotation_weight, 0}, {0, rotation_weight}, {0, 0}};
  if (is_of_axis) points << 0, 0, 0, 0, rotation_weight, -rotation_weight;
  const Pose seen = has_base_ ? T_first_base_ * target : target;
  const auto copy = [](const Eigen::Vector3d& from, double* to) { std::copy(from.begin(), from.end(), to); };
  KernelPose goal;
  copy(seen.translation(), goal.target);
  copy(seen.linear() * points.col(0), goal.target_axes.x);
  copy(seen.linear() * points.col(1), goal.target_axes.y);
  const Eigen::Matrix<double, 3, 2> of_tool = tool_is_turned_ ? T_last_tool_.linear() * points : points;
  copy(of_tool.col(0), goal.tool_axes.x);
  copy(of_tool.col(1), goal.tool_axes.y);
  kernels().pose_errors(kernel_chain(), goal, {q.data(), q.outerStride(), q.cols()}, errors.data());
}

void Chain::check_sizes(const CandidatesRef& q, const Eigen::Ref<Eigen::VectorXd>& errors) const {
  if (q.rows() == joints() && errors.size() == q.cols()) return;
  throw std::invalid_argument(fmt::format("{} candidates with {} joints and {} errors for an arm with {} joints",
                                          q.cols(), q.rows(), errors.size(), joints()));
}

KernelChain Chain::kernel_chain() const {
  const Eigen::Vector3d& tip = tool_.position;
  return {kernel_links_.data(), joints(), {tip.x(), tip.y(), tip.z()}, all_turn_};
}

std::vector<double> Chain::points_on_axes(Start start) const {
  std::vector<double> at(links_.size(), 0);
  if (start == Start::frames && links_.front().joint == Joint::turns) at.front() = links_.front().d;
  for (std::size_t j = 1; start == Start::nearest && j < at.size(); ++j) at[j] = before(j, at[j - 1]).along;
  if (all_turn_) shorten(at, 0);
  return at;
}

void Chain::shorten(std::vector<double>& at, double blur) const {
  const auto blurred = [&](double beside) { return blur > 0 ? length(beside, blur) : beside; };
  constexpr int max_sweeps = 200;
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    double moved = 0;
    for (std::size_t j = 0; j < at.size(); ++j) {
      const Seen next = after(j, j + 1 < at.size() ? at[j + 1] : 0);
      double best = next.along;
      if (j > 0) {
        const Seen last = before(j, at[j - 1]);
        const double from_last = blurred(last.beside), from_next = blurred(next.beside), sum = from_last + from_next;
        best = sum > 0 ? (last.along * from_next + next.along * from_last) / sum  // as light is reflected
                       : std::clamp(at[j], std::min(last.along, next.along), std::max(last.along, next.along));
      }
      moved = std::max(moved, std::abs(best - at[j]));
      at[j] = best;
    }
    if (moved < 1e-12) break;
  }
}

Chain::Seen Chain::after(std::size_t joint, double along_next) const {
  const KernelLink& link = kernel_links_[joint];
  Eigen::Vector3d next(0, 0, along_next);
  if (all_turn_ && joint + 1 == links_.size()) next = tool_.position;
  if (link.twist == KernelLink::leaning)
    next = {link.lean_cosine * next.x() + link.lean_sine * next.z(), next.y(),
            link.lean_cosine * next.z() - link.lean_sine * next.x()};
  return {link.d + link.sine * next.y() + link.cosine * next.z(),
          length(link.a + next.x(), link.cosine * next.y() - link.sine * next.z())};
}

Chain::Seen Chain::before(std::size_t joint, double along_last) const {
  const KernelLink& link = kernel_links_[joint - 1];
  const double d = along_last - link.d, along = link.cosine * d;
  if (link.twist != KernelLink::leaning) return {along, length(link.a, link.sine * d)};
  return {link.lean_cosine * along - link.lean_sine * link.a,
          length(link.lean_cosine * link.a + link.lean_sine * along, link.sine * d)};
}

Chain::Ball Chain::ball_through(const std::vector<double>& points) const {
  Ball ball{Eigen::Vector3d::Zero(), all_turn_ ? 0 : tool_.position.norm()};
  for (std::size_t j = 0; j < links_.size(); ++j) {
    if (links_[j].joint == Joint::slides) ball.radius = std::numeric_limits<double>::infinity();
    const Seen next = after(j, j + 1 < links_.size() ? points[j + 1] : 0);
    ball.radius += length(next.along - points[j], next.beside);
  }
  ball.centre.z() = points.front();
  ball.centre = T_base_first_ * ball.centre;
  return ball;
}

Chain::Ball Chain::reach() const {
  const Ball ball = ball_through(points_on_axes(Start::frames));
  if (!all_turn_) return ball;
  const Ball other = ball_through(points_on_axes(Start::nearest));
  return other.radius < 0.995 * ball.radius ? other : ball;  // a small gain is not worth new bits
}

Chain::Ball Chain::smallest_ball() const {
  Ball smallest = reach();
  if (!all_turn_) return smallest;
  std::vector<double> points = points_on_axes(Start::nearest);
  // Where two points meet, no single one can move without a detour. Blurred lengths have no such corners.
  for (const double blur : {0.0, 0.1, 0.03, 0.01, 3e-3, 1e-3, 3e-4, 1e-4}) {  // [m]
    if (blur > 0) shorten(points, blur);
    const Ball ball = ball_through(points);
    if (ball.radius < smallest.radius) smallest = ball;
  }
  return smallest;
}

std::string Chain::definition() const {
  const auto numbers = [](const Eigen::Vector3d& v) { return fmt::format("{} {} {} ", v.x(), v.y(), v.z()); };
  std::string text;
  // Links as in the first stores have their words of then; additions follow where they apply.
  for (const DhLink& link : links_) {
    text += fmt::format("{} {} {} {} ", link.a, link.alpha, link.d, link.offset);
    if (link.joint == Joint::slides) text += "slides ";
    if (link.joint == Joint::coupled) text += "coupled ";
    if (link.beta != 0) text += fmt::format("leans {} ", link.beta);
  }
  text += numbers(tool_.position);
  if (tool_is_turned_) text += "turned " + numbers(tool_.rpy);
  if (has_base_) text += "base " + numbers(base_.position) + numbers(base_.rpy);
  // Older stores know the Dobot Magician by these words.
  constexpr std::string_view dobot = "0 0 0.058 0 0 0 0.135 0 coupled 0.147 0 0 0 coupled 0.061 0 0 ";
  return text == dobot ? " dobot magician 0.135 0.147 0.061 0.058 " : text;
}

}  // namespace ikbench::robots
