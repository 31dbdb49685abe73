// A straight stroke: the example of docs/adding-anything.md.
#include <algorithm>

#include "experiments/orientation.hpp"
#include "experiments/path.hpp"
#include "numerics/units.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;

namespace {

class Stroke final : public PathKind {
 public:
  std::unique_ptr<PathKind> copy() const override { return std::make_unique<Stroke>(*this); }

  std::string_view name() const override { return "stroke"; }
  std::string_view summary() const override { return "a straight stroke from one point to another"; }

  // Each field once: key with its unit, member, range, meaning. The defaults are the initialisers.
  void list_fields(Fields& io) override {
    io.numbers("from_cm", from_, centimetre, 3, "the first target");
    io.numbers("to_cm", to_, centimetre, 3, "the last target");
    io.whole("points", points_, point_counts, "");
    list_tool(io, tool_);
  }

  bool is_drawn() const override { return false; }
  int points() const override { return points_; }

  std::vector<Pose> poses(const Robot&, Random&) const override {
    std::vector<Pose> poses;
    for (int k = 0; k < points_; ++k) {
      Pose pose = Pose::Identity();
      pose.linear() = rotation(tool_);
      pose.translation() = from_ + (to_ - from_) * k / std::max(points_ - 1, 1);
      poses.push_back(pose);
    }
    return poses;
  }

 private:
  Eigen::Vector3d from_{0.5, -0.3, 0.4};
  Eigen::Vector3d to_{0.5, 0.3, 0.4};
  int points_ = 20;
  Tool tool_ = Tool::down;
};

}  // namespace

std::unique_ptr<PathKind> stroke_path() { return std::make_unique<Stroke>(); }

}  // namespace ikbench::experiments
