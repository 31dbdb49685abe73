// Levenberg and Marquardt's method as roboticists use it: every step is taken, and the damping follows from the error
// of the moment (Sugihara 2011; Chan and Lawrence 1988) or is constant (Wampler 1986). A search restarts at a random
// configuration after too many steps, as in ikine_LM of the Robotics Toolbox (Corke and Haviland 2021), and here also
// when no joint moves any more, when steps no longer reach a smaller residual (a search that overshoots, as at the edge
// of the reach, seldom recovers), and when it ends outside the limits.
#include <algorithm>
#include <limits>

#include "solvers/bounds.hpp"
#include "solvers/damped_step.hpp"
#include "solvers/registry.hpp"

namespace ikbench::solvers {

namespace {

class LevenbergMarquardt final : public Searcher {
 public:
  enum class Rule { chan, sugihara, wampler };
  struct Options {
    Rule rule = Rule::chan;
    double damping = 0.1;
    int search_iterations = 30;
    double small_move = 1e-9;
    double small_error = 1e-9;
    Bounds bounds = Bounds::free;

    void list(OptionList& list) {
      list.choice("rule", rule, {{"chan", Rule::chan}, {"sugihara", Rule::sugihara}, {"wampler", Rule::wampler}},
                  "what is added to the diagonal of J^T J, where E is half the squared residual [m, rad]: "
                  "damping E, E + damping, or damping");
      list.number("damping", damping, {1e-12, 1e6}, "factor or term of the rule");
      list.count("search_iterations", search_iterations, {1, 1'000'000},
                 "after so many iterations the search begins again at a random configuration");
      list.number("small_move", small_move, {0, 1},
                  "and where each joint moves by less than this [rad, m], or three steps in a row reach no smaller "
                  "residual; 0: neither");
      list.number("small_error", small_error, {0, 1}, "it ends below this error [m]");
      list_bounds_of_search(list, bounds);
    }
  };

  explicit LevenbergMarquardt(Options options) : options_(options) {}

  void start(const Problem& problem, Objective& objective, Random&) override {
    take(problem);
    jacobian_.resize(objective.rows(), problem.joints());
    step_.resize(problem.joints());
    q_ = problem.start;
    keep_inside(options_.bounds == Bounds::free ? Bounds::clamp : options_.bounds, problem_, q_);
    restarts_ = 0;
    begin(objective);
  }

  void step(Objective& objective, Random& random) override {
    if (finished()) return;
    if (searched_ == options_.search_iterations) {
      draw_one_within_limits(problem_, random, q_);
      ++restarts_;
      begin(objective);
      return;
    }
    ++searched_;
    // dq = (J^T J + W)^-1 J^T e
    damped_step(jacobian_, linearized_.to_go, damping(), step_);
    before_ = q_;
    q_ += step_;
    keep_inside(options_.bounds, problem_, q_);
    if ((q_ - before_).cwiseAbs().maxCoeff() < options_.small_move) searched_ = options_.search_iterations;
    if (!q_.allFinite()) {
      q_ = before_;
      searched_ = options_.search_iterations;
      return;
    }
    arrive(objective);
    if (options_.bounds == Bounds::free && ends_outside(problem_, q_, step_)) searched_ = options_.search_iterations;
  }

  bool finished() const override { return best_.error <= options_.small_error; }
  int restarts() const override { return restarts_; }

 private:
  static constexpr int patience = 3;  // steps

  void begin(Objective& objective) {
    searched_ = failures_ = 0;
    least_ = std::numeric_limits<double>::infinity();
    arrive(objective);
  }

  void arrive(Objective& objective) {
    linearized_ = linearize_twist(objective, q_, jacobian_);
    const double squared = linearized_.to_go.squaredNorm();
    failures_ = squared < least_ ? 0 : failures_ + 1;
    least_ = std::min(least_, squared);
    if (failures_ == patience && options_.small_move > 0) searched_ = options_.search_iterations;
    if (counts(options_.bounds, problem_, q_))
      best_.improve(q_, linearized_.error);
    else if (linearized_.error <= std::max(options_.small_error, problem_.stop.tolerance))
      searched_ = options_.search_iterations;  // at the target, outside
  }

  double damping() const {
    const double E = linearized_.to_go.squaredNorm() / 2;
    if (options_.rule == Rule::chan) return options_.damping * E;
    return options_.rule == Rule::sugihara ? E + options_.damping : options_.damping;
  }

  Options options_;
  Configuration q_, before_, step_;
  Eigen::MatrixXd jacobian_;
  Linearized linearized_;
  double least_ = 0;                 // squared residual of this search
  int searched_ = 0, failures_ = 0;  // its iterations; those since the least
  int restarts_ = 0;
};

}  // namespace

SolverInfo levenberg_marquardt() {
  return solver_info<LevenbergMarquardt>(
      "levenberg_marquardt", "Levenberg and Marquardt's method, damped by the error, with random restarts",
      "Sugihara 2011; Chan and Lawrence 1988; Wampler 1986; Corke and Haviland 2021");
}

}  // namespace ikbench::solvers
