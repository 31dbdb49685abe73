// Damped least squares, what a roboticist would reach for first: Wampler 1986 and Nakamura and Hanafusa 1986, with the
// damping of Levenberg and Marquardt steered by the gain ratio as in Nielsen 1999 (Madsen, Nielsen and Tingleff 2004,
// Algorithm 3.16). It starts where the arm is and from a random configuration each time it stalls; one trial a step.
#include <Eigen/Cholesky>
#include <algorithm>

#include "numerics/functions.hpp"
#include "solvers/bounds.hpp"
#include "solvers/registry.hpp"

namespace ikbench::solvers {

using namespace numerics;
using namespace robots;

namespace {

class DampedLeastSquares final : public Solver {
 public:
  struct Options {
    double damping = 1e-3;
    int patience = 5;
    double small_error = 1e-9;
    Bounds bounds = Bounds::clamp;

    void list(OptionList& list) {
      list.number("damping", damping, {1e-12, 1}, "initial damping, relative to the largest diagonal element of J^T J");
      list.count("patience", patience, {1, 1000},
                 "the solver stalls after this many trials in a row that reduce the error by less than 1 %");
      list.number("small_error", small_error, {0, 1},
                  "a stall below this error [m] counts as convergence, without a random restart");
      list_bounds(list, bounds);
    }
  };

  explicit DampedLeastSquares(Options options) : options_(options) {}

  void start(const Problem& problem, Objective& objective, Random&) override {
    problem_ = problem;
    jacobian_.resize(3, problem.joints());
    step_.resize(problem.joints());
    candidate_ = problem.start;
    keep_inside(options_.bounds, problem_, candidate_);
    best_ = {problem.start};
    begin(objective);
  }

  void step(Objective& objective, Random& random) override {
    if (failures_ >= options_.patience) {
      candidate_ = best_.q;
      if (!(best_.error <= options_.small_error)) {
        for (Eigen::Index j = 0; j < candidate_.size(); ++j) {
          candidate_[j] = random.uniform(problem_.lower[j], problem_.upper[j]);
        }
      }
      begin(objective);
      return;
    }
    // (J^T J + mu I)^-1 J^T e = J^T (J J^T + mu I)^-1 e, and the second is 3 x 3 for any number of joints.
    const Eigen::Matrix3d damped = jacobian_.lazyProduct(jacobian_.transpose()) + mu_ * Eigen::Matrix3d::Identity();
    step_.noalias() = jacobian_.transpose() * damped.ldlt().solve(to_go_);
    candidate_ = q_ + step_;
    keep_inside(options_.bounds, problem_, candidate_);
    const double error = objective.error(candidate_);
    failures_ = error < 0.99 * error_ ? 0 : failures_ + 1;
    if (error < error_) {
      const double predicted = mu_ * step_.squaredNorm() + (jacobian_ * step_).dot(to_go_);
      const double gain = (error_ * error_ - error * error) / predicted;
      mu_ *= std::max(1.0 / 3, 1 - power(2 * gain - 1, 3));
      growth_ = 2;
      arrive(error, objective);
    } else {
      mu_ *= growth_;
      growth_ *= 2;
    }
  }

  const Best& best() const override { return best_; }

 private:
  // A new descent from the candidate.
  void begin(Objective& objective) {
    arrive(objective.error(candidate_), objective);
    mu_ = options_.damping * jacobian_.colwise().squaredNorm().maxCoeff();
    growth_ = 2;
    failures_ = 0;
  }

  void arrive(double error, Objective& objective) {
    q_ = candidate_;
    error_ = error;
    best_.improve(q_, error_);
    to_go_ = objective.position_jacobian(q_, jacobian_);
  }

  Options options_;
  Problem problem_;
  Configuration q_, candidate_, step_;
  Eigen::Matrix3Xd jacobian_;
  Eigen::Vector3d to_go_;  // target - position [m]
  double error_ = 0, mu_ = 0, growth_ = 2;
  int failures_ = 0;
  Best best_;
};

}  // namespace

SolverInfo damped_least_squares() {
  return solver_info<DampedLeastSquares>("damped_least_squares", "damped least squares with random restarts",
                                         "Wampler 1986; Madsen, Nielsen and Tingleff 2004, Algorithm 3.16");
}

}  // namespace ikbench::solvers
