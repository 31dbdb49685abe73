// Newton's method with the pseudo-inverse. With restarts = none and bounds = clamp it is KDL's ChainIkSolverPos_NR_JL
// with ChainIkSolverVel_pinv. With restarts = random and bounds = wrap it is KDL-RR, the variant of Beeson and Ames
// 2015 (TRAC-IK).
#include <algorithm>
#include <cmath>

#include "solvers/bounds.hpp"
#include "solvers/registry.hpp"
#include "solvers/twist.hpp"

namespace ikbench::solvers {

using namespace numerics;
using namespace robots;

namespace {

// J^+ r, without singular values below `smallest`. Rotations of pairs of its rows, which do not change J^+ r, make them
// orthogonal; their lengths are then the singular values (one-sided Jacobi, Hestenes 1958).
template <int rows>
Configuration pseudo_inverse_times(const Eigen::MatrixXd& jacobian, const Residual& residual, double smallest) {
  Eigen::Matrix<double, Eigen::Dynamic, rows, 0, most_joints, rows> J = jacobian.topRows<rows>().transpose();
  Eigen::Matrix<double, rows, 1> r = residual.head<rows>();
  constexpr int most_sweeps = 30;
  bool turned = true;
  for (int sweep = 0; sweep < most_sweeps && turned; ++sweep) {
    turned = false;
    for (int i = 0; i < rows; ++i) {
      for (int k = i + 1; k < rows; ++k) {
        const double ii = J.col(i).squaredNorm(), kk = J.col(k).squaredNorm(), ik = J.col(i).dot(J.col(k));
        if (!(std::abs(ik) > 1e-15 * std::sqrt(ii * kk))) continue;
        turned = true;
        const double cotangent = (kk - ii) / (2 * ik);  // of twice the angle
        const double tangent = (cotangent < 0 ? -1 : 1) / (std::abs(cotangent) + std::sqrt(1 + cotangent * cotangent));
        const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = cosine * tangent;
        const auto turn = [&](double& a, double& b) {
          const double before = a;
          a = cosine * a - sine * b;
          b = sine * before + cosine * b;
        };
        for (Eigen::Index j = 0; j < J.rows(); ++j) turn(J(j, i), J(j, k));
        turn(r[i], r[k]);
      }
    }
  }
  Configuration product = Configuration::Zero(J.rows());
  for (int i = 0; i < rows; ++i) {
    const double squared = J.col(i).squaredNorm();
    if (squared > 0 && !(squared < smallest * smallest)) product += r[i] / squared * J.col(i);
  }
  return product;
}

class Newton final : public Solver {
 public:
  enum class Restarts { none, random };
  enum class Limits { initial, clamp, wrap };
  struct Options {
    Restarts restarts = Restarts::random;
    double singular = 1e-5;
    double small_move = 1.2e-7;
    double small_error = 1e-9;
    Limits bounds = Limits::clamp;

    void list(OptionList& list) {
      list.choice("restarts", restarts, {{"random", Restarts::random}, {"none", Restarts::none}},
                  "where no joint moves any more: start again at a random configuration (KDL-RR), or end (KDL)");
      list.number("singular", singular, {0, 1}, "singular values of the Jacobian [m, rad] below this count as 0");
      list.number("small_move", small_move, {0, 1}, "no joint moves if none moves by more than this [rad, m]");
      list.number("small_error", small_error, {0, 1},
                  "an end below this error [m] counts as convergence, without a restart");
      list.choice("bounds", bounds, {{"initial", Limits::initial}, {"clamp", Limits::clamp}, {"wrap", Limits::wrap}},
                  "joint limits apply to the initial candidate only, or all are clamped to them, or a joint that turns "
                  "is first turned back inside by whole turns");
    }
  };

  explicit Newton(Options options) : options_(options) {}

  void start(const Problem& problem, Objective& objective, Random&) override {
    problem_ = problem;
    jacobian_.resize(objective.rows(), problem.joints());
    q_ = problem.start;
    turns_.resize(q_.size());
    for (Eigen::Index j = 0; j < q_.size(); ++j) {
      turns_[j] = objective.arm().links()[static_cast<std::size_t>(j)].joint == Joint::turns;
    }
    limit(q_);
    best_ = {problem.start};
    is_stuck_ = false;
    arrive(objective);
  }

  void step(Objective& objective, Random& random) override {
    if (finished()) return;
    if (is_stuck_) {
      draw_one_within_limits(problem_, random, q_);
      is_stuck_ = false;
    } else {
      const Configuration before = q_;
      q_ += objective.rows() == 3 ? pseudo_inverse_times<3>(jacobian_, to_go_, options_.singular)
                                  : pseudo_inverse_times<6>(jacobian_, to_go_, options_.singular);
      limit(q_);
      if (!q_.allFinite()) {
        q_ = before;
        is_stuck_ = true;
        return;
      }
      is_stuck_ = (q_ - before).cwiseAbs().maxCoeff() <= options_.small_move;
    }
    arrive(objective);
  }

  const Best& best() const override { return best_; }
  bool finished() const override {
    return is_stuck_ && (options_.restarts == Restarts::none || best_.error <= options_.small_error);
  }

 private:
  void limit(Configuration& q) const {
    if (options_.bounds == Limits::initial) return;
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const double lower = problem_.lower[j], upper = problem_.upper[j];
      if (options_.bounds == Limits::wrap && turns_[j]) q[j] = turned_inside(q[j], lower, upper);
      q[j] = std::clamp(q[j], lower, upper);
    }
  }

  void arrive(Objective& objective) {
    best_.improve(q_, objective.error(q_));
    // The units decide what counts as singular.
    to_go_ = linearize_twist(objective, q_, jacobian_);
  }

  Options options_;
  Problem problem_;
  Configuration q_;
  Eigen::Array<bool, Eigen::Dynamic, 1, 0, most_joints, 1> turns_;  // false: slides
  Eigen::MatrixXd jacobian_;
  Residual to_go_;
  bool is_stuck_ = false;
  Best best_;
};

}  // namespace

SolverInfo newton() {
  return solver_info<Newton>("newton", "Newton-Raphson with the pseudo-inverse, clipped at the limits, with restarts",
                             "KDL, ChainIkSolverPos_NR_JL; Beeson and Ames 2015");
}

}  // namespace ikbench::solvers
