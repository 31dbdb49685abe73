// Rotation vectors against Rodrigues' formula in long double.
#include "tests/robots/random_configuration.hpp"

using std::numbers::pi;

namespace {

// A rotation about a unit axis.
Eigen::Matrix3d turned(const Eigen::Vector3d& axis, double angle) {
  using Long = Eigen::Matrix<long double, 3, 3>;
  const Eigen::Matrix<long double, 3, 1> unit = axis.cast<long double>().normalized();
  Long cross;
  cross << 0, -unit.z(), unit.y(), unit.z(), 0, -unit.x(), -unit.y(), unit.x(), 0;
  const auto by = static_cast<long double>(angle);
  return (Long::Identity() + std::sin(by) * cross + (1 - std::cos(by)) * (cross * cross)).cast<double>();
}

Eigen::Vector3d random_axis(Dice& dice) {
  Eigen::Vector3d axis;
  do {
    for (double& x : axis) x = dice.between(-1, 1);
  } while (axis.norm() < 0.1);
  return axis.normalized();
}

}  // namespace

TEST_CASE("a rotation vector is the axis times the angle, from next to nothing to next to half a turn", "[rotation]") {
  Dice dice;
  for (int trial = 0; trial < 20'000; ++trial) {
    const double near = std::pow(10, dice.between(-17, 0));
    const double angle = trial % 3 == 0 ? near : trial % 3 == 1 ? pi - near : dice.between(0, pi);
    Eigen::Vector3d axis = random_axis(dice);
    if (trial % 7 == 0) axis = Eigen::Vector3d::Unit(dice.below(3)) * (trial % 2 == 0 ? 1 : -1);
    CAPTURE(angle, axis);
    const Eigen::Vector3d found = rotation_vector(turned(axis, angle));
    // For half a turn, either of the two is right.
    const double off = std::min((found - angle * axis).norm(), (found + (2 * pi - angle) * axis).norm());
    REQUIRE(off < 3e-15);
    if (angle < 1e-3) REQUIRE(off < 1e-15 * angle + 1e-18);
  }
}

TEST_CASE("no turn has no rotation vector, half a turn one as long as pi, and what is no rotation none that is finite",
          "[rotation]") {
  CHECK(rotation_vector(Eigen::Matrix3d::Identity()) == Eigen::Vector3d(0, 0, 0));
  for (int j = 0; j < 3; ++j) {
    Eigen::Matrix3d half = -Eigen::Matrix3d::Identity();
    half(j, j) = 1;
    CHECK(rotation_vector(half).cwiseAbs() == pi * Eigen::Vector3d::Unit(j));
  }
  CHECK_FALSE(rotation_vector(Eigen::Matrix3d::Constant(not_a_number)).allFinite());
}
