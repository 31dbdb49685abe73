// Curves: a helix that rises along z (Slim et al. 2023, Sec. 5.2), and a level circle (Sec. 6).
#include <algorithm>
#include <numbers>

#include "base/units.hpp"
#include "experiments/study/path.hpp"
#include "numerics/functions.hpp"
#include "robots/rotation.hpp"

namespace ikbench::experiments {

using namespace base;
using namespace numerics;
using namespace robots;

namespace {

// The direction of a curve.
enum class Phase {
  sin_cos,  // (x, y) = centre + radius (sin t, cos t)
  cos_sin   // (x, y) = centre + radius (cos t, sin t)
};

// The fraction of the path at which point k of n lies, k = 0 ... n - 1.
enum class Spacing {
  k_over_n,         // k / n: a closed curve does not repeat its first point
  k_over_n_minus_1  // k / (n - 1): the last point is the end of the curve
};

class Helix : public TargetSet {
 public:
  std::string_view name() const override { return "helix"; }
  std::string_view summary() const override { return "a helix that rises along z"; }

  void list_fields(Fields& io) override {
    io.number("length_cm", length_, centimetre, {-1e6, 1e6}, "rise along z");
    io.number("turns", turns_, 1, {-1e3, 1e3}, "");
    io.numbers("centre_cm", centre_, centimetre, 3, "x, y, z of the centre of its lowest turn");
    io.number("radius_cm", radius_, centimetre, {0, 1e6}, "");
    io.number("start_deg", start_, degree, {-1e5, 1e5}, "angle t of the first point");
    io.whole("points", points_, point_count_range, "");
    io.choice("phase", phase_, {"sin_cos", "cos_sin"},
              "(x, y) relative to the centre: radius (sin t, cos t) or radius (cos t, sin t)");
    list_common(io);
  }

  int points() const override { return points_; }

  std::vector<Pose> poses(const Robot&, Random&) const override {
    Eigen::Matrix3d held = tool_rotation(tool_);
    if (roll_ != 0) held = held * rotation_from_rpy({0, 0, roll_});
    if (yaw_ != 0) held = rotation_from_rpy({0, 0, yaw_}) * held;
    const int intervals = spacing_ == Spacing::k_over_n ? points_ : std::max(points_ - 1, 1);
    std::vector<Pose> poses;
    for (int k = 0; k < points_; ++k) {
      const double fraction = static_cast<double>(k) / intervals;
      const double t = start_ + 2 * std::numbers::pi * turns_ * fraction;
      const auto [sine, cosine] = sin_cos(t);
      const double first = phase_ == Phase::sin_cos ? sine : cosine;
      const double second = phase_ == Phase::sin_cos ? cosine : sine;
      Pose pose = Pose::Identity();
      pose.linear() = held;
      if (tool_turns_ != 0) pose.linear() = rotation_from_rpy({0, 0, tool_turns_ * fraction}) * held;
      pose.translation() = centre_ + Eigen::Vector3d(radius_ * first, radius_ * second, length_ * fraction);
      poses.push_back(pose);
    }
    return poses;
  }

 protected:
  void list_common(Fields& io) {
    io.choice("spacing", spacing_, {"k_over_n", "k_over_n_minus_1"},
              "point k = 0 ... n - 1 lies at this fraction of the path");
    io.choice("tool", tool_, {"down", "eq27"},
              "how the tool is held: straight down, or as Eq. 27 prints it (horizontal)");
    io.number("tool_roll_deg", roll_, degree, {-360, 360}, "turns it about its own axis");
    io.number("tool_yaw_deg", yaw_, degree, {-360, 360}, "then turns it about the vertical");
  }

  Eigen::Vector3d centre_{0.60, 0.0, 0.10};  // of the bottom circle
  double radius_ = 0.20;
  double length_ = 0.50;
  double turns_ = 2;
  double start_ = 0;  // added to t
  int points_ = 20;
  Phase phase_ = Phase::sin_cos;
  Spacing spacing_ = Spacing::k_over_n;
  ToolOrientation tool_ = ToolOrientation::down;
  double roll_ = 0, yaw_ = 0;  // [rad]
  double tool_turns_ = 0;      // [rad] about the vertical, on the way
};

class Circle final : public Helix {
 public:
  Circle() {
    centre_ = {0.16, 0.16, 0.0};
    radius_ = 0.07;
    length_ = 0;
    turns_ = 1;
    phase_ = Phase::cos_sin;
  }
  std::string_view name() const override { return "circle"; }
  std::string_view summary() const override { return "a horizontal circle"; }

  void list_fields(Fields& io) override {
    io.numbers("centre_cm", centre_, centimetre, 3, "x, y, z of the centre");
    io.number("radius_cm", radius_, centimetre, {0, 1e6}, "");
    io.whole("points", points_, point_count_range,
             "point k = 0 ... n - 1 is the centre + radius (cos t, sin t, 0) with t = 360 deg times its fraction");
    list_common(io);
    io.number("tool_turns_deg", tool_turns_, degree, {-1e5, 1e5},
              "how far the tool turns about the vertical on the way around");
  }
};

}  // namespace

std::unique_ptr<TargetSet> helix_path() { return std::make_unique<Helix>(); }
std::unique_ptr<TargetSet> circle_path() { return std::make_unique<Circle>(); }

}  // namespace ikbench::experiments
