// K-ABC, the artificial bee colony of Karaboga 2005 with the best source as everyone's neighbour: El-Sherbiny,
// Elhosseini and Haikal 2018. docs/papers/slim2023-notes.md 2.7 argues for this reading.
#include <algorithm>
#include <cmath>

#include "base/units.hpp"
#include "solvers/bounds.hpp"
#include "solvers/registry.hpp"
#include "solvers/roulette.hpp"

namespace ikbench::solvers {

namespace {

class KArtificialBeeColony final : public Searcher {
 public:
  enum class Colony { full, half };
  enum class Neighbour { best, random };
  enum class BestSource { abandoned, spared };
  enum class BestNeighbour { origin, random, itself };
  enum class FitnessUnit { cm, m };

  struct Options {
    Colony colony = Colony::full;
    Neighbour neighbour = Neighbour::best;
    BestNeighbour best_neighbour = BestNeighbour::origin;
    int limit = 0;
    BestSource best_source = BestSource::abandoned;
    FitnessUnit fitness_unit = FitnessUnit::cm;  // the paper's unit; in metres all sources would be nearly alike
    // Chosen by evidence (docs/papers/slim2023-notes.md 2.7): clamped 0.21 cm and 268 deg; unclamped 0.24 cm and 336
    // deg, with a quarter of the answers outside the limits; printed 0.23 cm and 277 deg.
    Bounds bounds = Bounds::clamp;

    void list(OptionList& list) {
      list.choice("colony", colony, {{"full", Colony::full}, {"half", Colony::half}},
                  "a population of N has N sources and N onlookers, or N/2 of each");
      list.choice("neighbour", neighbour, {{"best", Neighbour::best}, {"random", Neighbour::random}},
                  "a source is compared with the best one (K-ABC), or with a random one (plain ABC)");
      list.count("limit", limit, {0, 1000000}, "a source is abandoned after this many failures; 0: (N + joints) / 2");
      list.choice("fitness_unit", fitness_unit, {{"cm", FitnessUnit::cm}, {"m", FitnessUnit::m}},
                  "unit of the error f in the roulette's 1 / (1 + f)");
      list_bounds(list, bounds);
      list.later();
      list.choice(
          "best_neighbour", best_neighbour,
          {{"origin", BestNeighbour::origin}, {"random", BestNeighbour::random}, {"itself", BestNeighbour::itself}},
          "the best source, its own neighbour by that rule, is compared with all joints at 0, with a random one, "
          "or with itself, so that it stays; not given in the paper");
      list.choice("best_source", best_source, {{"abandoned", BestSource::abandoned}, {"spared", BestSource::spared}},
                  "the best source is abandoned like any other, or never; not given in the paper");
    }
  };

  explicit KArtificialBeeColony(Options options)
      : options_(options),
        is_random_(options.neighbour == Neighbour::random || options.best_neighbour == BestNeighbour::random) {}

  void start(const Problem& problem, Objective& objective, Random& random) override {
    take(problem);
    const int sources = options_.colony == Colony::full ? problem.population : std::max(1, problem.population / 2);
    limit_ = options_.limit > 0 ? options_.limit : (problem.population + problem.joints()) / 2;
    for (Candidates* each : {&x_, &candidates_}) each->resize(problem.joints(), sources);
    for (Eigen::VectorXd* each : {&errors_, &found_, &joint_, &neighbour_, &phi_, &roulette_}) {
      each->resize(sources);
    }
    for (auto* each : {&source_, &moved_by_}) each->resize(sources);
    share_.reserve(static_cast<std::size_t>(sources));
    failures_.setZero(sources);

    draw_within_limits(problem, random, x_);
    evaluate_all(objective, x_, errors_);
    find_best_source();
  }

  void step(Objective& objective, Random& random) override {
    const Eigen::Index sources = x_.cols();
    draw_searches(random);
    for (Eigen::Index bee = 0; bee < sources; ++bee) source_[bee] = bee;
    search(Bees::employed, objective);

    draw_searches(random);
    random.uniforms(roulette_);
    spin_up();
    share_.pick(sources, roulette_.data(), source_.data());
    search(Bees::onlookers, objective);

    for (Eigen::Index i = 0; i < sources; ++i) {  // scouts
      if (failures_[i] <= limit_ || (i == best_source_ && options_.best_source == BestSource::spared)) continue;
      draw_one_within_limits(problem_, random, x_.col(i));
      errors_[i] = objective.error(x_.col(i));
      failures_[i] = 0;
      best_.improve(x_.col(i), errors_[i]);
    }
    find_best_source();
  }

 private:
  enum class Bees { employed, onlookers };

  void draw_searches(Random& random) {
    random.uniforms(joint_);
    random.uniforms(phi_);
    if (is_random_) random.uniforms(neighbour_);
  }

  // Lets every bee try its source.
  void search(Bees bees, Objective& objective) {
    moved_by_.setConstant(-1);
    Eigen::Index proposed_from = 0;
    objective.one_by_one(
        candidates_, found_,
        [&](Eigen::Index first, Eigen::Index count) {
          proposed_from = first;
          fly(bees, first, count);
        },
        [&](Eigen::Index bee) {
          const Eigen::Index i = source_[bee];
          ++failures_[i];
          if (!(found_[bee] < errors_[i])) return false;
          x_.col(i) = candidates_.col(bee);
          errors_[i] = found_[bee];
          failures_[i] = 0;
          moved_by_[i] = bee;
          if (!(errors_[best_source_] <= errors_[i])) best_source_ = i;
          best_.improve(candidates_.col(bee), found_[bee]);
          return i == best_source_ || is_random_;
        },
        [&](Eigen::Index bee) {
          const bool is_stale = moved_by_[source_[bee]] >= proposed_from;
          if (is_stale) fly(bees, bee, 1);
          return is_stale;
        });
  }

  // Moves, for each bee, one joint j of its source i along the difference to the source's neighbour.
  void fly(Bees bees, Eigen::Index first, Eigen::Index count) {
    for (Eigen::Index j = 0; j < x_.rows(); ++j) {
      if (bees == Bees::employed) {
        std::copy_n(&x_(j, first), count, &candidates_(j, first));
        continue;
      }
#pragma GCC unroll 8
      for (Eigen::Index bee = first; bee < first + count; ++bee) candidates_(j, bee) = x_(j, source_[bee]);
    }
    for (Eigen::Index bee = first; bee < first + count; ++bee) {
      const Eigen::Index i = source_[bee];
      const auto j = static_cast<Eigen::Index>(joint_[bee] * static_cast<double>(x_.rows()));
      const double q = x_(j, i), phi = 2 * phi_[bee] - 1;
      const double moved = q + phi * (q - neighbour(j, i, bee));
      candidates_(j, bee) =
          options_.bounds == Bounds::clamp ? std::clamp(moved, problem_.lower[j], problem_.upper[j]) : moved;
    }
  }

  // Returns the angle of joint j in the neighbour of source i.
  double neighbour(Eigen::Index j, Eigen::Index i, Eigen::Index bee) const {
    if (options_.neighbour == Neighbour::best && i != best_source_) return x_(j, best_source_);
    if (options_.neighbour == Neighbour::best && options_.best_neighbour == BestNeighbour::origin) return 0;
    return is_random_ ? x_(j, other_source(i, neighbour_[bee])) : x_(j, i);
  }

  void find_best_source() { best_source_ = std::min_element(errors_.begin(), errors_.end()) - errors_.begin(); }

  // Returns a random source other than i; i if there is no other.
  Eigen::Index other_source(Eigen::Index i, double chance) const {
    const Eigen::Index others = x_.cols() - 1;
    const auto k = static_cast<Eigen::Index>(chance * static_cast<double>(others));
    return others > 0 && k >= i ? k + 1 : k;
  }

  // Fills the roulette: a source's share is 1 / (1 + f), or 0 if its error is not finite.
  void spin_up() {
    const double unit = options_.fitness_unit == FitnessUnit::cm ? base::centimetre : 1;
    share_.clear();
    for (const double error : errors_) share_.add(std::isfinite(error) ? 1 / (1 + error / unit) : 0);
  }

  Options options_;
  bool is_random_;  // some neighbours are drawn
  int limit_ = 0;
  Candidates x_, candidates_;
  Eigen::VectorX<Eigen::Index> source_, moved_by_;  // each bee's source; the last bee that moved a source
  Eigen::VectorXd errors_, found_;                  // errors of the sources; of the candidates
  Eigen::VectorXd joint_, neighbour_, phi_, roulette_;
  Roulette share_;
  Eigen::VectorXi failures_;
  Eigen::Index best_source_ = 0;  // of the present sources; best_ is the best ever
};

}  // namespace

SolverInfo k_artificial_bee_colony() {
  return solver_info<KArtificialBeeColony>("k_artificial_bee_colony", "artificial bee colony towards the best (K-ABC)",
                                           "El-Sherbiny, Elhosseini and Haikal 2018; Karaboga 2005", 1);
}

}  // namespace ikbench::solvers
