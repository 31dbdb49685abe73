// PSO, particle swarm optimisation: Kennedy and Eberhart 1995 with the inertia of Shi and Eberhart 1998; the numbers
// are those of Slim et al. 2023, Table 1. docs/papers/slim2023-notes.md 2.5 argues for this reading.
#include "solvers/bounds.hpp"
#include "solvers/kernels.hpp"
#include "solvers/registry.hpp"

namespace ikbench::solvers {

namespace {

class ParticleSwarm final : public Searcher {
 public:
  enum class Coefficients { permuted, exchanged, as_printed };
  enum class Draws { per_joint, per_particle };
  enum class BestUpdate { at_once, generation };

  struct Options {
    double inertia = 0.53514;
    double cognitive = 1.1312;
    double social = 2.0149;
    double damping = 1;
    double velocity_limit = 0;
    Coefficients coefficients = Coefficients::permuted;
    Draws random = Draws::per_joint;
    BestUpdate best_update = BestUpdate::at_once;
    Bounds bounds = Bounds::clamp;

    void list(OptionList& list) {
      list.number("inertia", inertia, {0, 10}, "w, weight of the previous velocity");
      list.number("cognitive", cognitive, {0, 10}, "c1, weight of a particle's own best");
      list.number("social", social, {0, 10}, "c2, weight of the swarm's best");
      list.number("damping", damping, {0, 1}, "the inertia is multiplied by this after every iteration");
      list.number("velocity_limit", velocity_limit, {0, 10},
                  "largest velocity, as a part of a joint's range; 0: no limit");
      list.choice(
          "coefficients", coefficients,
          {{"permuted", Coefficients::permuted},
           {"exchanged", Coefficients::exchanged},
           {"as_printed", Coefficients::as_printed}},
          "use the three numbers by name; with c1 and c2 exchanged, so that of Table 1 only w and c2 are; or as "
          "Table 1 labels them: w = cognitive, c1 = social, c2 = inertia (diverges unless the inertia is "
          "damped)");
      list.choice("bounds", bounds,
                  {{"initial", Bounds::initial}, {"clamp", Bounds::clamp}, {"resample", Bounds::resample}},
                  "joint limits apply to the initial candidates only, or a joint outside is clamped, or drawn again");
      list.later();
      list.choice("random", random, {{"per_joint", Draws::per_joint}, {"per_particle", Draws::per_particle}},
                  "the two random numbers of the velocity are drawn for each joint, or for each particle; not given in "
                  "the paper");
      list.choice("best_update", best_update,
                  {{"at_once", BestUpdate::at_once}, {"generation", BestUpdate::generation}},
                  "a better particle leads the next one already, or the next iteration; not given in the paper");
    }

    static void use(Settings& of) {  // as the constructor does
      const std::string by = text_of(of.at("coefficients"));
      if (by != "permuted") std::swap(of.at("cognitive"), of.at("social"));
      if (by == "as_printed") std::swap(of.at("social"), of.at("inertia"));
      of.erase("coefficients");
    }
  };

  explicit ParticleSwarm(Options options) : options_(options) {
    if (options.coefficients == Coefficients::as_printed) {
      options_.inertia = options.cognitive;
      options_.cognitive = options.social;
      options_.social = options.inertia;
    }
    if (options.coefficients == Coefficients::exchanged) std::swap(options_.cognitive, options_.social);
  }

  void start(const Problem& problem, Objective& objective, Random& random) override {
    take(problem);
    inertia_ = options_.inertia;
    const int particles = problem.population;
    for (Candidates* each : {&x_, &v_, &x_next_, &v_next_, &fresh_}) each->resize(problem.joints(), particles);
    const int drawn = options_.random == Draws::per_joint ? problem.joints() : 1;
    for (Candidates* each : {&u1_, &u2_}) each->resize(drawn, particles);
    for (Eigen::VectorXd* each : {&errors_, &found_}) each->resize(particles);

    draw_within_limits(problem, random, x_);
    v_.setZero();
    personal_ = x_;
    evaluate_all(objective, x_, errors_);
  }

  void step(Objective& objective, Random& random) override {
    random.uniforms(u1_);
    random.uniforms(u2_);
    if (options_.bounds == Bounds::resample) draw_within_limits(problem_, random, fresh_);
    objective.one_by_one(
        x_next_, found_, [&](Eigen::Index first, Eigen::Index count) { fly(first, count); },
        [&](Eigen::Index i) {
          if (found_[i] < errors_[i]) {
            personal_.col(i) = x_next_.col(i);
            errors_[i] = found_[i];
          }
          return options_.best_update == BestUpdate::at_once && best_.improve(x_next_.col(i), found_[i]);
        });
    for (Eigen::Index i = 0; i < found_.size() && options_.best_update == BestUpdate::generation; ++i)
      best_.improve(x_next_.col(i), found_[i]);
    inertia_ *= options_.damping;
    x_.swap(x_next_);
    v_.swap(v_next_);
  }

 private:
  void fly(Eigen::Index first, Eigen::Index count) {
    for (Eigen::Index j = 0; j < x_.rows(); ++j) {
      const Eigen::Index draw = std::min(j, u1_.rows() - 1);
      // Shi and Eberhart 1998: v <- w v + c1 u1 (personal best - x) + c2 u2 (best - x);  x <- x + v
      kernels_.swarm({.inertia = inertia_,
                      .cognitive = options_.cognitive,
                      .social = options_.social,
                      .best = best_.q[j],
                      .x = &x_(j, first),
                      .v = &v_(j, first),
                      .personal = &personal_(j, first),
                      .u1 = &u1_(draw, first),
                      .u2 = &u2_(draw, first),
                      .x_next = &x_next_(j, first),
                      .v_next = &v_next_(j, first),
                      .count = count});
      if (options_.velocity_limit > 0) slow_down(j, first, count);
    }
    auto flown = x_next_.middleCols(first, count);
    keep_inside(options_.bounds, problem_, flown);
    if (options_.bounds == Bounds::resample) draw_outside_again(problem_, fresh_, first, flown);
  }

  void slow_down(Eigen::Index j, Eigen::Index first, Eigen::Index count) {
    const DrawnFrom range(problem_, j);
    const double most = options_.velocity_limit * (range.upper - range.lower);
    auto v = v_next_.row(j).segment(first, count);
    v = v.cwiseMax(-most).cwiseMin(most);
    x_next_.row(j).segment(first, count) = x_.row(j).segment(first, count) + v;
  }

  Options options_;
  double inertia_ = 0;
  const Kernels& kernels_ = kernels();
  Candidates x_, v_, x_next_, v_next_, personal_, u1_, u2_, fresh_;
  Eigen::VectorXd errors_, found_;  // errors of the personal bests; of x_next_
};

}  // namespace

SolverInfo particle_swarm() {
  return solver_info<ParticleSwarm>("particle_swarm", "particle swarm optimisation (PSO)",
                                    "Kennedy and Eberhart 1995; Shi and Eberhart 1998", 1);
}

}  // namespace ikbench::solvers
