// Damped least squares, a roboticist's first choice: Wampler 1986 and Nakamura and Hanafusa 1986, with a damping that
// the gain ratio steers as in Nielsen 1999 (Madsen, Nielsen and Tingleff 2004, Algorithm 3.16): a step that increases
// the error is undone. (levenberg_marquardt takes every step, with a damping from the error alone.) It starts at the
// arm's configuration, and from a random one each time it stalls; one trial per step.
#include <algorithm>

#include "numerics/functions.hpp"
#include "solvers/bounds.hpp"
#include "solvers/damped_step.hpp"
#include "solvers/registry.hpp"

namespace ikbench::solvers {

using namespace numerics;

namespace {

class DampedLeastSquares final : public Searcher {
 public:
  struct Options {
    double damping = 1e-3;
    int patience = 5;
    double small_error = 1e-9;
    Bounds bounds = Bounds::free;

    void list(OptionList& list) {
      list.number("damping", damping, {1e-12, 1}, "initial damping, relative to the largest diagonal element of J^T J");
      list.count("patience", patience, {1, 1000},
                 "the solver stalls after this many trials in a row that reduce the error by less than 1 %");
      list.number("small_error", small_error, {0, 1},
                  "a stall below this error [m] counts as convergence, without a random restart");
      list_bounds_of_search(list, bounds);
    }
  };

  explicit DampedLeastSquares(Options options) : options_(options) {}

  void start(const Problem& problem, Objective& objective, Random&) override {
    take(problem);
    jacobian_.resize(objective.rows(), problem.joints());
    trial_jacobian_.resize(objective.rows(), problem.joints());
    step_.resize(problem.joints());
    candidate_ = problem.start;
    restarts_ = 0;
    keep_inside(options_.bounds == Bounds::free ? Bounds::clamp : options_.bounds, problem_, candidate_);
    begin(objective);
  }

  void step(Objective& objective, Random& random) override {
    if (failures_ >= options_.patience) {
      candidate_ = best_.q;
      if (!(best_.error <= options_.small_error)) {
        draw_one_within_limits(problem_, random, candidate_);
        ++restarts_;
      }
      begin(objective);
      return;
    }
    const double predicted = objective.rows() == 3 ? propose<3>() : propose<6>();
    keep_inside(options_.bounds, problem_, candidate_);
    const double merit = evaluate(objective);
    if (options_.bounds == Bounds::free && ends_outside(problem_, candidate_, step_)) is_outside_ = true;
    failures_ = merit < 0.99 * merit_ ? 0 : failures_ + 1;
    if (is_outside_) failures_ = options_.patience;
    if (merit < merit_) {
      const double gain = (merit_ * merit_ - merit * merit) / predicted;
      mu_ *= std::max(1.0 / 3, 1 - power(2 * gain - 1, 3));
      growth_ = 2;
      arrive(merit);
    } else {
      mu_ *= growth_;
      growth_ *= 2;
    }
  }

  int restarts() const override { return restarts_; }

 private:
  // Starts a descent from the candidate.
  void begin(Objective& objective) {
    arrive(evaluate(objective));
    mu_ = options_.damping * (objective.rows() == 3 ? largest_diagonal<3>() : largest_diagonal<6>());
    growth_ = 2;
    failures_ = 0;
  }

  // Evaluates the candidate and returns the merit that the descent reduces: the norm of the linearized residual. For a
  // position the merit is the error. For a pose it differs: following the slope of one but judging by the other would
  // refuse good steps, so that the error only decides which candidate is the best.
  double evaluate(Objective& objective) {
    trial_ = objective.linearize(candidate_, trial_jacobian_);
    const bool may_be_best = counts(options_.bounds, problem_, candidate_);
    if (may_be_best) best_.improve(candidate_, trial_.error);
    is_outside_ = !may_be_best && trial_.error <= std::max(options_.small_error, problem_.stop.tolerance);
    return objective.rows() == 3 ? trial_.error : trial_.to_go.norm();
  }

  void arrive(double merit) {
    q_ = candidate_;
    merit_ = merit;
    to_go_ = trial_.to_go;
    jacobian_.swap(trial_jacobian_);
  }

  // Makes the next candidate; returns how much the squared merit falls if the residual is linear.
  template <int rows>
  double propose() {
    damped_step(jacobian_, to_go_, mu_, step_);
    candidate_ = q_ + step_;
    Eigen::Matrix<double, rows, 1> moved = Eigen::Matrix<double, rows, 1>::Zero();
    for (Eigen::Index j = 0; j < step_.size(); ++j) moved += step_[j] * jacobian_.col(j).head<rows>();
    return mu_ * step_.squaredNorm() + dot(moved, to_go_.head<rows>());
  }

  template <int rows>
  double largest_diagonal() const {
    return jacobian_.topRows<rows>().colwise().squaredNorm().maxCoeff();
  }

  Options options_;
  Configuration q_, candidate_, step_;
  Eigen::MatrixXd jacobian_, trial_jacobian_;
  Residual to_go_;
  Linearized trial_;
  double merit_ = 0, mu_ = 0, growth_ = 2;
  int failures_ = 0, restarts_ = 0;
  bool is_outside_ = false;  // at the target, outside the limits, or on the way there
};

}  // namespace

SolverInfo damped_least_squares() {
  return solver_info<DampedLeastSquares>("damped_least_squares",
                                         "damped least squares (DLS), damped by the gain ratio, with random restarts",
                                         "Wampler 1986; Madsen, Nielsen and Tingleff 2004, Algorithm 3.16");
}

}  // namespace ikbench::solvers
