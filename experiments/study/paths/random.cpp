// Targets that are drawn again for every run (Slim et al. 2023, Table 7). All sets except `unreachable` are poses of
// drawn configurations, so the arm can reach them.
#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "experiments/study/path.hpp"

namespace ikbench::experiments {

using namespace robots;

namespace {

// The configurations whose poses are targets, as the field `set` explains.
enum class Set { anywhere, near_limits, near_singular, edge, unreachable, round };

// The generator of the configurations: random numbers of ikbench, or those that NumPy gives for the seed.
enum class Generator { ikbench, numpy };

// Returns the limits within which joints are drawn; finite for a continuous joint, too.
JointLimits range_of(const Robot& arm) { return arm.limits.around(Configuration::Zero(arm.joints())); }

Configuration drawn_within(const JointLimits& range, Random& random) {
  Configuration q = range.lower;
  for (Eigen::Index j = 0; j < q.size(); ++j) q[j] = random.uniform(range.lower[j], range.upper[j]);
  return q;
}

// Draws each joint that has limits within 5 % of its range from one of them.
Configuration drawn_near_limits(const Robot& arm, Random& random) {
  constexpr double margin = 0.05;
  Configuration q = drawn_within(range_of(arm), random);
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    const double lower = arm.limits.lower[j], upper = arm.limits.upper[j], inside = margin * (upper - lower);
    if (!std::isfinite(inside)) continue;
    q[j] = random.uniform() < 0.5 ? random.uniform(lower, lower + inside) : random.uniform(upper - inside, upper);
  }
  return q;
}

// Draws each revolute joint from those of 0, 45, 90 and 180 degrees that are inside the limits, or anywhere within them
// if none is.
Configuration drawn_round(const Robot& arm, Random& random) {
  Configuration q = drawn_within(range_of(arm), random);
  for (Eigen::Index j = 0; j < q.size(); ++j) {
    std::vector<double> inside;
    for (const double angle : {0.0, whole_turn / 8, whole_turn / 4, whole_turn / 2})
      if (angle >= arm.limits.lower[j] && angle <= arm.limits.upper[j]) inside.push_back(angle);
    if (arm.chain.slides(j) || inside.empty()) continue;
    q[j] = inside[static_cast<std::size_t>(random.index(static_cast<int>(inside.size())))];
  }
  return q;
}

// The condition of a target set: a configuration belongs to the set if its score is at least `min_score`. Without a
// score, every configuration belongs to the set.
struct Demand {
  std::function<double(const Configuration&)> score;
  double min_score;
};

// Returns ascending scores of 1000 configurations, the same for every study of the arm.
std::vector<double> sampled(const Robot& arm, const std::function<double(const Configuration&)>& score) {
  constexpr int samples = 1000;
  Random random(Key(0).with("samples of an arm"));
  std::vector<double> scores;
  for (int i = 0; i < samples; ++i) scores.push_back(score(drawn_within(range_of(arm), random)));
  std::ranges::sort(scores);
  return scores;
}

// Demands a manipulability (Yoshikawa, Int. J. Robotics Research 4(2) (1985) 3), here its square, [m, rad], below its
// first percentile.
Demand near_singular(const Robot& arm) {
  const auto score = [&arm](const Configuration& q) {
    Eigen::MatrixXd jacobian(6, q.size());
    arm.chain.pose_jacobian(q, jacobian);
    if (q.size() < 6) jacobian.transposeInPlace();
    return -Eigen::MatrixXd(jacobian.lazyProduct(jacobian.transpose())).determinant();
  };
  const std::vector<double> scores = sampled(arm, score);
  return {score, scores[scores.size() * 99 / 100]};
}

// Demands a tool farther from the shoulder than 95 % of the largest distance.
Demand at_edge(const Robot& arm) {
  constexpr double share = 0.95;
  const auto score = [&arm, shoulder = arm.chain.reach().centre](const Configuration& q) {
    return (arm.chain.position(q) - shoulder).norm();
  };
  return {score, share * sampled(arm, score).back()};
}

// Draws until a configuration meets the demand. After 20 000 draws, returns the one with the highest score.
Configuration drawn_to_meet(const Demand& demand, const Robot& arm, Random& random) {
  constexpr int max_draws = 20'000;
  Configuration best = drawn_within(range_of(arm), random);
  double best_score = demand.score(best);
  for (int i = 1; i < max_draws && best_score < demand.min_score; ++i) {
    const Configuration q = drawn_within(range_of(arm), random);
    if (const double score = demand.score(q); score > best_score) {
      best = q;
      best_score = score;
    }
  }
  return best;
}

Demand demand_of(Set set, const Robot& arm) {
  switch (set) {
    case Set::near_singular:
      return near_singular(arm);
    case Set::edge:
      return at_edge(arm);
    case Set::anywhere:
    case Set::near_limits:
    case Set::unreachable:
    case Set::round:
      break;
  }
  return {};
}

class RandomTargets final : public TargetSet {
 public:
  std::string_view name() const override { return "random"; }
  std::string_view summary() const override { return "random poses that the arm can reach, or cannot"; }

  void list_fields(Fields& io) override {
    io.whole("points", points_, point_count_range,
             {"each is the tool's pose at joint angles drawn uniformly within the limits from seed and run",
              InKey::in_text});
    io.choice(
        "set", set_, {"anywhere", "near_limits", "near_singular", "edge", "unreachable", "round"},
        "which of them. near_limits: each joint within 5 % of a limit; near_singular: Yoshikawa's manipulability "
        "below its first percentile; edge: farther from the shoulder than 95 % of the largest distance of 1000 random configurations; unreachable: moved beyond the reach; round: revolute joints at 0, 45, 90 or 180 deg, where closed forms meet special cases");
    io.choice(
        "generator", generator_, {"ikbench", "numpy"},
        "what draws them. numpy: NumPy's np.random.seed(seed), then np.random.uniform joint by joint, of one with room for more than a turn half a turn each way");
    io.number("beyond_percent", beyond_, 0.01, {0.01, 1000},
              "for unreachable targets: how far beyond the reach, as a share of it");
  }

  void check(const Robot& arm) const override {
    const auto refuse_if = [&](Set set, bool is_wrong, std::string_view why) {
      if (set_ == set && is_wrong)
        throw std::invalid_argument(fmt::format("path.set is {}; expected another set", why));
    };
    if (generator_ == Generator::numpy && set_ != Set::anywhere)
      throw std::invalid_argument(
          "path.generator is \"numpy\", which draws anywhere; expected path.set = \"anywhere\"");
    constexpr double min_reach = 1e-6;  // [m]; shares of a smaller reach are no distances
    const double reach = arm.chain.reach().radius;
    refuse_if(Set::unreachable, !std::isfinite(reach),
              fmt::format("\"unreachable\", but the reach of {} is not known, because a joint is prismatic", arm.name));
    refuse_if(Set::unreachable, reach < min_reach,
              fmt::format("\"unreachable\", but the reach of {} is 0, and so is every share of it", arm.name));
    refuse_if(Set::near_limits, !(arm.limits.upper - arm.limits.lower).array().isFinite().any(),
              fmt::format("\"near_limits\", but no joint of {} has limits", arm.name));
  }

  bool is_random() const override { return true; }
  bool uses_numpy_random() const override { return generator_ == Generator::numpy; }
  int points() const override { return points_; }

  std::vector<Pose> poses(const Robot& arm, Random& random) const override {
    std::vector<Pose> poses;
    for (const Configuration& q : drawn(arm, random)) {
      poses.push_back(arm.chain.forward(q));
      if (set_ != Set::unreachable) continue;
      const Chain::Ball ball = arm.chain.reach();
      Eigen::Vector3d direction = poses.back().translation() - ball.centre;
      direction = direction.norm() > 0 ? Eigen::Vector3d(direction / direction.norm()) : Eigen::Vector3d(1, 0, 0);
      poses.back().translation() = ball.centre + direction * (ball.radius * (1 + beyond_));
    }
    return poses;
  }

  std::vector<Configuration> source_configurations(const Robot& arm, Random& random) const override {
    return set_ == Set::unreachable ? std::vector<Configuration>() : drawn(arm, random);
  }

 private:
  std::vector<Configuration> drawn(const Robot& arm, Random& random) const {
    const Demand demand = demand_of(set_, arm);
    JointLimits range = range_of(arm);
    for (Eigen::Index j = 0; j < range.lower.size() && uses_numpy_random(); ++j) {
      if (arm.chain.slides(j) || range.upper[j] - range.lower[j] <= whole_turn) continue;
      range.lower[j] = std::max(range.lower[j], -whole_turn / 2);
      range.upper[j] = std::min(range.upper[j], whole_turn / 2);
    }
    std::vector<Configuration> drawn;
    for (int i = 0; i < points_; ++i) {
      if (set_ == Set::near_limits)
        drawn.push_back(drawn_near_limits(arm, random));
      else if (set_ == Set::round)
        drawn.push_back(drawn_round(arm, random));
      else if (demand.score)
        drawn.push_back(drawn_to_meet(demand, arm, random));
      else
        drawn.push_back(drawn_within(range, random));
    }
    return drawn;
  }

  int points_ = 20;
  Set set_ = Set::anywhere;
  Generator generator_ = Generator::ikbench;
  double beyond_ = 0.1;
};

}  // namespace

std::unique_ptr<TargetSet> random_path() { return std::make_unique<RandomTargets>(); }

}  // namespace ikbench::experiments
