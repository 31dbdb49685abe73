#include "robots/closed_form.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "numerics/functions.hpp"
#include "numerics/polynomial.hpp"

namespace ikbench::robots {

using namespace numerics;

namespace {

// Relative to the arm's reach.
constexpr double negligible = 1e-9;  // for a length or a sine
constexpr double rounding = 1e-14;   // a distance that cannot become smaller
constexpr double reached = 1e-11;    // a polished distance that is rounding
constexpr double polishable = 1e-5;  // a distance that rounding may cause where two solutions meet

double turned_into_range(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

// Zeros of form (1, cos, sin); if there is none, the angle nearest to a zero.
Roots zeros(const Eigen::RowVector3d& form) {
  const double size = std::sqrt(form[1] * form[1] + form[2] * form[2]);
  Roots zeros(0);
  if (!(size > 0)) return zeros;
  const double middle = arc_tangent(form[2], form[1]), cosine = std::clamp(-form[0] / size, -1.0, 1.0);
  const double to_side = arc_tangent(std::sqrt(1 - cosine * cosine), cosine);
  zeros.resize(to_side > 0 && to_side < std::numbers::pi ? 2 : 1);
  zeros[0] = middle + to_side;
  if (zeros.size() == 2) zeros[1] = middle - to_side;
  return zeros;
}

// Zeros of (1, cos, sin) S (1, cos, sin)^T, by the tangent of half the angle, measured from where the form is farthest
// from zero.
Roots zeros(const Eigen::Matrix3d& S) {
  // The form as v0 + v[0] cos t + v[1] sin t + v[2] cos 2t + v[3] sin 2t.
  const double v0 = S(0, 0) + 0.5 * (S(1, 1) + S(2, 2));
  double best = 0, opposite = 0;
  Eigen::Vector4d v(2 * S(0, 1), 2 * S(0, 2), 0.5 * (S(1, 1) - S(2, 2)), S(1, 2)), best_v = v;
  constexpr int directions = 8;
  for (int i = 0; i < directions; ++i) {
    const double shift = 2 * std::numbers::pi * i / directions;
    const auto [s1, c1] = sin_cos(shift);
    const auto [s2, c2] = sin_cos(2 * shift);
    const Eigen::Vector4d seen(c1 * v[0] + s1 * v[1], c1 * v[1] - s1 * v[0], c2 * v[2] + s2 * v[3],
                               c2 * v[3] - s2 * v[2]);
    const double value = v0 - seen[0] + seen[2];  // half a turn from the shift
    if (!(std::abs(value) > std::abs(best))) continue;
    best = value;
    opposite = shift;
    best_v = seen;
  }
  if (!(std::abs(best) > 1e-14 * S.cwiseAbs().maxCoeff())) return Roots(0);  // zero everywhere
  Polynomial in_tangent(5);
  in_tangent << v0 + best_v[0] + best_v[2], 2 * best_v[1] + 4 * best_v[3], 2 * v0 - 6 * best_v[2],
      2 * best_v[1] - 4 * best_v[3], best;
  Roots roots = real_roots(in_tangent);
  for (double& root : roots) root = opposite + 2 * arc_tangent(root, 1);
  return roots;
}

}  // namespace

ClosedForm::Pieper::Pieper(const Chain& arm) {
  const auto twist = [](const DhLink& link) {  // exact for quarter turns
    SinCos of = sin_cos(link.alpha);
    for (double* const value : {&of.sine, &of.cosine}) {
      if (std::abs(*value) < 1e-15) *value = 0;
    }
    return of;
  };
  const DhLink &first = arm.links()[0], &second = arm.links()[1], &third = arm.links()[2];
  offsets = {first.offset, second.offset, third.offset};
  a1 = first.a;
  d1 = first.d;
  sine1 = twist(first).sine;
  cosine1 = twist(first).cosine;
  const auto [s2, c2] = twist(second);
  const auto [s3, c3] = twist(third);
  const double tip = arm.tool().position.z();
  const Eigen::Vector3d k(third.a, -s3 * tip, third.d + c3 * tip);
  const Form fx(0, k.x(), -k.y()), fy(0, k.y(), k.x()), fz(k.z(), 0, 0), one(1, 0, 0);
  hx = fx + second.a * one;
  hy = c2 * fy - s2 * fz;
  hz = s2 * fy + c2 * fz + second.d * one;
  hh = (k.squaredNorm() + second.a * second.a - second.d * second.d) * one + 2 * second.a * fx + 2 * second.d * hz;
}

std::string ClosedForm::why_not(const Chain& whole) {
  if (whole.joints() != 6) return fmt::format("has {} joints, not six", whole.joints());
  for (std::size_t j = 0; j < 6; ++j) {
    if (whole.links()[j].joint != Joint::turns) return fmt::format("has a joint that does not turn, number {}", j + 1);
  }
  if (!SphericalWrist::fits(whole)) return "has no spherical wrist";
  // Checks that the first three joints can move the wrist's centre in all directions somewhere.
  const SphericalWrist wrist(whole);
  const double reach = wrist.arm().reach().radius;
  for (const double angle : {0.3, 0.9, 1.7, 2.6}) {
    Eigen::Matrix3d jacobian;
    wrist.arm().position_jacobian(Eigen::Vector3d(0, angle, 2 * angle + 0.1), jacobian);
    if (std::abs(jacobian.determinant()) > negligible * reach * reach * reach) return {};
  }
  return "cannot move its wrist in all directions with its first three joints";
}

ClosedForm::ClosedForm(const Chain& whole)
    : wrist_([&] {
        if (const std::string why = why_not(whole); !why.empty()) {
          throw std::invalid_argument(fmt::format(
              "an arm with a closed form has six joints that turn and a spherical wrist; this arm {}", why));
        }
        return SphericalWrist(whole);
      }()),
      first_(wrist_.arm()),
      T_first_base_(whole.base().pose().inverse()),
      reach_(wrist_.arm().reach().radius) {}

ClosedForm::Arm ClosedForm::arms(const Eigen::Vector3d& centre, const ConfigurationRef& near) const {
  const auto& [a1, d1, cosine1, sine1, hx, hy, hz, hh, offsets] = first_;
  const Eigen::Vector3d p = T_first_base_ * centre;
  const double height = p.z() - d1;
  const Pieper::Form one(1, 0, 0);
  const Pieper::Form X = (p.x() * p.x() + p.y() * p.y() + height * height - a1 * a1) * one - hh;  // 2 a1 gx
  const Pieper::Form Y = height * one - cosine1 * hz;                                             // sin(alpha1) gy
  const bool axes_meet = std::abs(a1) <= negligible * reach_, axes_are_parallel = std::abs(sine1) <= negligible;
  Roots thirds;
  if (axes_meet) {
    thirds = zeros(X);
  } else if (axes_are_parallel) {
    thirds = zeros(Y);
  } else {  // gx^2 + gy^2 = |h|^2 - hz^2
    Eigen::Matrix3d S = sine1 * sine1 * X.transpose() * X + 4 * a1 * a1 * Y.transpose() * Y;
    const double scale = 4 * a1 * a1 * sine1 * sine1;
    S += scale * (hz.transpose() * hz - 0.5 * (one.transpose() * hh + hh.transpose() * one));
    thirds = zeros(S);
  }

  Arm arms(3, 0);
  for (const double t3 : thirds) {
    const SinCos third = sin_cos(t3);
    const Eigen::Vector3d at(1, third.cosine, third.sine);
    const double across = hx.dot(at) * hx.dot(at) + hy.dot(at) * hy.dot(at);
    double gx = X.dot(at) / (2 * a1), gy = Y.dot(at) / sine1;
    double* const of_both_signs = axes_meet ? &gx : axes_are_parallel ? &gy : nullptr;
    if (of_both_signs == &gx) gx = std::sqrt(std::max(0.0, across - gy * gy));
    if (of_both_signs == &gy) gy = std::sqrt(std::max(0.0, across - gx * gx));
    const double nothing = negligible * reach_;
    const int signs = of_both_signs != nullptr && *of_both_signs > nothing ? 2 : 1;
    for (int sign = 0; sign < signs; ++sign) {
      if (sign == 1) *of_both_signs *= -1;
      const double x = a1 + gx, y = cosine1 * gy - sine1 * hz.dot(at);
      Eigen::Vector3d t(near[0] + offsets[0], near[1] + offsets[1], t3);
      if (across > nothing * nothing) t[1] = arc_tangent(gy, gx) - arc_tangent(hy.dot(at), hx.dot(at));
      if (p.x() * p.x() + p.y() * p.y() > nothing * nothing) t[0] = arc_tangent(p.y(), p.x()) - arc_tangent(y, x);
      Eigen::Vector3d q = t - offsets;
      if (!polish(centre, q)) continue;
      arms.conservativeResize(3, arms.cols() + 1);
      arms.rightCols<1>() = q;
    }
  }
  return arms;
}

bool ClosedForm::polish(const Eigen::Vector3d& centre, Eigen::Vector3d& q) const {
  Eigen::Matrix3d jacobian;
  Eigen::Vector3d to_go = centre - wrist_.arm().position_jacobian(q, jacobian);
  for (int i = 0; i < 5 && to_go.norm() > rounding * reach_ && to_go.norm() < polishable * reach_; ++i) {
    const Eigen::Vector3d next = q + jacobian.partialPivLu().solve(to_go);
    if (!next.allFinite()) break;
    const Eigen::Vector3d still_to_go = centre - wrist_.arm().position_jacobian(next, jacobian);
    if (!(still_to_go.norm() < to_go.norm())) break;
    q = next;
    to_go = still_to_go;
  }
  return to_go.norm() <= reached * reach_;
}

ClosedForm::Branches ClosedForm::branches(const Pose& T_base_tool, const ConfigurationRef& near) const {
  Branches branches(6, 0);
  if (!T_base_tool.matrix().allFinite()) return branches;
  const Arm arms = this->arms(wrist_.centre(T_base_tool), near);
  for (const auto& arm : arms.colwise()) {
    for (const Eigen::Vector3d& wrist : wrist_.angles(arm, T_base_tool.linear(), near.tail<3>())) {
      branches.conservativeResize(6, branches.cols() + 1);
      branches.rightCols<1>() << arm.unaryExpr(&turned_into_range), wrist;
    }
  }
  return branches;
}

}  // namespace ikbench::robots
