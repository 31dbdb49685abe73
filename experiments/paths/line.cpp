// A straight line.
#include "experiments/orientation.hpp"
#include "experiments/path.hpp"
#include "numerics/units.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;

namespace {

class StraightLine final : public PathKind {
 public:
  std::unique_ptr<PathKind> copy() const override { return std::make_unique<StraightLine>(*this); }

  std::string_view name() const override { return "line"; }
  std::string_view summary() const override { return "a straight line from one point to another"; }

  void list_fields(Fields& io) override {
    io.numbers("from_cm", from_, centimetre, 3, "the first target");
    io.numbers("to_cm", to_, centimetre, 3, "the last target");
    io.whole("points", points_, point_counts, "point k = 0 ... n - 1 is k/(n - 1) of the way");
    list_tool(io, tool_);
  }

  bool is_drawn() const override { return false; }
  int points() const override { return points_; }

  std::vector<Pose> poses(const Robot&, Random&) const override {
    return poses_along(points_, tool_, [&](double fraction) { return from_ + (to_ - from_) * fraction; });
  }

 private:
  Eigen::Vector3d from_{0.5, -0.2, 0.4};
  Eigen::Vector3d to_{0.5, 0.2, 0.4};
  int points_ = 20;
  Tool tool_ = Tool::down;
};

}  // namespace

std::unique_ptr<PathKind> line_path() { return std::make_unique<StraightLine>(); }

}  // namespace ikbench::experiments
