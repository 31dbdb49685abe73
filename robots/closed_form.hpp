// Inverse kinematics in closed form for six joints that turn, the last three in a spherical wrist (Pieper 1968). The
// first three place the wrist's centre, whatever their lengths and twists; the wrist turns the tool.
#pragma once

#include <string>

#include "robots/spherical_wrist.hpp"

namespace ikbench::robots {

class ClosedForm {
 public:
  // One configuration per column.
  using Branches = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 8>;

  // Says why an arm has no closed form, as a text after "this arm"; empty if it has one.
  static std::string why_not(const Chain& whole);

  // Throws std::invalid_argument if it has none.
  explicit ClosedForm(const Chain& whole);

  // All configurations that reach the pose, each angle in [-pi, pi]; none if it is out of reach or not finite. A joint
  // whose axis goes through what it has to place is free, and keeps its angle of `near`.
  Branches branches(const Pose& T_base_tool, const ConfigurationRef& near) const;

 private:
  using Arm = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 4>;

  // The first three links. h is the wrist's centre before the second joint turns it, g = Rz(t2) h after; the centre is
  // p = Rz(t1) ((a1, 0, d1) + Rx(alpha1) g). Without t1:
  //   |p - (0, 0, d1)|^2 = a1^2 + 2 a1 gx + |h|^2   and   pz = d1 + sin(alpha1) gy + cos(alpha1) hz.
  struct Pieper {
    // f[0] + f[1] cos(t3) + f[2] sin(t3), t3 the angle of the third joint.
    using Form = Eigen::RowVector3d;

    explicit Pieper(const Chain& arm);

    double a1, d1, cosine1, sine1;
    Form hx, hy, hz, hh;  // hh: |h|^2, which has no squares of sine and cosine
    Eigen::Vector3d offsets;
  };

  Arm arms(const Eigen::Vector3d& centre, const ConfigurationRef& near) const;
  // Removes rounding by Newton's method; false if the arm does not place the centre there.
  bool polish(const Eigen::Vector3d& centre, Eigen::Vector3d& q) const;

  SphericalWrist wrist_;
  Pieper first_;
  Pose T_first_base_;
  double reach_;  // [m]
};

}  // namespace ikbench::robots
