// The fields of an arm file, listed once: name, member, unit, range and meaning. The reader of arms (robot.cpp) and the
// writer into the store (experiments/study/writer.cpp) visit this list.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "base/fields.hpp"
#include "base/units.hpp"
#include "robots/robot.hpp"

namespace ikbench::robots {

constexpr std::string_view no_limits = "none";
// Bounds of numbers that people write: 400 m would be millimetres. A table that is made of a URDF file may be longer.
constexpr std::pair<double, double> lengths_m{-100, 100}, stored_lengths_m{-1e6, 1e6}, angles_deg{-3600, 3600};

// A link in a file, with the limits of its joint.
struct LimitedLink {
  DhLink link;
  Eigen::Vector2d limits{-180 * base::degree, 180 * base::degree};  // [rad], or [m]; infinite: continuous joint
  std::pair<double, double> lengths = lengths_m;
  bool has_beta = true;  // false leaves out a beta of 0
};

inline void list_fields(base::Fields& io, LimitedLink& one) {
  DhLink& link = one.link;
  io.choice("joint", link.joint, {"turns", "slides", "coupled"},
            "turns about z, slides along z, or turns only this link about y, as in a parallelogram");
  io.number("offset_deg", link.offset, base::degree, angles_deg, "added to the joint's angle");
  io.number("d_m", link.d, 1, one.lengths, "along z");
  io.number("a_m", link.a, 1, one.lengths, "along x");
  io.number("alpha_deg", link.alpha, base::degree, angles_deg, "about x");
  if (one.has_beta)
    io.number("beta_deg", link.beta, base::degree, angles_deg, "about y, after alpha, if axes are almost parallel");
  if (link.joint == Joint::slides) {
    io.numbers("limits_m", one.limits, 1, 2, "from, to");
  } else if (!one.limits.allFinite()) {
    std::string none(no_limits);
    io.text("limits_deg", none, "a continuous joint, without limits");
  } else {
    io.numbers("limits_deg", one.limits, base::degree, 2, "from, to");
  }
}

inline void list_fields(base::Fields& io, Frame& frame) {
  io.numbers("position_m", frame.position, 1, 3, "x, y, z");
  io.numbers("rpy_deg", frame.rpy, base::degree, 3, "turned by Rz(yaw) Ry(pitch) Rx(roll)");
}

inline void list_fields(base::Fields& io, Robot& arm) {
  io.text("summary", arm.summary, "one line that describes the arm");
  io.text("source", arm.source, "where the numbers are from");
  io.numbers("velocity_deg_s", arm.velocity, 1, 0,
             "largest velocity of each joint per second: degrees, and metres for prismatic joints");
}

}  // namespace ikbench::robots
