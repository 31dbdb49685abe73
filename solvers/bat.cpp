// BA, the bat algorithm: Yang 2010, with the parameters of Slim et al. 2023, Algorithm 1 and Table 1.
// The reading is argued in docs/paper-notes.md 2.6.
#include <cmath>

#include "solvers/bounds.hpp"
#include "solvers/registry.hpp"

namespace ikbench {

namespace {

class Bat final : public Solver {
 public:
  enum class BestOf { accepted, evaluated };

  struct Options {
    double f_min = 0;
    double f_max = 2;
    double alpha = 0.5;
    double gamma = 0.5;
    double pulse_rate = 0.001;
    double step_factor = 0.1;
    BestOf best_of = BestOf::accepted;
    Bounds bounds = Bounds::clamp;

    void list(OptionList& list) {
      list.number("f_min", f_min, {0, 10}, "smallest frequency, Eq. 5");
      list.number("f_max", f_max, {0, 10}, "largest frequency, Eq. 5");
      list.number("alpha", alpha, {0, 1}, "factor of a bat's loudness when it accepts, Eq. 9");
      list.number("gamma", gamma, {0, 10}, "growth of a bat's pulse rate, Eq. 10");
      list.number("pulse_rate", pulse_rate, {0, 1}, "pulse rate r0, Eq. 10");
      list.number("step_factor", step_factor, {0, 10}, "factor of eps A in Eq. 8; 0.1 in Yang's code, not printed");
      list.choice("best_of", best_of, {{"accepted", BestOf::accepted}, {"evaluated", BestOf::evaluated}},
                  "the best is taken from the accepted candidates, or from all evaluated ones");
      list_bounds(list, bounds);
    }
  };

  explicit Bat(Options options) : options_(options) {}

  void start(const Problem& problem, Objective& objective, Random& random) override {
    problem_ = problem;
    const int bats = problem.population;
    x_.resize(problem.joints(), bats);
    v_.setZero(problem.joints(), bats);
    epsilon_.resize(problem.joints(), bats);
    errors_.resize(bats);
    loudness_.resize(bats);
    pulse_rate_.setConstant(bats, options_.pulse_rate);
    for (Eigen::VectorXd* draws : {&beta_, &local_, &chance_}) draws->resize(bats);
    candidate_.resize(problem.joints());
    iteration_ = 0;
    best_ = {problem.start};

    draw_within_limits(problem, random, x_);
    random.uniforms(loudness_);  // Table 1: A_i random in [0, 1]
    objective.errors(x_, errors_);
    for (int i = 0; i < bats; ++i) best_.improve(x_.col(i), errors_[i]);
  }

  void step(Objective& objective, Random& random) override {
    random.uniforms(beta_);
    random.uniforms(local_);
    random.normals(epsilon_);
    random.uniforms(chance_);
    ++iteration_;
    for (Eigen::Index i = 0; i < x_.cols(); ++i) {
      const double f = options_.f_min + (options_.f_max - options_.f_min) * beta_[i];  // Eq. 5
      v_.col(i) += (x_.col(i) - best_.q) * f;                                          // Eq. 6
      candidate_ = x_.col(i) + v_.col(i);                                              // Eq. 7
      if (local_[i] > pulse_rate_[i]) {
        candidate_ = best_.q + options_.step_factor * loudness_.mean() * epsilon_.col(i);  // Eq. 8
      }
      keep_inside(options_.bounds, problem_, candidate_);
      const double error = objective.error(candidate_);
      const bool accepted = error <= errors_[i] && chance_[i] < loudness_[i];
      if (accepted) {
        x_.col(i) = candidate_;
        errors_[i] = error;
        loudness_[i] *= options_.alpha;                                                       // Eq. 9
        pulse_rate_[i] = options_.pulse_rate * (1 - std::exp(-options_.gamma * iteration_));  // Eq. 10
      }
      if (accepted || options_.best_of == BestOf::evaluated) best_.improve(candidate_, error);
    }
  }

  const Best& best() const override { return best_; }

 private:
  Options options_;
  Problem problem_;
  Candidates x_, v_, epsilon_;
  Eigen::VectorXd errors_, loudness_, pulse_rate_, beta_, local_, chance_, candidate_;
  int iteration_ = 0;
  Best best_;
};

}  // namespace

SolverInfo bat() { return solver_info<Bat>("bat", "bat algorithm (BA)", "Yang 2010; Slim et al. 2023, Algorithm 1"); }

}  // namespace ikbench
