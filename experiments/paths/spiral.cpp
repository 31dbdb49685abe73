// An Archimedean spiral: its turns are equally far apart.
#include <numbers>

#include "experiments/orientation.hpp"
#include "experiments/path.hpp"
#include "numerics/functions.hpp"
#include "numerics/units.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;

namespace {

class Spiral final : public PathKind {
 public:
  std::unique_ptr<PathKind> copy() const override { return std::make_unique<Spiral>(*this); }

  std::string_view name() const override { return "spiral"; }
  std::string_view summary() const override { return "a spiral, flat or rising"; }

  void list_fields(Fields& io) override {
    io.numbers("centre_cm", centre_, centimetre, 3, "x, y, z of the centre");
    io.number("from_radius_cm", from_, centimetre, {0, 1e6}, "at the first point");
    io.number("to_radius_cm", to_, centimetre, {0, 1e6}, "at the last point");
    io.number("turns", turns_, 1, {-1e3, 1e3}, "from the first axis of the plane towards the second");
    io.number("rise_cm", rise_, centimetre, {-1e6, 1e6}, "along the normal of the plane");
    list_plane(io, plane_);
    io.whole("points", points_, point_counts,
             "at point k = 0 ... n - 1 angle, radius and rise are k/(n - 1) of the way");
    list_tool(io, tool_);
  }

  bool is_drawn() const override { return false; }
  int points() const override { return points_; }

  std::vector<Pose> poses(const Robot&, Random&) const override {
    return poses_along(points_, tool_, [&](double fraction) -> Eigen::Vector3d {
      const auto [sine, cosine] = sin_cos(2 * std::numbers::pi * turns_ * fraction);
      const double radius = from_ + (to_ - from_) * fraction;
      return centre_ + along(plane_, radius * cosine, radius * sine) + normal(plane_) * (rise_ * fraction);
    });
  }

 private:
  Eigen::Vector3d centre_{0.5, 0, 0.4};
  double from_ = 0, to_ = 0.15, turns_ = 3, rise_ = 0;
  Plane plane_ = Plane::xy;
  int points_ = 20;
  Tool tool_ = Tool::down;
};

}  // namespace

std::unique_ptr<PathKind> spiral_path() { return std::make_unique<Spiral>(); }

}  // namespace ikbench::experiments
