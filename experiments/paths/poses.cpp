// Single poses from a study file or a program.
#include "experiments/path.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;

namespace {

class Poses final : public PathKind {
 public:
  explicit Poses(std::vector<Pose> poses) : poses_(std::move(poses)) {}
  std::unique_ptr<PathKind> copy() const override { return std::make_unique<Poses>(*this); }

  std::string_view name() const override { return "poses"; }
  std::string_view summary() const override {
    return "a list of poses: { position_cm = [60, 0, 35], rpy_deg = [180, 0, 180] }";
  }

  void list_fields(Fields& io) override { io.poses("poses", poses_); }

  bool is_drawn() const override { return false; }
  int points() const override { return static_cast<int>(poses_.size()); }
  std::vector<Pose> poses(const Robot&, Random&) const override { return poses_; }

 private:
  std::vector<Pose> poses_;
};

}  // namespace

std::unique_ptr<PathKind> poses_path() { return std::make_unique<Poses>(std::vector<Pose>{}); }

Path path_through(std::vector<Pose> poses) { return Path(std::make_unique<Poses>(std::move(poses))); }

}  // namespace ikbench::experiments
