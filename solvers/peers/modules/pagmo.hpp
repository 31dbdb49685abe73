// The interface of the object that calls pagmo. It is loaded when a solver of pagmo is made, because pagmo's own
// library takes longer to load than the rest of the program.
#pragma once

#include <functional>
#include <span>

namespace ikbench::modules {

enum class PagmoAlgorithm { cmaes, xnes, de, sade, de1220, pso, pso_gen, bee_colony, gwo, sga };

// An evolution of a population that contains the start. It ends after its generations, or by what `error` throws.
struct PagmoEvolution {
  PagmoAlgorithm algorithm;
  double small_difference;
  unsigned generations, population, seed;
  std::span<const double> lower, upper, start;
  const std::function<double(std::span<const double>)>& error;  // of a candidate
};

// The object's functions: pagmo_evolve, and pagmo_version, the version that it was compiled with.
using PagmoEvolve = void (*)(const PagmoEvolution& evolution);
using PagmoVersion = const char* (*)();

}  // namespace ikbench::modules
