// The closed form of six joints with a spherical wrist (robots/closed_form.hpp, Pieper 1968). Of all configurations
// that reach the pose within the limits, it picks the nearest to the arm's. It ends with its start.
#include "robots/closed_form.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "solvers/registry.hpp"

namespace ikbench::solvers {

using namespace numerics;
using namespace robots;

namespace {

class NearestBranch final : public Solver {
 public:
  struct Options {
    void list(OptionList&) {}
  };

  explicit NearestBranch(Options) {}

  static std::string why_not(const Chain& arm, GoalKind goal) {
    if (goal == GoalKind::position) return "closed_form solves for a pose; expected search = \"pose\"";
    const std::string why = ClosedForm::why_not(arm);
    if (why.empty()) return {};
    return fmt::format("closed_form needs an arm with six joints that turn and a spherical wrist, but this one {}",
                       why);
  }

  void start(const Problem& problem, Objective& objective, Random&) override {
    if (!arm_ || *arm_ != objective.arm()) {
      const GoalKind kind = objective.goal().is_pose() ? GoalKind::pose : GoalKind::position;
      if (const std::string why = why_not(objective.arm(), kind); !why.empty()) throw std::invalid_argument(why);
      arm_ = objective.arm();
      closed_form_.emplace(*arm_);
    }
    best_ = {problem.start};
    double nearest = std::numeric_limits<double>::infinity();  // [rad]
    const ClosedForm::Branches branches = closed_form_->branches(objective.goal().target, problem.start);
    for (Eigen::Index i = 0; i < branches.cols(); ++i) {
      Configuration q = branches.col(i);
      if (!turned_inside(problem, q)) continue;
      const double error = objective.error(q), distance = (q - problem.start).norm();
      if (!std::isfinite(error) || !(distance < nearest)) continue;
      nearest = distance;
      best_ = {q, error};
    }
    if (!std::isfinite(nearest)) best_.improve(problem.start, objective.error(problem.start));
  }

  void step(Objective&, Random&) override {}
  bool finished() const override { return true; }
  const Best& best() const override { return best_; }

 private:
  // Adds whole turns to come near the start and inside the limits; false if that is impossible.
  static bool turned_inside(const Problem& problem, Configuration& q) {
    constexpr double turn = 2 * std::numbers::pi, rounding = 1e-12;
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const double lower = problem.lower[j], upper = problem.upper[j];
      q[j] += turn * std::round((problem.start[j] - q[j]) / turn);
      if (q[j] > upper + rounding) q[j] -= turn * std::ceil((q[j] - upper - rounding) / turn);
      if (q[j] < lower - rounding) q[j] += turn * std::ceil((lower - rounding - q[j]) / turn);
      if (q[j] > upper + rounding) return false;
      q[j] = std::clamp(q[j], lower, upper);
    }
    return true;
  }

  std::optional<Chain> arm_;  // the arm of the closed form
  std::optional<ClosedForm> closed_form_;
  Best best_;
};

}  // namespace

SolverInfo closed_form() {
  return solver_info<NearestBranch>("closed_form", "the nearest branch of the closed form, of arms that have one",
                                    "Pieper 1968");
}

}  // namespace ikbench::solvers
