// IK-BA, the bat algorithm for inverse kinematics: Slim et al. 2023, Algorithm 2.
// Every candidate is drawn between the best configuration and the arm's (Eq. 14), so Eqs. 5, 13 and 7 move the bats
// without any effect on the result (docs/papers/slim2023-notes.md 2.4). They are kept as in the paper.
#include "base/units.hpp"
#include "numerics/functions.hpp"
#include "solvers/bounds.hpp"
#include "solvers/kernels.hpp"
#include "solvers/registry.hpp"

namespace ikbench::solvers {

using namespace numerics;

namespace {

class IkBat final : public Searcher {
 public:
  enum class Acceptance { greedy, loudness, yang2020 };
  enum class Epsilon { normal, truncated, uniform };
  enum class Pulse { rising, constant };

  struct Options {
    double f_min = 0;
    double f_max = 2;
    double alpha = 0.97;
    double gamma = 0.1;
    double loudness = 1;
    double pulse_rate = 1;
    double step_factor = 0.1;
    Epsilon epsilon = Epsilon::normal;
    Pulse pulse = Pulse::rising;
    int first_iteration = 0;
    bool seeded = true;
    double spread_deg = 0;
    Acceptance acceptance = Acceptance::greedy;
    Bounds bounds = Bounds::initial;

    void list(OptionList& list) {
      list.number("f_min", f_min, {0, 10}, "smallest frequency, Eq. 5");
      list.number("f_max", f_max, {0, 10}, "largest frequency, Eq. 5");
      list.number("alpha", alpha, {0, 1}, "the loudness is multiplied by this in every iteration, Eq. 9");
      list.number("gamma", gamma, {0, 10}, "growth rate of the pulse rate, Eq. 10");
      list.number("loudness", loudness, {0, 10}, "initial loudness A");
      list.number("pulse_rate", pulse_rate, {0, 1}, "final pulse rate r0, Eq. 10");
      list.number("step_factor", step_factor, {0, 10},
                  "factor of eps A in Eq. 14; 0.1 in Yang's code, not given in the paper");
      list.choice("epsilon", epsilon,
                  {{"normal", Epsilon::normal}, {"truncated", Epsilon::truncated}, {"uniform", Epsilon::uniform}},
                  "eps in Eq. 14, \"in the range of [-1, 1] generated from a normal distribution\": standard normal "
                  "(Yang's code), normal within [-1, 1], or uniform in [-1, 1]");
      list.choice(
          "acceptance", acceptance,
          {{"greedy", Acceptance::greedy}, {"loudness", Acceptance::loudness}, {"yang2020", Acceptance::yang2020}},
          "a better candidate is always kept, only if rand < A (the paper's text), or only if rand > A (Yang 2020)");
      list_bounds(list, bounds);
      list.later();
      list.choice("pulse", pulse, {{"rising", Pulse::rising}, {"constant", Pulse::constant}},
                  "the pulse rate rises to r0 (Eq. 10), or is always r0 (Table 1: \"initial pulse rate\" 1)");
      list.count("first_iteration", first_iteration, {0, 1},
                 "t of the first iteration in Eq. 10, which does not say; with 0 the first pulse rate is 0");
      list.choice("seeded", seeded, {{"yes", true}, {"no", false}},
                  "one bat starts at Theta_s (Sec. 4.2: \"preferable\"), or none does (Algorithm 2)");
      list.number("spread_deg", spread_deg, {0, 180},
                  "standard deviation of the first bats around Theta_s; 0: they are uniform between the limits");
    }
  };

  explicit IkBat(Options options) : options_(options) {}

  void start(const Problem& problem, Objective& objective, Random& random) override {
    take(problem);
    const int bats = problem.population;
    for (Candidates* each : {&x_, &v_, &x_next_, &v_next_, &candidates_, &epsilon_}) {
      each->resize(problem.joints(), bats);
    }
    for (Eigen::RowVectorXd* each : {&frequency_, &chance_}) each->resize(bats);
    errors_.resize(bats);
    loudness_ = options_.loudness;
    iteration_ = options_.first_iteration;

    draw_first(random);
    v_.setZero();
    evaluate_all(objective, x_, errors_);
  }

  void step(Objective& objective, Random& random) override {
    random.uniforms(frequency_);
    draw_epsilon(random);
    random.uniforms(chance_);
    frequency_ = options_.f_min + (options_.f_max - options_.f_min) * frequency_.array();  // Eq. 5
    loudness_ *= options_.alpha;                                                           // Eq. 9
    pulse_rate_ = options_.pulse_rate;
    if (options_.pulse == Pulse::rising) pulse_rate_ *= 1 - exponential(-options_.gamma * iteration_);  // Eq. 10
    ++iteration_;
    objective.one_by_one(
        candidates_, errors_, [&](Eigen::Index first, Eigen::Index count) { fly(first, count); },
        [&](Eigen::Index i) {
          if (!(errors_[i] < best_.error) || !accepts(chance_[i])) return false;
          best_.improve(candidates_.col(i), errors_[i]);
          x_next_.col(i) = candidates_.col(i);
          return true;
        });
    x_.swap(x_next_);
    v_.swap(v_next_);
  }

 private:
  void draw_first(Random& random) {
    if (options_.spread_deg > 0) {
      random.normals(x_);
      for (Eigen::Index j = 0; j < x_.rows(); ++j)
        kernels_.scatter(problem_.start[j], options_.spread_deg * base::degree, &x_(j, 0), &x_(j, 0), x_.cols());
    } else {
      draw_within_limits(problem_, random, x_);
    }
    if (options_.seeded) x_.col(0) = problem_.start;
    keep_inside(options_.bounds, problem_, x_);
  }

  void draw_epsilon(Random& random) {
    if (options_.epsilon == Epsilon::normal) return random.normals(epsilon_);
    if (options_.epsilon == Epsilon::truncated) return random.truncated_normals(epsilon_);
    random.uniforms(epsilon_);
    epsilon_.array() = 2 * epsilon_.array() - 1;
  }

  void fly(Eigen::Index first, Eigen::Index count) {
    const double r = pulse_rate_;
    for (Eigen::Index j = 0; j < x_.rows(); ++j) {
      const double best = best_.q[j], theta_s = problem_.start[j];
      // Eq. 13: V <- V + (X - (X_best + Theta_s) / 2) f;  Eq. 7: X <- X + V
      kernels_.fly({.pole = 0.5 * (best + theta_s),
                    .frequency = &frequency_[first],
                    .x = &x_(j, first),
                    .v = &v_(j, first),
                    .x_next = &x_next_(j, first),
                    .v_next = &v_next_(j, first),
                    .count = count});
      // Eq. 14: X_new = r X_best + (1 - r) Theta_s + eps A, here with step_factor A (docs/papers/slim2023-notes.md 2.4)
      kernels_.scatter(r * best + (1 - r) * theta_s, options_.step_factor * loudness_, &epsilon_(j, first),
                       &candidates_(j, first), count);
    }
    keep_inside(options_.bounds, problem_, candidates_.middleCols(first, count));
  }

  bool accepts(double chance) const {
    if (options_.acceptance == Acceptance::greedy) return true;
    return options_.acceptance == Acceptance::loudness ? chance < loudness_ : chance > loudness_;
  }

  Options options_;
  const Kernels& kernels_ = kernels();
  Candidates x_, v_, x_next_, v_next_, candidates_, epsilon_;
  Eigen::RowVectorXd frequency_, chance_;
  Eigen::VectorXd errors_;
  double loudness_ = 0, pulse_rate_ = 0;
  int iteration_ = 0;
};

}  // namespace

SolverInfo ik_bat() {
  return solver_info<IkBat>("ik_bat", "bat algorithm for inverse kinematics (IK-BA)", "Slim et al. 2023, Algorithm 2",
                            1);
}

}  // namespace ikbench::solvers
