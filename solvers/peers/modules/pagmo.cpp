#include "solvers/peers/modules/pagmo.hpp"

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
#include <utility>

namespace ikbench::modules {
namespace {

// pagmo copies it; all copies evaluate for one call.
struct Target {
  const PagmoEvolution* evolution = nullptr;

  pagmo::vector_double fitness(const pagmo::vector_double& x) const { return {evolution->error(x)}; }
  std::pair<pagmo::vector_double, pagmo::vector_double> get_bounds() const {
    const auto copy = [](std::span<const double> values) { return pagmo::vector_double(values.begin(), values.end()); };
    return {copy(evolution->lower), copy(evolution->upper)};
  }
};

pagmo::algorithm algorithm_of(const PagmoEvolution& evolution) {
  const unsigned generations = evolution.generations, seed = evolution.seed;
  const double least = evolution.small_difference;
  switch (evolution.algorithm) {
    case PagmoAlgorithm::cmaes:
      return pagmo::algorithm(pagmo::cmaes(generations, -1, -1, -1, -1, 0.5, least, least, false, true, seed));
    case PagmoAlgorithm::xnes:
      return pagmo::algorithm(pagmo::xnes(generations, -1, -1, -1, -1, least, least, false, true, seed));
    case PagmoAlgorithm::de:
      return pagmo::algorithm(pagmo::de(generations, 0.8, 0.9, 2, least, least, seed));
    case PagmoAlgorithm::sade:
      return pagmo::algorithm(pagmo::sade(generations, 2, 1, least, least, false, seed));
    case PagmoAlgorithm::de1220:
      return pagmo::algorithm(
          pagmo::de1220(generations, pagmo::de1220_statics<void>::allowed_variants, 1, least, least, false, seed));
    case PagmoAlgorithm::pso:
      return pagmo::algorithm(pagmo::pso(generations, 0.7298, 2.05, 2.05, 0.5, 5, 2, 4, false, seed));
    case PagmoAlgorithm::pso_gen:
      return pagmo::algorithm(pagmo::pso_gen(generations, 0.7298, 2.05, 2.05, 0.5, 5, 2, 4, false, seed));
    case PagmoAlgorithm::bee_colony:
      return pagmo::algorithm(pagmo::bee_colony(generations, 20, seed));
    case PagmoAlgorithm::gwo:
      return pagmo::algorithm(pagmo::gwo(generations, seed));
    case PagmoAlgorithm::sga:
      break;
  }
  return pagmo::algorithm(pagmo::sga(generations, 0.9, 1, 0.02, 1, 2, "exponential", "polynomial", "tournament", seed));
}

}  // namespace

extern "C" const char* pagmo_version() { return PAGMO_VERSION; }

extern "C" void pagmo_evolve(const PagmoEvolution& evolution) {
  pagmo::population population(pagmo::problem{Target{&evolution}}, evolution.population - 1, evolution.seed);
  population.push_back({evolution.start.begin(), evolution.start.end()});
  algorithm_of(evolution).evolve(population);
}

}  // namespace ikbench::modules
