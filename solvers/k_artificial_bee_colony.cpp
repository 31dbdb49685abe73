// K-ABC, the artificial bee colony of Karaboga 2005 with the best source as everyone's neighbour: El-Sherbiny,
// Elhosseini and Haikal 2018. The reading is argued in docs/paper-notes.md 2.7.
#include <algorithm>
#include <cmath>

#include "solvers/bounds.hpp"
#include "solvers/registry.hpp"

namespace ikbench {

namespace {

class KArtificialBeeColony final : public Solver {
 public:
  enum class Colony { full, half };
  enum class Neighbour { best, random };
  enum class FitnessUnit { cm, m };

  struct Options {
    Colony colony = Colony::full;
    Neighbour neighbour = Neighbour::best;
    int limit = 0;
    FitnessUnit fitness_unit = FitnessUnit::cm;  // the paper's unit; in metres all sources would be nearly alike
    // By evidence (docs/paper-notes.md 2.7): clamped 0.21 cm and 268 deg, unclamped 0.24 and 336 with a quarter of the
    // answers outside the limits; printed 0.23 and 277.
    Bounds bounds = Bounds::clamp;

    void list(OptionList& list) {
      list.choice("colony", colony, {{"full", Colony::full}, {"half", Colony::half}},
                  "a population of N has N sources and N onlookers, or half of each");
      list.choice("neighbour", neighbour, {{"best", Neighbour::best}, {"random", Neighbour::random}},
                  "a source is compared with the best one (K-ABC) or with any (plain ABC)");
      list.count("limit", limit, {0, 1000000}, "failures after which a source is given up; 0: (N + joints) / 2");
      list.choice("fitness_unit", fitness_unit, {{"cm", FitnessUnit::cm}, {"m", FitnessUnit::m}},
                  "unit of the error f in the roulette's 1 / (1 + f)");
      list_bounds(list, bounds);
    }
  };

  explicit KArtificialBeeColony(Options options) : options_(options) {}

  void start(const Problem& problem, Objective& objective, Random& random) override {
    problem_ = problem;
    const int sources = options_.colony == Colony::full ? problem.population : std::max(1, problem.population / 2);
    limit_ = options_.limit > 0 ? options_.limit : (problem.population + problem.joints()) / 2;
    x_.resize(problem.joints(), sources);
    for (Eigen::VectorXd* each : {&errors_, &joint_, &neighbour_, &phi_, &roulette_, &cumulative_}) {
      each->resize(sources);
    }
    failures_.setZero(sources);
    candidate_.resize(problem.joints());
    best_ = {problem.start};

    draw_within_limits(problem, random, x_);
    objective.errors(x_, errors_);
    for (int i = 0; i < sources; ++i) best_.improve(x_.col(i), errors_[i]);
    find_best_source();
  }

  void step(Objective& objective, Random& random) override {
    const Eigen::Index sources = x_.cols();
    draw_searches(random);
    for (Eigen::Index bee = 0; bee < sources; ++bee) search(bee, bee, objective);  // employed bees

    draw_searches(random);
    random.uniforms(roulette_);
    spin_up();
    for (Eigen::Index bee = 0; bee < sources; ++bee) search(bee, source_at(roulette_[bee]), objective);  // onlookers

    for (Eigen::Index i = 0; i < sources; ++i) {  // scouts
      if (failures_[i] <= limit_) continue;
      for (Eigen::Index j = 0; j < x_.rows(); ++j) x_(j, i) = random.uniform(problem_.lower[j], problem_.upper[j]);
      errors_[i] = objective.error(x_.col(i));
      failures_[i] = 0;
      best_.improve(x_.col(i), errors_[i]);
    }
    find_best_source();
  }

  const Best& best() const override { return best_; }

 private:
  void draw_searches(Random& random) {
    random.uniforms(joint_);
    random.uniforms(phi_);
    if (options_.neighbour == Neighbour::random) random.uniforms(neighbour_);
  }

  // A bee tries source i with one joint moved along the difference to its neighbour.
  void search(Eigen::Index bee, Eigen::Index i, Objective& objective) {
    const auto j = static_cast<Eigen::Index>(joint_[bee] * static_cast<double>(x_.rows()));
    const Eigen::Index k = options_.neighbour == Neighbour::best ? best_source_ : other_source(i, neighbour_[bee]);
    const double phi = 2 * phi_[bee] - 1;
    candidate_ = x_.col(i);
    candidate_[j] += phi * (k == i ? x_(j, i) : x_(j, i) - x_(j, k));
    keep_inside(options_.bounds, problem_, candidate_);
    const double error = objective.error(candidate_);
    if (error < errors_[i]) {
      x_.col(i) = candidate_;
      errors_[i] = error;
      failures_[i] = 0;
      if (!(errors_[best_source_] <= error)) best_source_ = i;
      best_.improve(candidate_, error);
    } else {
      ++failures_[i];
    }
  }

  void find_best_source() {
    best_source_ = 0;
    for (Eigen::Index i = 1; i < errors_.size(); ++i) {
      if (errors_[i] < errors_[best_source_]) best_source_ = i;
    }
  }

  // Any source but i; a single source has no other.
  Eigen::Index other_source(Eigen::Index i, double chance) const {
    const Eigen::Index others = x_.cols() - 1;
    const auto k = static_cast<Eigen::Index>(chance * static_cast<double>(others));
    return others > 0 && k >= i ? k + 1 : k;
  }

  // The roulette: a source's share is 1 / (1 + f); one whose error is no number has none.
  void spin_up() {
    const double unit = options_.fitness_unit == FitnessUnit::cm ? 0.01 : 1;  // [m]
    double sum = 0;
    for (Eigen::Index i = 0; i < errors_.size(); ++i) {
      if (std::isfinite(errors_[i])) sum += 1 / (1 + errors_[i] / unit);
      cumulative_[i] = sum;
    }
  }

  Eigen::Index source_at(double chance) const {
    const Eigen::Index last = cumulative_.size() - 1;
    const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end(), chance * cumulative_[last]);
    return std::min<Eigen::Index>(found - cumulative_.begin(), last);
  }

  Options options_;
  Problem problem_;
  int limit_ = 0;
  Candidates x_;
  Eigen::VectorXd errors_, joint_, neighbour_, phi_, roulette_, cumulative_, candidate_;
  Eigen::VectorXi failures_;
  Eigen::Index best_source_ = 0;  // of those there are now; best_ is the best there ever was
  Best best_;
};

}  // namespace

SolverInfo k_artificial_bee_colony() {
  return solver_info<KArtificialBeeColony>("k_artificial_bee_colony", "artificial bee colony towards the best (K-ABC)",
                                           "El-Sherbiny, Elhosseini and Haikal 2018; Karaboga 2005");
}

}  // namespace ikbench
