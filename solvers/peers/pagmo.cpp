// pagmo (Biscani and Izzo 2020) evolves a population by our objective. One step is one call of the library, for as many
// generations as iterations are planned, or until the study's budgets and tolerances end it. Its algorithms need finite
// limits: for a joint without end, a whole turn on both sides of the start contains every direction well inside.
#include <fmt/core.h>

#include <limits>
#include <pagmo/algorithm.hpp>
#include <pagmo/algorithms/bee_colony.hpp>
#include <pagmo/algorithms/cmaes.hpp>
#include <pagmo/algorithms/de.hpp>
#include <pagmo/algorithms/de1220.hpp>
#include <pagmo/algorithms/gwo.hpp>
#include <pagmo/algorithms/pso.hpp>
#include <pagmo/algorithms/pso_gen.hpp>
#include <pagmo/algorithms/sade.hpp>
#include <pagmo/algorithms/sga.hpp>
#include <pagmo/algorithms/xnes.hpp>
#include <pagmo/config.hpp>
#include <pagmo/population.hpp>
#include <pagmo/problem.hpp>
#include <stdexcept>
#include <utility>

#include "solvers/bounds.hpp"
#include "solvers/peers/evaluations.hpp"
#include "solvers/registry.hpp"

namespace ikbench::solvers {

using namespace numerics;
using namespace robots;

namespace {

constexpr int least_pagmo_population = 7;  // for its self-adaptive differential evolutions

// Evaluates our objective. pagmo copies it; all copies evaluate for one call.
struct Target {
  Evaluations* evaluations = nullptr;
  const JointLimits* limits = nullptr;

  pagmo::vector_double fitness(const pagmo::vector_double& x) const {
    if (evaluations->is_over()) throw IsOver();
    return {evaluations->error(Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())))};
  }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    return {values(limits->lower), values(limits->upper)};
  }
  static pagmo::vector_double values(const Eigen::VectorXd& of) { return {of.begin(), of.end()}; }
};

class PagmoSolver final : public Solver {
 public:
  enum class Algorithm { cmaes, xnes, de, sade, de1220, pso, pso_gen, bee_colony, gwo, sga };
  struct Options {
    Algorithm algorithm = Algorithm::cmaes;
    double small_difference = 1e-12;

    void list(OptionList& list) {
      list.choice("algorithm", algorithm,
                  {{"cmaes", Algorithm::cmaes},
                   {"xnes", Algorithm::xnes},
                   {"de", Algorithm::de},
                   {"sade", Algorithm::sade},
                   {"de1220", Algorithm::de1220},
                   {"pso", Algorithm::pso},
                   {"pso_gen", Algorithm::pso_gen},
                   {"bee_colony", Algorithm::bee_colony},
                   {"gwo", Algorithm::gwo},
                   {"sga", Algorithm::sga}},
                  "of pagmo, with pagmo's defaults");
      list.number("small_difference", small_difference, {0, 1},
                  "cmaes, xnes, de, sade and de1220 end where the population differs by no more than this [m; rad]");
    }
  };

  explicit PagmoSolver(Options options) : options_(options) {}

  void start(const Problem& problem, Objective& objective, Random&) override {
    if (problem.population < least_pagmo_population) {
      throw std::invalid_argument(fmt::format("pagmo has a population of {}; expected at least {}", problem.population,
                                              least_pagmo_population));
    }
    solve_.start(problem, objective);
  }

  void step(Objective& objective, Random& random) override {
    if (solve_.has_ended) return;
    solve_.has_ended = true;
    const auto seed = static_cast<unsigned>(random.index(std::numeric_limits<int>::max()));
    Evaluations evaluations(solve_, objective);
    const JointLimits limits = finite_limits(solve_.problem);
    const Configuration start = solve_.problem.start.cwiseMax(limits.lower).cwiseMin(limits.upper);
    const auto size = static_cast<pagmo::population::size_type>(solve_.problem.population);
    try {
      pagmo::population population(pagmo::problem{Target{&evaluations, &limits}}, size - 1, seed);
      population.push_back(Target::values(start));
      algorithm(seed).evolve(population);
    } catch (const IsOver&) {  // the best evaluated candidate is kept
    }
  }

  const Best& best() const override { return solve_.best; }
  bool finished() const override { return solve_.has_ended; }

 private:
  pagmo::algorithm algorithm(unsigned seed) const {
    const auto generations = static_cast<unsigned>(solve_.problem.iterations);
    const double least = options_.small_difference;
    switch (options_.algorithm) {
      case Algorithm::cmaes:
        return pagmo::algorithm(pagmo::cmaes(generations, -1, -1, -1, -1, 0.5, least, least, false, true, seed));
      case Algorithm::xnes:
        return pagmo::algorithm(pagmo::xnes(generations, -1, -1, -1, -1, least, least, false, true, seed));
      case Algorithm::de:
        return pagmo::algorithm(pagmo::de(generations, 0.8, 0.9, 2, least, least, seed));
      case Algorithm::sade:
        return pagmo::algorithm(pagmo::sade(generations, 2, 1, least, least, false, seed));
      case Algorithm::de1220:
        return pagmo::algorithm(
            pagmo::de1220(generations, pagmo::de1220_statics<void>::allowed_variants, 1, least, least, false, seed));
      case Algorithm::pso:
        return pagmo::algorithm(pagmo::pso(generations, 0.7298, 2.05, 2.05, 0.5, 5, 2, 4, false, seed));
      case Algorithm::pso_gen:
        return pagmo::algorithm(pagmo::pso_gen(generations, 0.7298, 2.05, 2.05, 0.5, 5, 2, 4, false, seed));
      case Algorithm::bee_colony:
        return pagmo::algorithm(pagmo::bee_colony(generations, 20, seed));
      case Algorithm::gwo:
        return pagmo::algorithm(pagmo::gwo(generations, seed));
      case Algorithm::sga:
        break;
    }
    return pagmo::algorithm(
        pagmo::sga(generations, 0.9, 1, 0.02, 1, 2, "exponential", "polynomial", "tournament", seed));
  }

  Options options_;
  LibrarySolve solve_;
};

}  // namespace

SolverInfo pagmo() {
  SolverInfo info = solver_info<PagmoSolver>("pagmo", "pagmo's evolutionary algorithms (option algorithm)",
                                             "Biscani and Izzo 2020", least_pagmo_population);
  info.library = "pagmo " PAGMO_VERSION;
  return info;
}

}  // namespace ikbench::solvers
