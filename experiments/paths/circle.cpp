// A level circle: Slim et al. 2023, Sec. 6. The tool may turn on the way, about the vertical.
#include <numbers>

#include "experiments/orientation.hpp"
#include "experiments/path.hpp"
#include "numerics/functions.hpp"
#include "numerics/units.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;

namespace {

class Circle final : public PathKind {
 public:
  std::unique_ptr<PathKind> copy() const override { return std::make_unique<Circle>(*this); }

  std::string_view name() const override { return "circle"; }
  std::string_view summary() const override { return "a horizontal circle"; }

  void list_fields(Fields& io) override {
    io.numbers("centre_cm", centre_, centimetre, 3, "x, y, z of the centre");
    io.number("radius_cm", radius_, centimetre, {0, 1e6}, "");
    io.whole("points", points_, point_counts,
             "point k = 0 ... n - 1 is the centre + radius (cos t, sin t, 0) with t = 360 deg times its fraction");
    list_spacing(io, spacing_);
    tool_.list_fields(io);
    io.number("tool_turns_deg", tool_turns_, degree, {-1e5, 1e5},
              "how far the tool turns about the vertical on the way around");
  }

  bool is_drawn() const override { return false; }
  int points() const override { return points_; }

  std::vector<Pose> poses(const Robot&, Random&) const override {
    std::vector<Pose> poses;
    for (int k = 0; k < points_; ++k) {
      const double fraction = fraction_at(k, points_, spacing_);
      const auto [sine, cosine] = sin_cos(2 * std::numbers::pi * fraction);
      Pose pose = Pose::Identity();
      pose.linear() = tool_.rotation();
      if (tool_turns_ != 0) {
        pose.linear() = rotation_from_rpy({0, 0, tool_turns_ * fraction}) * tool_.rotation();
      }
      pose.translation() = centre_ + Eigen::Vector3d(radius_ * cosine, radius_ * sine, 0);
      poses.push_back(pose);
    }
    return poses;
  }

 private:
  Eigen::Vector3d centre_{0.16, 0.16, 0.0};
  double radius_ = 0.07;
  int points_ = 20;
  Spacing spacing_ = Spacing::k_over_n;
  HeldTool tool_;
  double tool_turns_ = 0;
};

}  // namespace

std::unique_ptr<PathKind> circle_path() { return std::make_unique<Circle>(); }

}  // namespace ikbench::experiments
