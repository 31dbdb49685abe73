// Targets as a NumPy program draws them: Haviland and Corke 2023.
#include "experiments/path.hpp"
#include "numerics/numpy_random.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;

namespace {

class NumpyTargets final : public PathKind {
 public:
  std::unique_ptr<PathKind> copy() const override { return std::make_unique<NumpyTargets>(*this); }

  std::string_view name() const override { return "numpy"; }
  std::string_view summary() const override {
    return "poses at joint angles drawn by NumPy's legacy generator, the same in every run";
  }

  void list_fields(Fields& io) override {
    io.whole("points", points_, point_counts,
             "each is the tool's pose at joint angles drawn uniformly within the limits, joint after joint",
             InKey::in_text);
    io.whole("numpy_seed", seed_, {0, 4'294'967'295}, "as in numpy.random.seed");
    io.whole("skipped", skipped_, {0, 100'000'000}, "how many numbers were drawn before");
  }

  bool is_drawn() const override { return false; }
  int points() const override { return points_; }

  std::vector<Pose> poses(const Robot& arm, Random& random) const override {
    std::vector<Pose> poses;
    for (const Configuration& q : solutions(arm, random)) poses.push_back(arm.chain.forward(q));
    return poses;
  }

  std::vector<Configuration> solutions(const Robot& arm, Random&) const override {
    const JointLimits range = arm.limits.around(Configuration::Zero(arm.joints()));
    NumpyRandom random(static_cast<std::uint32_t>(seed_), static_cast<std::uint64_t>(skipped_));
    std::vector<Configuration> drawn;
    for (int i = 0; i < points_; ++i) {
      Configuration& q = drawn.emplace_back(range.lower);
      for (Eigen::Index j = 0; j < q.size(); ++j) q[j] = random.uniform(range.lower[j], range.upper[j]);
    }
    return drawn;
  }

 private:
  int points_ = 20;
  std::int64_t seed_ = 0, skipped_ = 0;
};

}  // namespace

std::unique_ptr<PathKind> numpy_path() { return std::make_unique<NumpyTargets>(); }

}  // namespace ikbench::experiments
