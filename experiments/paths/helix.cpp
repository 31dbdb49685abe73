// A helix that rises along z: Slim et al. 2023, Sec. 5.2.
#include <numbers>

#include "experiments/orientation.hpp"
#include "experiments/path.hpp"
#include "numerics/functions.hpp"
#include "numerics/units.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;

namespace {

// sin_cos: (x, y) = centre + radius (sin t, cos t); cos_sin: centre + radius (cos t, sin t).
enum class Phase { sin_cos, cos_sin };

class Helix final : public PathKind {
 public:
  std::unique_ptr<PathKind> copy() const override { return std::make_unique<Helix>(*this); }

  std::string_view name() const override { return "helix"; }
  std::string_view summary() const override { return "a helix that rises along z"; }

  void list_fields(Fields& io) override {
    io.number("length_cm", length_, centimetre, {-1e6, 1e6}, "rise along z");
    io.number("turns", turns_, 1, {-1e3, 1e3}, "");
    io.numbers("centre_cm", centre_, centimetre, 3, "x, y, z of the centre of its lowest turn");
    io.number("radius_cm", radius_, centimetre, {0, 1e6}, "");
    io.number("start_deg", start_, degree, {-1e5, 1e5}, "angle t of the first point");
    io.whole("points", points_, point_counts, "");
    io.choice("phase", phase_, {"sin_cos", "cos_sin"},
              "(x, y) relative to the centre: radius (sin t, cos t) or radius (cos t, sin t)");
    list_spacing(io, spacing_);
    tool_.list_fields(io);
  }

  bool is_drawn() const override { return false; }
  int points() const override { return points_; }

  std::vector<Pose> poses(const Robot&, Random&) const override {
    std::vector<Pose> poses;
    for (int k = 0; k < points_; ++k) {
      const double fraction = fraction_at(k, points_, spacing_);
      const double t = start_ + 2 * std::numbers::pi * turns_ * fraction;
      const auto [sine, cosine] = sin_cos(t);
      const double first = phase_ == Phase::sin_cos ? sine : cosine;
      const double second = phase_ == Phase::sin_cos ? cosine : sine;
      Pose pose = Pose::Identity();
      pose.linear() = tool_.rotation();
      pose.translation() = centre_ + Eigen::Vector3d(radius_ * first, radius_ * second, length_ * fraction);
      poses.push_back(pose);
    }
    return poses;
  }

 private:
  Eigen::Vector3d centre_{0.60, 0.0, 0.10};  // of the bottom circle
  double radius_ = 0.20;
  double length_ = 0.50;
  double turns_ = 2;
  double start_ = 0;  // added to t
  int points_ = 20;
  Phase phase_ = Phase::sin_cos;
  Spacing spacing_ = Spacing::k_over_n;
  HeldTool tool_;
};

}  // namespace

std::unique_ptr<PathKind> helix_path() { return std::make_unique<Helix>(); }

}  // namespace ikbench::experiments
