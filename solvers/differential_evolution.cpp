// DE, differential evolution, scheme rand/1/bin: Storn and Price 1997; the numbers are those of Slim et al. 2023, Table
// 1. docs/papers/slim2023-notes.md 2.9 argues for this reading.
#include <fmt/format.h>

#include <stdexcept>

#include "solvers/bounds.hpp"
#include "solvers/kernels.hpp"
#include "solvers/registry.hpp"

namespace ikbench::solvers {

namespace {

constexpr int min_population = 4;  // a candidate and its three partners

class DifferentialEvolution final : public Searcher {
 public:
  enum class Outside { initial, clamp, reflect, resample };
  enum class Replacement { generation, at_once };
  enum class Drawn { never, per_trial, per_joint };

  struct Options {
    double weight = 0.6;
    Drawn weight_drawn = Drawn::never;
    double crossover = 0.9;
    Replacement replacement = Replacement::generation;
    Outside bounds = Outside::clamp;

    void list(OptionList& list) {
      list.number("weight", weight, {0, 2}, "F, factor of the difference between two candidates");
      list.number("crossover", crossover, {0, 1}, "C, probability that a joint comes from the mutant");
      list.choice("replacement", replacement,
                  {{"generation", Replacement::generation}, {"at_once", Replacement::at_once}},
                  "a better trial replaces its parent at the end of the generation (Storn and Price), or at once, so "
                  "that the next trial can use it");
      list.choice("bounds", bounds,
                  {{"initial", Outside::initial},
                   {"clamp", Outside::clamp},
                   {"reflect", Outside::reflect},
                   {"resample", Outside::resample}},
                  "joint limits apply to the initial candidates only, or a joint outside is clamped, reflected or "
                  "drawn again");
      list.later();
      list.choice(
          "weight_drawn", weight_drawn,
          {{"never", Drawn::never}, {"per_trial", Drawn::per_trial}, {"per_joint", Drawn::per_joint}},
          "F is the weight (Table 1: 0.6), or drawn from 0.2 to 0.8 for each trial or each of its joints, as in "
          "public MATLAB code");
    }

    static void use(Settings& of) {
      if (of.at("weight_drawn") != Setting("never")) of.erase("weight");
    }
  };

  explicit DifferentialEvolution(Options options) : options_(options) {}

  void start(const Problem& problem, Objective& objective, Random& random) override {
    if (problem.population < min_population) {
      throw std::invalid_argument(fmt::format(
          "differential_evolution has a population of {}; expected at least {}, because it combines three others",
          problem.population, min_population));
    }
    take(problem);
    const int candidates = problem.population;
    for (Candidates* each : {&x_, &trials_, &crossover_, &fresh_}) each->resize(problem.joints(), candidates);
    partners_.resize(3, candidates);
    weights_.setConstant(options_.weight_drawn == Drawn::per_joint ? problem.joints() : 1, candidates, options_.weight);
    forced_.resize(candidates);
    limit_.setConstant(candidates, options_.crossover);
    for (Eigen::VectorXd* each : {&errors_, &trial_errors_}) each->resize(candidates);

    draw_within_limits(problem, random, x_);
    evaluate_all(objective, x_, errors_);
  }

  void step(Objective& objective, Random& random) override {
    draw(random);
    if (options_.replacement == Replacement::at_once)
      replace_at_once(objective);
    else
      replace_generation(objective);
  }

 private:
  Eigen::Index partner(int k, Eigen::Index i) const { return static_cast<Eigen::Index>(partners_(k, i)); }

  // Draws all random numbers of a generation.
  void draw(Random& random) {
    random.uniforms(partners_);
    random.uniforms(crossover_);
    random.uniforms(forced_);
    if (options_.weight_drawn != Drawn::never) {
      random.uniforms(weights_);
      weights_.array() = 0.2 + (0.8 - 0.2) * weights_.array();
    }
    if (options_.bounds == Outside::resample) draw_within_limits(problem_, random, fresh_);
    kernels_.choose_partners(partners_.data(), partners_.cols());
    for (Eigen::Index i = 0; i < x_.cols(); ++i) {  // at least one joint comes from the mutant
      crossover_(static_cast<Eigen::Index>(forced_[i] * static_cast<double>(x_.rows())), i) = -1;
    }
  }

  // Makes the mutant of a candidate; `weight_of(j)` is F for joint j.
  template <class WeightOf>
  void mutate(Eigen::Index i, WeightOf weight_of) {
    const auto a = partner(0, i), b = partner(1, i), c = partner(2, i);
    for (Eigen::Index j = 0; j < x_.rows(); ++j) trials_(j, i) = x_(j, a) + weight_of(j) * (x_(j, b) - x_(j, c));
  }

  // Makes the trials of `count` candidates.
  void combine(Eigen::Index first, Eigen::Index count) {
    for (Eigen::Index i = first; i < first + count; ++i) {
      if (options_.weight_drawn == Drawn::per_joint) {
        mutate(i, [&](Eigen::Index j) { return weights_(j, i); });
      } else {
        mutate(i, [weight = weights_(0, i)](Eigen::Index) { return weight; });
      }
    }
    for (Eigen::Index j = 0; j < x_.rows(); ++j) {
      kernels_.choose({.less = &crossover_(j, first),  // crossover
                       .than = &limit_[first],
                       .yes = &trials_(j, first),
                       .no = &x_(j, first),
                       .out = &trials_(j, first),
                       .count = count});
    }
    bring_inside(first, count);
  }

  // Evaluates trial after trial; a better one replaces its candidate before the next is made. A trial that was made
  // ahead stays if none of its partners was replaced since.
  void replace_at_once(Objective& objective) {
    Eigen::Index first_stale = 0;
    const auto propose = [&](Eigen::Index first, Eigen::Index count) {
      first_stale = x_.cols();
      combine(first, count);
    };
    const auto decide = [&](Eigen::Index i) {
      if (trial_errors_[i] < errors_[i]) {
        x_.col(i) = trials_.col(i);
        errors_[i] = trial_errors_[i];
        best_.improve(trials_.col(i), trial_errors_[i]);
        first_stale = first_with_partner(i, first_stale);
      }
      return i + 1 == first_stale && first_stale < x_.cols();
    };
    objective.one_by_one(trials_, trial_errors_, propose, decide);
  }

  // Evaluates all trials; better ones replace their candidates at the end.
  void replace_generation(Objective& objective) {
    combine(0, x_.cols());
    objective.errors(trials_, trial_errors_);
    const auto replace = [&](const double* by, double* own) {
      kernels_.choose({trial_errors_.data(), errors_.data(), by, own, own, x_.cols()});
    };
    for (Eigen::Index j = 0; j < x_.rows(); ++j) replace(&trials_(j, 0), &x_(j, 0));
    replace(trial_errors_.data(), errors_.data());
    for (Eigen::Index i = 0; i < x_.cols(); ++i) best_.improve(x_.col(i), errors_[i]);
  }

  // Returns the first candidate after i, and before `end`, of which i is a partner; otherwise `end`.
  Eigen::Index first_with_partner(Eigen::Index i, Eigen::Index end) const {
    Eigen::Index other = i + 1;
    while (other < end && partner(0, other) != i && partner(1, other) != i && partner(2, other) != i) ++other;
    return other;
  }

  void bring_inside(Eigen::Index first, Eigen::Index count) {
    if (options_.bounds == Outside::resample)
      draw_outside_again(problem_, fresh_, first, trials_.middleCols(first, count));
    for (Eigen::Index j = 0; j < x_.rows(); ++j) {
      const double lower = problem_.lower[j], upper = problem_.upper[j];
      auto q = trials_.row(j).segment(first, count).array();
      if (options_.bounds == Outside::clamp) kernels_.clamp(lower, upper, &trials_(j, first), count);
      if (options_.bounds == Outside::reflect)
        q = (q >= lower && q <= upper)
                .select(q, (q < lower).select(2 * lower - q, 2 * upper - q).max(lower).min(upper));
    }
  }

  Options options_;
  const Kernels& kernels_ = kernels();
  Candidates x_, trials_, partners_, crossover_, fresh_;  // partners_: three for each candidate
  Candidates weights_;                                    // one row for all joints, or one for each
  Eigen::RowVectorXd forced_, limit_;
  Eigen::VectorXd errors_, trial_errors_;
};

}  // namespace

SolverInfo differential_evolution() {
  return solver_info<DifferentialEvolution>("differential_evolution", "differential evolution (DE), rand/1/bin",
                                            "Storn and Price 1997", min_population);
}

}  // namespace ikbench::solvers
