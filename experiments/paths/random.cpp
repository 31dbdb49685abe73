// Targets drawn anew for every run, of configurations so that the arm can reach them: Slim et al. 2023, Table 7.
#include "experiments/path.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;

namespace {

class RandomTargets final : public PathKind {
 public:
  std::unique_ptr<PathKind> copy() const override { return std::make_unique<RandomTargets>(*this); }

  std::string_view name() const override { return "random"; }
  std::string_view summary() const override { return "random poses that the arm can reach"; }

  void list_fields(Fields& io) override {
    io.whole("points", points_, point_counts,
             "each is the tool's pose at joint angles drawn uniformly within the limits from seed and run");
  }

  bool is_drawn() const override { return true; }
  int points() const override { return points_; }

  std::vector<Pose> poses(const Robot& arm, Random& random) const override {
    std::vector<Pose> poses;
    Configuration q = Configuration::Zero(arm.joints());
    const JointLimits range = arm.limits.around(q);
    for (int i = 0; i < points_; ++i) {
      for (Eigen::Index j = 0; j < q.size(); ++j) q[j] = random.uniform(range.lower[j], range.upper[j]);
      poses.push_back(arm.chain.forward(q));
    }
    return poses;
  }

 private:
  int points_ = 20;
};

}  // namespace

std::unique_ptr<PathKind> random_path() { return std::make_unique<RandomTargets>(); }

}  // namespace ikbench::experiments
