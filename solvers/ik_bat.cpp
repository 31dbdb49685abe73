// IK-BA, the bat algorithm for inverse kinematics: Slim et al. 2023, Algorithm 2.
// Every candidate is drawn between the best configuration and the one the arm is in (Eq. 14), so Eqs. 5, 13 and 7 move
// the bats without any effect on the result (docs/paper-notes.md 2.4); they are kept as the paper has them.
#include <cmath>

#include "solvers/bounds.hpp"
#include "solvers/registry.hpp"

namespace ikbench {

namespace {

class IkBat final : public Solver {
 public:
  enum class Acceptance { greedy, loudness, yang2020 };

  struct Options {
    double f_min = 0;
    double f_max = 2;
    double alpha = 0.97;
    double gamma = 0.1;
    double loudness = 1;
    double pulse_rate = 1;
    double step_factor = 0.1;
    Acceptance acceptance = Acceptance::greedy;
    Bounds bounds = Bounds::initial;

    void list(OptionList& list) {
      list.number("f_min", f_min, {0, 10}, "smallest frequency, Eq. 5");
      list.number("f_max", f_max, {0, 10}, "largest frequency, Eq. 5");
      list.number("alpha", alpha, {0, 1}, "factor of the loudness an iteration, Eq. 9");
      list.number("gamma", gamma, {0, 10}, "growth of the pulse rate, Eq. 10");
      list.number("loudness", loudness, {0, 10}, "initial loudness A");
      list.number("pulse_rate", pulse_rate, {0, 1}, "final pulse rate r0, Eq. 10");
      list.number("step_factor", step_factor, {0, 10}, "factor of eps A in Eq. 14; 0.1 in Yang's code, not printed");
      list.choice(
          "acceptance", acceptance,
          {{"greedy", Acceptance::greedy}, {"loudness", Acceptance::loudness}, {"yang2020", Acceptance::yang2020}},
          "a better candidate is kept always, if rand < A (the paper's text), or if rand > A (Yang 2020)");
      list_bounds(list, bounds);
    }
  };

  explicit IkBat(Options options) : options_(options) {}

  void start(const Problem& problem, Objective& objective, Random& random) override {
    problem_ = problem;
    const int bats = problem.population;
    x_.resize(problem.joints(), bats);
    v_.setZero(problem.joints(), bats);
    epsilon_.resize(problem.joints(), bats);
    errors_.resize(bats);
    beta_.resize(bats);
    chance_.resize(bats);
    candidate_.resize(problem.joints());
    loudness_ = options_.loudness;
    iteration_ = 0;
    best_ = {problem.start};

    draw_within_limits(problem, random, x_);
    x_.col(0) = problem.start;  // one bat starts where the arm is
    keep_inside(options_.bounds, problem_, x_.col(0));
    objective.errors(x_, errors_);
    for (int i = 0; i < bats; ++i) best_.improve(x_.col(i), errors_[i]);
  }

  void step(Objective& objective, Random& random) override {
    const Eigen::VectorXd& theta_s = problem_.start;
    random.uniforms(beta_);
    random.normals(epsilon_);
    random.uniforms(chance_);
    loudness_ *= options_.alpha;                                                          // Eq. 9
    const double r = options_.pulse_rate * (1 - std::exp(-options_.gamma * iteration_));  // Eq. 10; first r is 0
    ++iteration_;
    for (Eigen::Index i = 0; i < x_.cols(); ++i) {
      const double f = options_.f_min + (options_.f_max - options_.f_min) * beta_[i];                     // Eq. 5
      v_.col(i) += (x_.col(i) - 0.5 * (best_.q + theta_s)) * f;                                           // Eq. 13
      x_.col(i) += v_.col(i);                                                                             // Eq. 7
      candidate_ = r * best_.q + (1 - r) * theta_s + options_.step_factor * loudness_ * epsilon_.col(i);  // Eq. 14
      keep_inside(options_.bounds, problem_, candidate_);
      const double error = objective.error(candidate_);
      if (accepts(chance_[i]) && best_.improve(candidate_, error)) x_.col(i) = candidate_;
    }
  }

  const Best& best() const override { return best_; }

 private:
  bool accepts(double chance) const {
    switch (options_.acceptance) {
      case Acceptance::loudness:
        return chance < loudness_;
      case Acceptance::yang2020:
        return chance > loudness_;
      case Acceptance::greedy:
        break;
    }
    return true;
  }

  Options options_;
  Problem problem_;
  Candidates x_, v_, epsilon_;
  Eigen::VectorXd errors_, beta_, chance_, candidate_;
  double loudness_ = 0;
  int iteration_ = 0;
  Best best_;
};

}  // namespace

SolverInfo ik_bat() {
  return solver_info<IkBat>("ik_bat", "bat algorithm for inverse kinematics (IK-BA)", "Slim et al. 2023, Algorithm 2");
}

}  // namespace ikbench
