// pagmo (Biscani and Izzo 2020) evolves a population by our objective. One step is one call of the library, for as many
// generations as iterations are planned, or until the study's budgets and tolerances end it. Its algorithms need finite
// limits: for a joint without end, a whole turn on both sides of the start contains every direction well inside.
#include "solvers/peers/modules/pagmo.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <limits>
#include <pagmo/config.hpp>
#include <stdexcept>
#include <string_view>

#include "solvers/bounds.hpp"
#include "solvers/peers/evaluations.hpp"
#include "solvers/registry.hpp"

namespace ikbench::solvers {

using namespace numerics;
using namespace robots;

namespace {

constexpr int least_pagmo_population = 7;  // for its self-adaptive differential evolutions

// Loads the object that calls pagmo, or finds it loaded. Throws std::runtime_error if it is missing, or compiled with
// another pagmo.
modules::PagmoEvolve loaded_evolve() {
  constexpr const char* file = "ikbench_pagmo.so";
  void* const object = dlopen(file, RTLD_NOW | RTLD_LOCAL);  // stays loaded
  void* const evolve = object != nullptr ? dlsym(object, "pagmo_evolve") : nullptr;
  void* const version = evolve != nullptr ? dlsym(object, "pagmo_version") : nullptr;
  if (version == nullptr) throw std::runtime_error(fmt::format("solver pagmo: cannot load {}: {}", file, dlerror()));
  const std::string_view found = reinterpret_cast<modules::PagmoVersion>(version)();
  if (found != PAGMO_VERSION) {
    throw std::runtime_error(
        fmt::format("solver pagmo: {} is of pagmo {}; expected {}; install ikbench again", file, found, PAGMO_VERSION));
  }
  return reinterpret_cast<modules::PagmoEvolve>(evolve);
}

class PagmoSolver final : public Solver {
 public:
  using Algorithm = modules::PagmoAlgorithm;
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

  explicit PagmoSolver(Options options) : options_(options), evolve_(loaded_evolve()) {}

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
    const std::function<double(std::span<const double>)> error = [&](std::span<const double> x) {
      if (evaluations.is_over()) throw IsOver();
      return evaluations.error(Eigen::Map<const Eigen::VectorXd>(x.data(), static_cast<Eigen::Index>(x.size())));
    };
    const auto values = [](const Eigen::VectorXd& of) {
      return std::span(of.data(), static_cast<std::size_t>(of.size()));
    };
    try {
      evolve_({.algorithm = options_.algorithm,
               .small_difference = options_.small_difference,
               .generations = static_cast<unsigned>(solve_.problem.iterations),
               .population = static_cast<unsigned>(solve_.problem.population),
               .seed = seed,
               .lower = values(limits.lower),
               .upper = values(limits.upper),
               .start = values(start),
               .error = error});
    } catch (const IsOver&) {  // the best evaluated candidate is kept
    }
  }

  const Best& best() const override { return solve_.best; }
  bool finished() const override { return solve_.has_ended; }

 private:
  Options options_;
  modules::PagmoEvolve evolve_;
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
