// Newton's method with the pseudo-inverse. With restarts = none and bounds = clamp it is KDL's ChainIkSolverPos_NR_JL
// with ChainIkSolverVel_pinv. With restarts = random and bounds = wrap it is KDL-RR, the variant of Beeson and Ames
// 2015 (TRAC-IK). With search_iterations it is ikine_NR of the Robotics Toolbox (Corke and Haviland 2021).
#include <algorithm>

#include "solvers/bounds.hpp"
#include "solvers/damped_step.hpp"
#include "solvers/registry.hpp"

namespace ikbench::solvers {

using namespace robots;

namespace {

class Newton final : public Searcher {
 public:
  enum class Restarts { none, random };
  enum class Limits { initial, clamp, wrap };
  struct Options {
    Restarts restarts = Restarts::random;
    int search_iterations = 0;
    double singular = 1e-5;
    double small_move = 1.2e-7;
    double small_error = 1e-9;
    Limits bounds = Limits::clamp;

    void list(OptionList& list) {
      list.choice("restarts", restarts, {{"random", Restarts::random}, {"none", Restarts::none}},
                  "where no joint moves any more: start again at a random configuration (KDL-RR), or end (KDL)");
      list.number("singular", singular, {0, 1}, "singular values of the Jacobian [m, rad] below this count as 0");
      list.number("small_move", small_move, {0, 1}, "no joint moves if each moves by less than this [rad, m]");
      list.number("small_error", small_error, {0, 1},
                  "an end below this error [m] counts as convergence, without a restart");
      list.choice("bounds", bounds, {{"initial", Limits::initial}, {"clamp", Limits::clamp}, {"wrap", Limits::wrap}},
                  "joint limits apply to the initial candidate only, or all are clamped to them, or a joint that turns "
                  "is first turned back inside by whole turns");
      list.later();
      list.count("search_iterations", search_iterations, {0, 1'000'000},
                 "after so many iterations, too, the search begins again at a random configuration; 0: never");
    }
  };

  explicit Newton(Options options) : options_(options) {}

  void start(const Problem& problem, Objective& objective, Random&) override {
    take(problem);
    jacobian_.resize(objective.rows(), problem.joints());
    q_ = problem.start;
    limit(q_, objective.arm());
    is_stuck_ = false;
    searched_ = restarts_ = 0;
    arrive(objective);
  }

  void step(Objective& objective, Random& random) override {
    if (finished()) return;
    if (is_stuck_ || (searched_ > 0 && searched_ == options_.search_iterations)) {
      draw_one_within_limits(problem_, random, q_);
      is_stuck_ = false;
      searched_ = 0;
      ++restarts_;
    } else {
      ++searched_;
      const Configuration before = q_;
      // J^+ e is J^T (J J^T)^-1 e, in a fifth of the time, where no singular value is small.
      if (!(damped_step(jacobian_, linearized_.to_go, 0, step_) > options_.singular * options_.singular))
        step_ = pseudo_inverse_times(jacobian_, linearized_.to_go, options_.singular);
      q_ += step_;
      limit(q_, objective.arm());
      if (!q_.allFinite()) {
        q_ = before;
        is_stuck_ = true;
        return;
      }
      is_stuck_ = (q_ - before).cwiseAbs().maxCoeff() < options_.small_move;
    }
    arrive(objective);
  }

  bool finished() const override {
    return is_stuck_ && (options_.restarts == Restarts::none || best_.error <= options_.small_error);
  }
  int restarts() const override { return restarts_; }

 private:
  void limit(Configuration& q, const Chain& arm) const {
    if (options_.bounds == Limits::initial) return;
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const double lower = problem_.lower[j], upper = problem_.upper[j];
      if (options_.bounds == Limits::wrap && arm.links()[static_cast<std::size_t>(j)].joint == Joint::turns)
        q[j] = turned_inside(q[j], lower, upper);
      q[j] = std::clamp(q[j], lower, upper);
    }
  }

  void arrive(Objective& objective) {
    linearized_ = linearize_twist(objective, q_, jacobian_);  // the units decide what counts as singular
    best_.improve(q_, linearized_.error);
  }

  Options options_;
  Configuration q_, step_;
  Eigen::MatrixXd jacobian_;
  Linearized linearized_;
  bool is_stuck_ = false;
  int searched_ = 0;  // iterations of this search
  int restarts_ = 0;
};

}  // namespace

SolverInfo newton() {
  return solver_info<Newton>("newton", "Newton-Raphson with the pseudo-inverse, clipped at the limits, with restarts",
                             "KDL, ChainIkSolverPos_NR_JL; Beeson and Ames 2015; Corke and Haviland 2021");
}

}  // namespace ikbench::solvers
