// The numerical searches of the Robotics Toolbox for Python (Corke and Haviland 2021), as Haviland and Corke 2023
// describe them: every search begins at a configuration of its own. A step is computed from the residual e, taken, and
// then the search ends if E = e^T e / 2 from before the step is small enough. A search with too many steps fails, and
// the next one begins.
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

#include "numerics/numpy_random.hpp"
#include "solvers/bounds.hpp"
#include "solvers/damped_step.hpp"
#include "solvers/pseudo_inverse.hpp"
#include "solvers/registry.hpp"
#include "solvers/twist.hpp"

namespace ikbench::solvers {

using namespace numerics;
using namespace robots;

namespace {

class RoboticsToolbox final : public Solver {
 public:
  enum class Method { newton, gauss_newton, chan, sugihara, wampler };
  enum class Inverse { pseudo, exact };
  enum class LastStep { taken, dropped };
  enum class Limits { ignored, required };
  enum class Starts { random, numpy };
  struct Options {
    Method method = Method::chan;
    double damping = 0.1;
    Inverse inverse = Inverse::pseudo;
    int steps = 31;
    int searches = 100;
    double enough = 1e-6;
    LastStep last_step = LastStep::taken;
    Limits limits = Limits::required;
    Starts starts = Starts::random;
    int starts_seed = 0;
    int starts_skipped = 0;

    void list(OptionList& list) {
      list.choice(
          "method", method,
          {{"newton", Method::newton},
           {"gauss_newton", Method::gauss_newton},
           {"chan", Method::chan},
           {"sugihara", Method::sugihara},
           {"wampler", Method::wampler}},
          "the step: J^-1 e; (J^T J)^-1 J^T e; or (J^T J + W)^-1 J^T e with W = damping E, E + damping, or damping "
          "on the diagonal");
      list.number("damping", damping, {1e-12, 1e6}, "of chan, sugihara and wampler");
      list.choice("inverse", inverse, {{"pseudo", Inverse::pseudo}, {"exact", Inverse::exact}},
                  "of newton and gauss_newton: the pseudo-inverse of J, or elimination where the matrix is square");
      list.count("steps", steps, {1, 1'000'000}, "steps of a search");
      list.count("searches", searches, {1, 10'000}, "searches, after which the solver gives up");
      list.number("enough", enough, {0, 1}, "a search succeeds where E [m^2, rad^2] is below this");
      list.choice("last_step", last_step, {{"taken", LastStep::taken}, {"dropped", LastStep::dropped}},
                  "whether the step computed where E is small enough is taken");
      list.choice(
          "limits", limits, {{"required", Limits::required}, {"ignored", Limits::ignored}},
          "whether a search fails if it ends outside the joint limits; before, joints that turn are turned into "
          "[-180, 180) deg");
      list.choice(
          "starts", starts, {{"random", Starts::random}, {"numpy", Starts::numpy}},
          "searches begin at the start of the solve and then at random; or at a list of configurations, the same "
          "for all targets, drawn as by NumPy's legacy generator");
      list.count("starts_seed", starts_seed, {0, 2'147'483'647}, "of starts = numpy: seed of the generator");
      list.count("starts_skipped", starts_skipped, {0, 100'000'000},
                 "of starts = numpy: numbers drawn before the list, as for targets");
    }
  };

  explicit RoboticsToolbox(Options options) : options_(options) {}

  void start(const Problem& problem, Objective& objective, Random&) override {
    if (options_.starts == Starts::numpy && !is_drawn_for(problem)) draw_starts(problem);
    problem_ = problem;
    jacobian_.resize(objective.rows(), problem.joints());
    step_.resize(problem.joints());
    square_.resize(problem.joints(), problem.joints());
    turns_.resize(problem.joints());
    for (Eigen::Index j = 0; j < turns_.size(); ++j) {
      turns_[j] = objective.arm().links()[static_cast<std::size_t>(j)].joint == Joint::turns;
    }
    best_ = {problem.start};
    best_.improve(problem.start, objective.error(problem.start));
    is_over_ = gave_up_ = false;
    searched_ = steps_ = 0;
    q_ = options_.starts == Starts::numpy ? Configuration(starts_.col(0)) : problem.start;
  }

  void step(Objective& objective, Random& random) override {
    if (is_over_) return;
    const Residual e = linearize_twist(objective, q_, jacobian_);
    const double E = e.squaredNorm() / 2;
    const bool is_near = E < options_.enough;
    if (!is_near || options_.last_step == LastStep::taken) {
      compute_step(e, E);
      q_ += step_;
    }
    ++steps_;
    if (is_near) {
      turn(q_);
      if (options_.limits == Limits::ignored || is_inside(q_)) {
        best_.improve(q_, objective.error(q_));
        is_over_ = true;
        return;
      }
    }
    if (is_near || steps_ == options_.steps || !q_.allFinite()) begin_search(random);
  }

  const Best& best() const override { return best_; }
  bool finished() const override { return is_over_; }
  bool gave_up() const override { return gave_up_; }
  int restarts() const override { return searched_; }

 private:
  void begin_search(Random& random) {
    if (searched_ + 1 == options_.searches) {
      is_over_ = gave_up_ = true;
      return;
    }
    ++searched_;
    steps_ = 0;
    if (options_.starts == Starts::numpy) {
      q_ = starts_.col(searched_);
    } else {
      draw_one_within_limits(problem_, random, q_);
    }
  }

  void compute_step(const Residual& e, double E) {
    const bool is_exact = options_.inverse == Inverse::exact;
    switch (options_.method) {
      case Method::newton:
        if (is_exact && jacobian_.rows() == jacobian_.cols()) {
          elimination_.compute(jacobian_);
          step_ = elimination_.solve(e);
          return;
        }
        break;
      case Method::gauss_newton:
        if (is_exact) {
          square_.noalias() = jacobian_.transpose().lazyProduct(jacobian_);
          elimination_.compute(square_);
          step_ = elimination_.solve(jacobian_.transpose().lazyProduct(e));
          return;
        }
        return jacobian_.rows() == 3 ? gauss_newton_step<3>(e) : gauss_newton_step<6>(e);
      case Method::chan:
        return damped_step(jacobian_, e, options_.damping * E, step_);
      case Method::sugihara:
        return damped_step(jacobian_, e, E + options_.damping, step_);
      case Method::wampler:
        return damped_step(jacobian_, e, options_.damping, step_);
    }
    step_ = pseudo_inverse_times(jacobian_, e, 0);
  }

  // J^T (J J^T)^+ e, which is (J^T J)^+ J^T e. It squares the singular values of J, as the authors' program does: the
  // search differs from Newton's where J is nearly singular. NumPy's pinv drops values below 1e-15 of the largest.
  template <int rows>
  void gauss_newton_step(const Residual& e) {
    const Eigen::Matrix<double, rows, 1> r = e.head<rows>();
    const Eigen::Matrix<double, rows, rows> square =
        jacobian_.topRows<rows>().lazyProduct(jacobian_.topRows<rows>().transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, rows, rows>> squares(square);
    const double smallest = 1e-15 * squares.eigenvalues().cwiseAbs().maxCoeff();
    Eigen::Matrix<double, rows, 1> sum = Eigen::Matrix<double, rows, 1>::Zero();
    for (int i = 0; i < rows; ++i) {
      const double value = squares.eigenvalues()[i];
      const auto direction = squares.eigenvectors().col(i);
      if (std::abs(value) > smallest) sum += direction.dot(r) / value * direction;
    }
    step_ = jacobian_.topRows<rows>().transpose().lazyProduct(sum);
  }

  // Turns joints into [-180, 180) deg.
  void turn(Configuration& q) const {
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      if (turns_[j]) q[j] -= whole_turn * std::floor((q[j] + half_turn) / whole_turn);
    }
  }

  bool is_inside(const Configuration& q) const {
    return (q.array() >= problem_.lower.array()).all() && (q.array() <= problem_.upper.array()).all();
  }

  bool is_drawn_for(const Problem& problem) const {
    return starts_.rows() == problem.joints() && drawn_from_.lower == problem.lower &&
           drawn_from_.upper == problem.upper;
  }

  void draw_starts(const Problem& problem) {
    drawn_from_ = {problem.lower, problem.upper};
    const JointLimits limits = finite_limits(problem);
    NumpyRandom random(static_cast<std::uint32_t>(options_.starts_seed),
                       static_cast<std::uint64_t>(options_.starts_skipped));
    starts_.resize(problem.joints(), options_.searches);
    for (Eigen::Index i = 0; i < starts_.cols(); ++i) {
      for (Eigen::Index j = 0; j < starts_.rows(); ++j)
        starts_(j, i) = random.uniform(limits.lower[j], limits.upper[j]);
    }
  }

  Options options_;
  Problem problem_;
  JointLimits drawn_from_;
  Eigen::MatrixXd starts_;  // one column per search
  Configuration q_, step_;
  Eigen::Array<bool, Eigen::Dynamic, 1, 0, most_joints, 1> turns_;  // false: slides
  Eigen::MatrixXd jacobian_, square_;
  Eigen::PartialPivLU<Eigen::MatrixXd> elimination_;
  int searched_ = 0, steps_ = 0;  // failed searches; steps of this one
  bool is_over_ = false, gave_up_ = false;
  Best best_;
};

}  // namespace

SolverInfo robotics_toolbox() {
  return solver_info<RoboticsToolbox>(
      "robotics_toolbox", "searches of the Robotics Toolbox: Newton, Gauss-Newton, Levenberg-Marquardt, with restarts",
      "Haviland and Corke 2023, Manipulator Differential Kinematics, Parts 1 and 2");
}

}  // namespace ikbench::solvers
