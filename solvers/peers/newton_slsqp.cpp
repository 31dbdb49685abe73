// The rule of TRAC-IK 1.4.6 (Beeson and Ames 2015): KDL's with restarts (`newton`) beside sequential quadratic
// programming (NLopt's SLSQP) on the squared twist that is left, both restarted at random; the first to converge ends
// the solve. The authors have a thread for each and a clock. Here a step of Newton's and an evaluation of SLSQP take
// turns in one thread, at most the study's iterations of each. SLSQP gets the exact slope in place of differences.
#include <limits>

#include "solvers/damped_step.hpp"
#include "solvers/peers/evaluations.hpp"
#include "solvers/registry.hpp"

namespace ikbench::solvers {

namespace {
using namespace robots;

class NewtonSlsqp final : public NloptSearch {
 public:
  struct Options {
    void list(OptionList&) {}
  };
  explicit NewtonSlsqp(Options) : newton_(solver("newton").make({{"restarts", "random"}, {"bounds", "wrap"}})) {}

  void start(const Problem& problem, Objective& objective, Random& random) override {
    NloptSearch::start(problem, objective, random);
    if (problem.stop.evaluations != 1) newton_->start(problem, objective, random);  // which evaluates, too
    steps_ = 0;
  }

  int restarts() const override { return NloptSearch::restarts() + newton_->restarts(); }

  // One call of SLSQP.
  void step(Objective& objective, Random& random) override {
    if (has_ended_) return;
    Configuration q = next_start(random);
    Evaluations evaluations(*this, objective);
    const JointLimits limits = finite_limits(problem_);
    const NloptHandle opt(nlopt_create(NLOPT_LD_SLSQP, static_cast<unsigned>(q.size())));
    Call call{*this, evaluations, random, opt.get()};
    nlopt_set_min_objective(opt.get(), take_turns, &call);
    nlopt_set_lower_bounds(opt.get(), limits.lower.data());
    nlopt_set_upper_bounds(opt.get(), limits.upper.data());
    nlopt_set_xtol_abs1(opt.get(), std::numeric_limits<float>::epsilon());
    double reached = 0;
    nlopt_optimize(opt.get(), q.data(), &reached);
    has_ended_ = is_over(evaluations);
  }

 private:
  struct Call {
    NewtonSlsqp& solver;
    Evaluations& evaluations;
    Random& random;
    nlopt_opt opt;
  };

  bool is_over(Evaluations& evaluations) const {
    return evaluations.is_over() || newton_->finished() || steps_ >= problem_.stop.iterations;
  }

  // A step of Newton's, then the squared twist and its slope for SLSQP.
  static double take_turns(unsigned joints, const double* x, double* gradient, void* data) {
    auto& [solver, evaluations, random, opt] = *static_cast<Call*>(data);
    if (!solver.is_over(evaluations)) {
      solver.newton_->step(evaluations.objective(), random);
      ++solver.steps_;
      evaluations.found(solver.newton_->best().q, solver.newton_->best().error);
    }
    const Eigen::Map<const Eigen::VectorXd> q(x, joints);
    if (gradient != nullptr) Eigen::Map<Eigen::VectorXd>(gradient, joints).setZero();
    Residual to_go;
    if (!solver.is_over(evaluations))
      to_go = evaluations.found(q, linearize_twist(evaluations.objective(), q, solver.jacobian_));
    if (solver.is_over(evaluations)) return nlopt_force_stop(opt), Evaluations::no_error;
    if (!to_go.allFinite() || !solver.jacobian_.allFinite()) return Evaluations::no_error;
    if (gradient != nullptr)  // half of the slope, as theirs
      Eigen::Map<Eigen::VectorXd>(gradient, joints) = -solver.jacobian_.transpose() * to_go;
    return to_go.squaredNorm();
  }

  std::unique_ptr<Solver> newton_;
  int steps_ = 0;
};

}  // namespace

SolverInfo newton_slsqp() {
  SolverInfo info = solver_info<NewtonSlsqp>(
      "newton_slsqp",
      "TRAC-IK's rule, not its program, which takes 5 to 6 times the processor time: Newton with restarts beside "
      "NLopt's SLSQP",
      "Beeson and Ames 2015; TRAC-IK 1.4.6");
  info.library = nlopt_version_text();
  return info;
}

}  // namespace ikbench::solvers
