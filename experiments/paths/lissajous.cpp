// A Lissajous figure: two oscillations at right angles.
#include <numbers>

#include "experiments/orientation.hpp"
#include "experiments/path.hpp"
#include "numerics/functions.hpp"
#include "numerics/units.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;

namespace {

class Lissajous final : public PathKind {
 public:
  std::unique_ptr<PathKind> copy() const override { return std::make_unique<Lissajous>(*this); }

  std::string_view name() const override { return "lissajous"; }
  std::string_view summary() const override { return "a Lissajous figure; by default a figure of eight"; }

  void list_fields(Fields& io) override {
    io.numbers("centre_cm", centre_, centimetre, 3, "x, y, z of the centre");
    io.number("width_cm", width_, centimetre, {0, 1e6}, "along the first axis of the plane, from end to end");
    io.number("height_cm", height_, centimetre, {0, 1e6}, "along the second");
    io.whole("first_cycles", first_cycles_, {1, 1000}, "oscillations along the first axis");
    io.whole("second_cycles", second_cycles_, {1, 1000}, "along the second");
    io.number("phase_deg", phase_, degree, {-1e5, 1e5}, "of the first oscillation at the first point");
    list_plane(io, plane_);
    io.whole(
        "points", points_, point_counts,
        "point k = 0 ... n - 1 is centre + (width/2 sine(first_cycles t + phase), height/2 sine(second_cycles t)) with "
        "t = 360 k/(n - 1) deg");
    list_tool(io, tool_);
  }

  bool is_drawn() const override { return false; }
  int points() const override { return points_; }

  std::vector<Pose> poses(const Robot&, Random&) const override {
    return poses_along(points_, tool_, [&](double fraction) -> Eigen::Vector3d {
      const double t = 2 * std::numbers::pi * fraction;
      return centre_ + along(plane_, width_ / 2 * sin_cos(first_cycles_ * t + phase_).sine,
                             height_ / 2 * sin_cos(second_cycles_ * t).sine);
    });
  }

 private:
  Eigen::Vector3d centre_{0.5, 0, 0.4};
  double width_ = 0.3, height_ = 0.2;
  int first_cycles_ = 1, second_cycles_ = 2;
  double phase_ = 0;
  Plane plane_ = Plane::yz;
  int points_ = 20;
  Tool tool_ = Tool::down;
};

}  // namespace

std::unique_ptr<PathKind> lissajous_path() { return std::make_unique<Lissajous>(); }

}  // namespace ikbench::experiments
