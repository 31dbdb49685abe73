// Straight lines from corner to corner.
#include <fmt/format.h>

#include <stdexcept>

#include "experiments/orientation.hpp"
#include "experiments/path.hpp"
#include "numerics/units.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;

namespace {

class Polyline final : public PathKind {
 public:
  std::unique_ptr<PathKind> copy() const override { return std::make_unique<Polyline>(*this); }

  std::string_view name() const override { return "polyline"; }
  std::string_view summary() const override { return "straight lines from corner to corner"; }

  void list_fields(Fields& io) override {
    io.numbers("corners_cm", corners_, centimetre, 0, "x, y, z of each corner, one after the other");
    io.whole(
        "points", points_, point_counts,
        "point k = 0 ... n - 1 is k/(n - 1) of the length from the first corner, whether or not it meets a corner");
    list_tool(io, tool_);
  }

  bool is_drawn() const override { return false; }
  int points() const override { return points_; }

  void check(const Robot&) const override {
    if (corners_.size() % 3 == 0 && corners_.size() >= 6) return;
    throw std::invalid_argument(
        fmt::format("path.corners_cm has {} numbers; expected x, y, z of two corners or more", corners_.size()));
  }

  std::vector<Pose> poses(const Robot&, Random&) const override {
    const Eigen::Map<const Eigen::Matrix3Xd> corners(corners_.data(), 3, corners_.size() / 3);
    double length = 0;
    for (Eigen::Index i = 1; i < corners.cols(); ++i) length += (corners.col(i) - corners.col(i - 1)).norm();
    return poses_along(points_, tool_, [&](double fraction) -> Eigen::Vector3d {
      double left = fraction * length;
      for (Eigen::Index i = 1; i < corners.cols(); ++i) {
        const Eigen::Vector3d side = corners.col(i) - corners.col(i - 1);
        if (left <= side.norm() && left > 0) return corners.col(i - 1) + side * (left / side.norm());
        if (left <= 0) return corners.col(i - 1);
        left -= side.norm();
      }
      return corners.col(corners.cols() - 1);
    });
  }

 private:
  Eigen::VectorXd corners_ = (Eigen::VectorXd(9) << 0.5, -0.2, 0.4, 0.6, 0, 0.4, 0.5, 0.2, 0.4).finished();
  int points_ = 20;
  Tool tool_ = Tool::down;
};

}  // namespace

std::unique_ptr<PathKind> polyline_path() { return std::make_unique<Polyline>(); }

}  // namespace ikbench::experiments
