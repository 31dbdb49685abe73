// Halley's method for a position or a pose, as Lloyd, Irani and Ahmadi 2022 describe it (QuIK), and Newton's method
// with the same residual, so that both differ in nothing else. With e to go and the geometric Jacobian J:
//   Newton:  q += J^+ e
//   Halley:  dq = J^+ e / 2, A = J + sum_i dJ/dq_i dq_i, q += A^+ e
// The derivatives of J are cross products of its own columns (v above, w below) and so cost next to nothing. They are
// those of joints that move independently; for coupled joints A is an approximation. A far target is brought closer:
// the residual is cut to a length that a step can trust.
#include "solvers/bounds.hpp"
#include "solvers/pseudo_inverse.hpp"
#include "solvers/registry.hpp"
#include "solvers/twist.hpp"

namespace ikbench::solvers {

using namespace numerics;
using namespace robots;

namespace {

class Halley final : public Solver {
 public:
  enum class Method { halley, newton };
  struct Options {
    Method method = Method::halley;
    double most_position_m = 0.34;
    double most_rotation_rad = 1.00;
    double small_error = 1e-8;
    Bounds bounds = Bounds::clamp;

    void list(OptionList& list) {
      list.choice("method", method, {{"halley", Method::halley}, {"newton", Method::newton}},
                  "a step with the second derivatives of the arm, or without");
      list.number("most_position_m", most_position_m, {1e-6, 1e6},
                  "a longer position error is cut to this length; the authors use 0.34, and 0.14 for newton");
      list.number("most_rotation_rad", most_rotation_rad, {1e-6, 1e6},
                  "the same for a rotation; the authors use 1.00, and 0.86 for newton");
      list.number("small_error", small_error, {0, 1}, "the solver ends where the residual [m, rad] is below this");
      list_bounds(list, bounds);
    }
  };

  explicit Halley(Options options) : options_(options) {}

  void start(const Problem& problem, Objective& objective, Random&) override {
    problem_ = problem;
    jacobian_.resize(objective.rows(), problem.joints());
    bent_.resize(objective.rows(), problem.joints());
    all_rows_.resize(6, problem.joints());
    q_ = problem.start;
    keep_inside(options_.bounds, problem_, q_);
    best_ = {problem.start};
    gave_up_ = false;
    arrive(objective);
  }

  void step(Objective& objective, Random&) override {
    if (finished()) return;
    const Residual e = cut(to_go_);
    Configuration step = pseudo_inverse_times(jacobian_, e, 0);
    if (options_.method == Method::halley) {
      bend(step / 2);
      step = pseudo_inverse_times(bent_, e, 0);
    }
    q_ += step;
    keep_inside(options_.bounds, problem_, q_);
    gave_up_ = !q_.allFinite();
    if (!gave_up_) arrive(objective);
  }

  const Best& best() const override { return best_; }
  bool finished() const override { return gave_up_ || to_go_.norm() < options_.small_error; }
  bool gave_up() const override { return gave_up_; }

 private:
  void arrive(Objective& objective) {
    best_.improve(q_, objective.error(q_));
    to_go_ = linearize_twist(objective, q_, jacobian_);
    gave_up_ = !to_go_.allFinite();
    if (options_.method == Method::newton) return;
    // The derivatives of positions need the axes, too.
    if (objective.rows() == 3) {
      objective.arm().pose_jacobian(q_, all_rows_);
    } else {
      all_rows_ = jacobian_;
    }
  }

  Residual cut(Residual e) const {
    const double position = e.head<3>().norm();
    if (position > options_.most_position_m) e.head<3>() *= options_.most_position_m / position;
    if (e.size() == 3) return e;
    const double rotation = e.tail<3>().norm();
    if (rotation > options_.most_rotation_rad) e.tail<3>() *= options_.most_rotation_rad / rotation;
    return e;
  }

  // Writes A: J, and how it changes on the way dq. dJ_j/dq_i is w_min(i,j) x v_max(i,j) above, and below w_i x w_j for
  // a joint i before j, else 0.
  void bend(const Configuration& dq) {
    using Vector = Eigen::Vector3d;
    bent_ = jacobian_;
    const bool is_pose = bent_.rows() == 6;
    for (Eigen::Index j = 0; j < dq.size(); ++j) {
      const Vector v = all_rows_.col(j).head<3>(), w = all_rows_.col(j).tail<3>();
      Vector of_w_before = Vector::Zero(), of_v_after = Vector::Zero();
      for (Eigen::Index i = 0; i <= j; ++i) of_w_before += dq[i] * all_rows_.col(i).tail<3>();
      for (Eigen::Index i = j + 1; i < dq.size(); ++i) of_v_after += dq[i] * all_rows_.col(i).head<3>();
      bent_.col(j).head<3>() += of_w_before.cross(v) + w.cross(of_v_after);
      if (is_pose) bent_.col(j).tail<3>() += of_w_before.cross(w);  // its last term, w x w, is 0
    }
  }

  Options options_;
  Problem problem_;
  Configuration q_;
  Eigen::MatrixXd jacobian_, bent_, all_rows_;
  Residual to_go_;
  bool gave_up_ = false;
  Best best_;
};

}  // namespace

SolverInfo halley() {
  return solver_info<Halley>("halley", "Halley's method: Newton's with second derivatives of the arm, without restarts",
                             "Lloyd, Irani and Ahmadi 2022, QuIK, IEEE T-RO 38(5)");
}

}  // namespace ikbench::solvers
