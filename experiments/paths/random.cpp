// Targets drawn anew for every run: Slim et al. 2023, Table 7. All sets except `unreachable` are poses of drawn
// configurations, so the arm can reach them.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "experiments/path.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;

namespace {

enum class Set { anywhere, near_limits, near_singular, edge, unreachable };

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

// A target set's condition: a configuration belongs to it if its score is high enough.
struct Demand {
  std::function<double(const Configuration&)> score;
  double enough;
};

// Ascending scores of 1000 configurations, the same for every study of the arm. A path and its copies share them, since
// singular values take long. Threads may call it at the same time.
class SampledScores {
 public:
  // `name` is the score's name.
  const std::vector<double>& of(const Robot& arm, const std::string& name,
                                const std::function<double(const Configuration&)>& score) {
    std::string key = name + arm.chain.definition();
    for (const double limit : arm.limits.lower) key += fmt::format(" {}", limit);
    for (const double limit : arm.limits.upper) key += fmt::format(" {}", limit);
    const std::scoped_lock lock(mutex_);
    std::vector<double>& scores = known_[key];
    if (!scores.empty()) return scores;
    constexpr int samples = 1000;
    Random random(Key(0).with("samples of an arm"));
    for (int i = 0; i < samples; ++i) scores.push_back(score(drawn_within(range_of(arm), random)));
    std::ranges::sort(scores);
    return scores;
  }

 private:
  std::mutex mutex_;
  std::map<std::string, std::vector<double>> known_;
};

// The smallest singular value, by one-sided Jacobi rotations (Golub and Van Loan, Matrix Computations, 8.6.3): columns
// turn in pairs until all are orthogonal, and then have the singular values as lengths. Eigen's takes as long to
// compile as a fifth of this folder.
double smallest_singular_value(Eigen::MatrixXd matrix) {
  constexpr double orthogonal = 1e-15;
  constexpr int most_sweeps = 30;  // fewer than ten are needed
  if (matrix.cols() > matrix.rows()) matrix.transposeInPlace();
  bool has_turned = true;
  for (int sweep = 0; has_turned && sweep < most_sweeps; ++sweep) {
    has_turned = false;
    for (Eigen::Index j = 1; j < matrix.cols(); ++j) {
      for (Eigen::Index i = 0; i < j; ++i) {
        const double a = matrix.col(i).squaredNorm(), b = matrix.col(j).squaredNorm();
        const double product = matrix.col(i).dot(matrix.col(j));
        if (std::abs(product) <= orthogonal * std::sqrt(a * b)) continue;
        const double cotangent = (b - a) / (2 * product);  // of twice the angle
        const double tangent =
            std::copysign(1 / (std::abs(cotangent) + std::sqrt(1 + cotangent * cotangent)), cotangent);
        const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = cosine * tangent;
        const Eigen::VectorXd before = matrix.col(i);
        matrix.col(i) = cosine * before - sine * matrix.col(j);
        matrix.col(j) = sine * before + cosine * matrix.col(j);
        has_turned = true;
      }
    }
  }
  return matrix.colwise().norm().minCoeff();
}

// Demands a smallest singular value of the Jacobian [m, rad] below its first percentile.
Demand near_singular(const Robot& arm, SampledScores& samples) {
  const auto score = [&arm](const Configuration& q) {
    Eigen::MatrixXd jacobian(6, q.size());
    arm.chain.pose_jacobian(q, jacobian);
    return -smallest_singular_value(std::move(jacobian));
  };
  const std::vector<double>& scores = samples.of(arm, "singular", score);
  return {score, scores[scores.size() * 99 / 100]};
}

// Demands a tool farther from the shoulder than 95 % of the largest distance.
Demand at_edge(const Robot& arm, SampledScores& samples) {
  constexpr double share = 0.95;
  const auto score = [&arm, shoulder = arm.chain.reach().centre](const Configuration& q) {
    return (arm.chain.position(q) - shoulder).norm();
  };
  return {score, share * samples.of(arm, "edge", score).back()};
}

// Draws until a configuration is good enough; after very many draws, returns the best.
Configuration drawn_to_meet(const Demand& demand, const Robot& arm, Random& random) {
  constexpr int most_draws = 20'000;
  Configuration best = drawn_within(range_of(arm), random);
  double score = demand.score(best);
  for (int i = 1; i < most_draws && score < demand.enough; ++i) {
    const Configuration q = drawn_within(range_of(arm), random);
    if (const double other = demand.score(q); other > score) {
      best = q;
      score = other;
    }
  }
  return best;
}

class RandomTargets final : public PathKind {
 public:
  std::unique_ptr<PathKind> copy() const override { return std::make_unique<RandomTargets>(*this); }

  std::string_view name() const override { return "random"; }
  std::string_view summary() const override { return "random poses that the arm can reach, or cannot"; }

  void list_fields(Fields& io) override {
    io.whole("points", points_, point_counts,
             "each is the tool's pose at joint angles drawn uniformly within the limits from seed and run",
             InKey::in_text);
    io.choice(
        "set", set_,
        Choices<Set>{{"anywhere", Set::anywhere},
                     {"near_limits", Set::near_limits},
                     {"near_singular", Set::near_singular},
                     {"edge", Set::edge},
                     {"unreachable", Set::unreachable}},
        "which of them. near_limits: each joint within 5 % of a limit; near_singular: the smallest singular value "
        "below its first percentile; edge: farther from the shoulder than 95 % of the largest distance of 1000 random configurations; unreachable: moved beyond the reach");
    io.number("beyond_percent", beyond_, 0.01, {0.01, 1000},
              "of unreachable ones: how far beyond, as a share of the reach");
  }

  void check(const Robot& arm) const override {
    if (set_ == Set::unreachable && !std::isfinite(arm.chain.reach().radius)) {
      throw std::invalid_argument(
          fmt::format("path.set is \"unreachable\", but the reach of {} is not known, because a joint slides; expected "
                      "another set",
                      arm.name));
    }
    constexpr double least_reach = 1e-6;  // [m] shares of a smaller reach are no distances
    if (set_ == Set::unreachable && arm.chain.reach().radius < least_reach) {
      throw std::invalid_argument(fmt::format(
          "path.set is \"unreachable\", but the reach of {} is 0, and so is every share of it; expected another set",
          arm.name));
    }
    if (set_ == Set::near_limits && !(arm.limits.upper - arm.limits.lower).array().isFinite().any()) {
      throw std::invalid_argument(
          fmt::format("path.set is \"near_limits\", but no joint of {} has limits; expected another set", arm.name));
    }
  }

  bool is_drawn() const override { return true; }
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

  std::vector<Configuration> solutions(const Robot& arm, Random& random) const override {
    return set_ == Set::unreachable ? std::vector<Configuration>() : drawn(arm, random);
  }

 private:
  std::vector<Configuration> drawn(const Robot& arm, Random& random) const {
    const Demand demand = set_ == Set::near_singular ? near_singular(arm, *samples_)
                          : set_ == Set::edge        ? at_edge(arm, *samples_)
                                                     : Demand{};
    std::vector<Configuration> drawn;
    for (int i = 0; i < points_; ++i) {
      if (set_ == Set::near_limits) {
        drawn.push_back(drawn_near_limits(arm, random));
      } else if (demand.score) {
        drawn.push_back(drawn_to_meet(demand, arm, random));
      } else {
        drawn.push_back(drawn_within(range_of(arm), random));
      }
    }
    return drawn;
  }

  int points_ = 20;
  Set set_ = Set::anywhere;
  double beyond_ = 0.1;
  std::shared_ptr<SampledScores> samples_ = std::make_shared<SampledScores>();
};

}  // namespace

std::unique_ptr<PathKind> random_path() { return std::make_unique<RandomTargets>(); }

}  // namespace ikbench::experiments
