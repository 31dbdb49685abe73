// NLopt (Johnson 2007) minimizes our objective: half the square of the residual for algorithms that use a slope, else
// the error. One step is one call of the library, which ends by itself or by the study's budgets and tolerances.
#include <limits>

#include "solvers/peers/evaluations.hpp"
#include "solvers/registry.hpp"

namespace ikbench::solvers {

using namespace robots;

namespace {

class NloptSolver final : public NloptSearch {
 public:
  enum class Restarts { none, random };
  struct Options {
    nlopt_algorithm algorithm = NLOPT_LD_SLSQP;
    Restarts restarts = Restarts::none;
    double small_move = 1e-8;

    void list(OptionList& list) {
      list.choice(
          "algorithm", algorithm,
          {{"slsqp", NLOPT_LD_SLSQP},
           {"lbfgs", NLOPT_LD_LBFGS},
           {"bobyqa", NLOPT_LN_BOBYQA},
           {"nelder_mead", NLOPT_LN_NELDERMEAD},
           {"direct_l", NLOPT_GN_DIRECT_L},
           {"crs2_lm", NLOPT_GN_CRS2_LM}},
          "of NLopt; the first two use the Jacobian, the next two search near the start, the last two everywhere "
          "within the limits");
      list.choice("restarts", restarts, {{"none", Restarts::none}, {"random", Restarts::random}},
                  "after a call of the library: end, or call it again from a random configuration");
      list.number("small_move", small_move, {0, 1}, "a call ends where no joint moves by more than this [rad, m]");
    }
  };

  explicit NloptSolver(Options options) : options_(options) {}

  void step(Objective& objective, Random& random) override {
    if (has_ended_) return;
    const Configuration q = next_start(random);
    nlopt_srand(static_cast<unsigned long>(random.index(std::numeric_limits<int>::max())));  // this thread's generator
    Evaluations evaluations(*this, objective);
    if (!evaluations.is_over()) call(evaluations, q);
    has_ended_ = options_.restarts == Restarts::none || evaluations.is_over();
  }

 private:
  struct Call {
    NloptSolver& solver;
    Evaluations& evaluations;
    nlopt_opt opt;
  };

  // The answer is the best evaluated candidate, so it does not matter how the library ended, or that it refused (some
  // algorithms need more than one joint).
  void call(Evaluations& evaluations, Configuration q) {
    const JointLimits limits =
        searches_everywhere() ? finite_limits(problem_) : JointLimits{problem_.lower, problem_.upper};
    const NloptHandle opt(nlopt_create(options_.algorithm, static_cast<unsigned>(q.size())));
    Call call{*this, evaluations, opt.get()};
    nlopt_set_min_objective(opt.get(), merit, &call);
    nlopt_set_lower_bounds(opt.get(), limits.lower.data());
    nlopt_set_upper_bounds(opt.get(), limits.upper.data());
    set_first_steps(opt.get(), q);
    nlopt_set_xtol_rel(opt.get(), 0);
    nlopt_set_xtol_abs1(opt.get(), options_.small_move);
    nlopt_set_population(opt.get(), static_cast<unsigned>(problem_.population));
    // Otherwise L-BFGS clears room for as many steps as evaluations are allowed, which takes a millisecond.
    nlopt_set_vector_storage(opt.get(), 100);
    nlopt_set_maxeval(opt.get(), static_cast<int>(std::min<std::int64_t>(evaluations.left(), 1'000'000'000)));
    double reached = 0;
    nlopt_optimize(opt.get(), q.data(), &reached);
  }

  // Returns true for algorithms that need finite limits. For a continuous joint, a whole turn on both sides of the
  // start contains every direction well inside.
  bool searches_everywhere() const {
    return options_.algorithm == NLOPT_GN_DIRECT_L || options_.algorithm == NLOPT_GN_CRS2_LM;
  }

  // Sets the first step of continuous joints to a quarter turn. NLopt's own first step is a quarter of a joint's range,
  // or, without limits, the joint's value, however small.
  void set_first_steps(nlopt_opt opt, const Configuration& q) const {
    if (problem_.lower.allFinite() && problem_.upper.allFinite()) return;
    Configuration steps = q;
    nlopt_get_initial_step(opt, q.data(), steps.data());
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      if (is_endless(problem_.lower[j], problem_.upper[j])) steps[j] = half_turn / 2;
    }
    nlopt_set_initial_step(opt, steps.data());
  }

  static double merit(unsigned joints, const double* x, double* gradient, void* data) {
    const Call& call = *static_cast<Call*>(data);
    const Eigen::Map<const Eigen::VectorXd> q(x, joints);
    Evaluations& evaluations = call.evaluations;
    Eigen::Map<Eigen::VectorXd> written(gradient, gradient == nullptr ? 0 : joints);
    written.setZero();
    double merit = Evaluations::no_error;
    if (!evaluations.is_over() && gradient == nullptr) merit = evaluations.error(q);
    if (!evaluations.is_over() && gradient != nullptr) {
      Eigen::MatrixXd& jacobian = call.solver.jacobian_;
      const Residual to_go = evaluations.found(q, evaluations.objective().linearize(q, jacobian));
      const Configuration slope = -jacobian.transpose() * to_go;
      if (slope.allFinite() && to_go.allFinite()) {
        written = slope;
        merit = to_go.squaredNorm() / 2;
      }
    }
    if (evaluations.is_over()) nlopt_force_stop(call.opt);  // some algorithms ask once more after that
    return merit;
  }

  Options options_;
};

}  // namespace

SolverInfo nlopt() {
  SolverInfo info = solver_info<NloptSolver>("nlopt", "NLopt's optimizers (option algorithm)",
                                             "Johnson 2007, The NLopt nonlinear-optimization package");
  info.library = nlopt_version_text();
  return info;
}

}  // namespace ikbench::solvers
