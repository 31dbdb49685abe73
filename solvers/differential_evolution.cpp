// DE, differential evolution, scheme rand/1/bin: Storn and Price 1997; the numbers are those of Slim et al. 2023,
// Table 1. The reading is argued in docs/paper-notes.md 2.9.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "solvers/bounds.hpp"
#include "solvers/registry.hpp"

namespace ikbench {

namespace {

constexpr int least_population = 4;  // a candidate and the three others that it is combined with

class DifferentialEvolution final : public Solver {
 public:
  enum class Outside { initial, clamp, reflect, resample };

  struct Options {
    double weight = 0.6;
    double crossover = 0.9;
    Outside bounds = Outside::clamp;

    void list(OptionList& list) {
      list.number("weight", weight, {0, 2}, "F, factor of the difference of two candidates");
      list.number("crossover", crossover, {0, 1}, "C, chance of a joint to come from the mutant");
      list.choice("bounds", bounds,
                  {{"initial", Outside::initial},
                   {"clamp", Outside::clamp},
                   {"reflect", Outside::reflect},
                   {"resample", Outside::resample}},
                  "joint limits hold for the initial candidates only, or a joint outside is set to its limit, "
                  "mirrored at it, or drawn anew");
    }
  };

  explicit DifferentialEvolution(Options options) : options_(options) {}

  void start(const Problem& problem, Objective& objective, Random& random) override {
    if (problem.population < least_population) {
      throw std::invalid_argument(fmt::format(
          "differential_evolution has a population of {}; it combines three others, so it needs at least {}",
          problem.population, least_population));
    }
    problem_ = problem;
    const int candidates = problem.population;
    x_.resize(problem.joints(), candidates);
    partner_.resize(3, candidates);
    crossover_.resize(problem.joints(), candidates);
    fresh_.resize(problem.joints(), candidates);
    forced_.resize(candidates);
    errors_.resize(candidates);
    trial_.resize(problem.joints());
    best_ = {problem.start};

    draw_within_limits(problem, random, x_);
    objective.errors(x_, errors_);
    for (int i = 0; i < candidates; ++i) best_.improve(x_.col(i), errors_[i]);
  }

  void step(Objective& objective, Random& random) override {
    random.uniforms(partner_);
    random.uniforms(crossover_);
    random.uniforms(forced_);
    if (options_.bounds == Outside::resample) draw_within_limits(problem_, random, fresh_);
    for (Eigen::Index i = 0; i < x_.cols(); ++i) {
      const auto [a, b, c] = partners(i);
      const auto forced = static_cast<Eigen::Index>(forced_[i] * static_cast<double>(x_.rows()));
      for (Eigen::Index j = 0; j < x_.rows(); ++j) {
        const bool mutant = j == forced || crossover_(j, i) < options_.crossover;            // crossover
        trial_[j] = mutant ? x_(j, a) + options_.weight * (x_(j, b) - x_(j, c)) : x_(j, i);  // mutation
      }
      bring_inside(i);
      const double error = objective.error(trial_);
      if (error < errors_[i]) {  // takes its place at once: the next one may combine it already
        x_.col(i) = trial_;
        errors_[i] = error;
        best_.improve(trial_, error);
      }
    }
  }

  const Best& best() const override { return best_; }

 private:
  // Three different candidates, none of them i: each number picks one of those that are left.
  std::array<Eigen::Index, 3> partners(Eigen::Index i) const {
    std::array<Eigen::Index, 3> chosen{};
    std::array<Eigen::Index, 4> taken{i};  // the first k + 1, ascending
    for (std::size_t k = 0; k < 3; ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      auto pick = static_cast<Eigen::Index>(partner_(row, i) * static_cast<double>(x_.cols() - row - 1));
      std::size_t place = 0;
      for (; place <= k && pick >= taken[place]; ++place) ++pick;
      for (std::size_t t = k + 1; t > place; --t) taken[t] = taken[t - 1];
      chosen[k] = taken[place] = pick;
    }
    return chosen;
  }

  void bring_inside(Eigen::Index i) {
    for (Eigen::Index j = 0; j < trial_.size(); ++j) {
      const double lower = problem_.lower[j], upper = problem_.upper[j], outside = trial_[j];
      if (outside >= lower && outside <= upper) continue;
      const double limit = outside < lower ? lower : upper;
      switch (options_.bounds) {
        case Outside::initial:
          break;
        case Outside::clamp:
          trial_[j] = limit;
          break;
        case Outside::reflect:
          trial_[j] = std::clamp(2 * limit - outside, lower, upper);
          break;
        case Outside::resample:
          trial_[j] = fresh_(j, i);
          break;
      }
    }
  }

  Options options_;
  Problem problem_;
  Candidates x_, partner_, crossover_, fresh_;
  Eigen::VectorXd forced_, errors_, trial_;
  Best best_;
};

}  // namespace

SolverInfo differential_evolution() {
  return solver_info<DifferentialEvolution>("differential_evolution", "differential evolution (DE), rand/1/bin",
                                            "Storn and Price 1997", least_population);
}

}  // namespace ikbench
