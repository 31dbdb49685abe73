// Ceres' TinySolver (Agarwal, Mierle and others): Levenberg and Marquardt's method on our residual and Jacobian. It
// knows no joint limits. One step is one call of the library, which ends by itself or by the study's budgets and
// tolerances.
#include <ceres/tiny_solver.h>
#include <ceres/version.h>
#include <fmt/format.h>

#include <algorithm>

#include "solvers/bounds.hpp"
#include "solvers/peers/evaluations.hpp"
#include "solvers/registry.hpp"

namespace ikbench::solvers {

using namespace numerics;
using namespace robots;

namespace {

// Residuals and Jacobian at the candidates that the library asks for, with its sign: how far the tool is beyond its
// target.
class WayBeyond {
 public:
  using Scalar = double;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = Eigen::Dynamic };

  WayBeyond(Evaluations& evaluations, Eigen::MatrixXd& jacobian) : evaluations_(evaluations), jacobian_(jacobian) {}

  int NumResiduals() const { return static_cast<int>(jacobian_.rows()); }
  int NumParameters() const { return static_cast<int>(jacobian_.cols()); }

  bool operator()(const double* parameters, double* residuals, double* slope) const {
    const Eigen::Map<const Eigen::VectorXd> q(parameters, jacobian_.cols());
    if (q_.size() != q.size() || q_ != q) evaluate(q);  // accepted candidates are asked for again
    Eigen::Map<Eigen::VectorXd>(residuals, to_go_.size()) = -to_go_;
    if (slope != nullptr) Eigen::Map<Eigen::MatrixXd>(slope, jacobian_.rows(), jacobian_.cols()) = jacobian_;
    return true;
  }

 private:
  void evaluate(const Eigen::Map<const Eigen::VectorXd>& q) const {
    if (!evaluations_.is_over()) evaluations_.error(q);
    if (evaluations_.is_over()) throw IsOver();
    q_ = q;
    to_go_ = evaluations_.objective().linearize(q, jacobian_);
    if (to_go_.allFinite() && jacobian_.allFinite()) return;
    to_go_.setConstant(Evaluations::no_error);
    jacobian_.setZero();
  }

  Evaluations& evaluations_;
  Eigen::MatrixXd& jacobian_;
  mutable Configuration q_ = {};  // the last candidate, mutable since the library calls a const function
  mutable Residual to_go_ = {};
};

class CeresTiny final : public Solver {
 public:
  enum class Restarts { none, random };
  struct Options {
    Restarts restarts = Restarts::none;
    double small_move = 1e-8;

    void list(OptionList& list) {
      list.choice("restarts", restarts, {{"none", Restarts::none}, {"random", Restarts::random}},
                  "after a call of the library: end, or call it again from a random configuration");
      list.number("small_move", small_move, {0, 1},
                  "a call ends where a step is smaller than this share of the angles (parameter_tolerance)");
    }
  };

  explicit CeresTiny(Options options) : options_(options) {}

  void start(const Problem& problem, Objective& objective, Random&) override {
    solve_.start(problem, objective);
    jacobian_.resize(objective.rows(), problem.joints());
    calls_ = 0;
  }

  void step(Objective& objective, Random& random) override {
    if (solve_.has_ended) return;
    angles_ = solve_.problem.start;
    if (calls_++ > 0) draw_one_within_limits(solve_.problem, random, angles_);
    Evaluations evaluations(solve_, objective);
    call(evaluations);
    solve_.has_ended = options_.restarts == Restarts::none || evaluations.is_over();
  }

  const Best& best() const override { return solve_.best; }
  bool finished() const override { return solve_.has_ended; }

 private:
  // The library ends when it stands still; the study decides when it is near enough.
  void call(Evaluations& evaluations) {
    solver_.options.gradient_tolerance = solver_.options.function_tolerance = solver_.options.cost_threshold = 0;
    solver_.options.parameter_tolerance = options_.small_move;
    solver_.options.max_num_iterations =
        static_cast<int>(std::clamp<std::int64_t>(evaluations.left(), 1, 1'000'000'000));
    try {
      solver_.Solve(WayBeyond(evaluations, jacobian_), &angles_);
    } catch (const IsOver&) {  // the best evaluated candidate is kept
    }
  }

  Options options_;
  LibrarySolve solve_;
  ceres::TinySolver<WayBeyond> solver_;
  Eigen::VectorXd angles_;
  Eigen::MatrixXd jacobian_;
  int calls_ = 0;
};

}  // namespace

SolverInfo ceres_tiny() {
  SolverInfo info =
      solver_info<CeresTiny>("ceres_tiny", "Ceres' TinySolver (Levenberg-Marquardt), without joint limits",
                             "Agarwal, Mierle and the Ceres Solver team 2022");
  info.library = fmt::format("Ceres {}.{}.{}", CERES_VERSION_MAJOR, CERES_VERSION_MINOR, CERES_VERSION_REVISION);
  return info;
}

}  // namespace ikbench::solvers
