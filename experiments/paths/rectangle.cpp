// A rectangle that returns to its first corner.
#include <stdexcept>

#include "experiments/orientation.hpp"
#include "experiments/path.hpp"
#include "numerics/units.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;

namespace {

class Rectangle final : public PathKind {
 public:
  std::unique_ptr<PathKind> copy() const override { return std::make_unique<Rectangle>(*this); }

  std::string_view name() const override { return "rectangle"; }
  std::string_view summary() const override { return "a rectangle, once around"; }

  void list_fields(Fields& io) override {
    io.numbers("centre_cm", centre_, centimetre, 3, "x, y, z of the centre");
    io.number("width_cm", width_, centimetre, {0, 1e6}, "along the first axis of the plane");
    io.number("height_cm", height_, centimetre, {0, 1e6}, "along the second");
    list_plane(io, plane_);
    io.whole(
        "points", points_, point_counts,
        "point k = 0 ... n - 1 is k/(n - 1) of the way around, from the corner at which both axes begin, along the "
        "first axis first; the last point is the first one. All corners are points where both sides are whole numbers "
        "of steps, as by default of 5 cm");
    list_tool(io, tool_);
  }

  void check(const Robot&) const override {
    if (width_ + height_ > 0) return;
    throw std::invalid_argument("path.width_cm and path.height_cm are both 0; expected one of them above 0");
  }
  bool is_drawn() const override { return false; }
  int points() const override { return points_; }

  std::vector<Pose> poses(const Robot&, Random&) const override {
    return poses_along(points_, tool_, [&](double fraction) -> Eigen::Vector3d {
      double left = fraction * 2 * (width_ + height_), first = 0, second = 0;
      if (left <= width_) {
        first = left;
      } else if ((left -= width_) <= height_) {
        first = width_;
        second = left;
      } else if ((left -= height_) <= width_) {
        first = width_ - left;
        second = height_;
      } else {
        second = fraction == 1 ? 0 : height_ - (left - width_);
      }
      return centre_ + along(plane_, first - width_ / 2, second - height_ / 2);
    });
  }

 private:
  Eigen::Vector3d centre_{0.5, 0, 0.4};
  double width_ = 0.2, height_ = 0.3;
  Plane plane_ = Plane::yz;
  int points_ = 21;
  Tool tool_ = Tool::down;
};

}  // namespace

std::unique_ptr<PathKind> rectangle_path() { return std::make_unique<Rectangle>(); }

}  // namespace ikbench::experiments
