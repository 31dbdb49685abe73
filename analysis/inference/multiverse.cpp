#include "analysis/inference/multiverse.hpp"

namespace ikbench::inference {

double Multiverse::OfStudy::universes() const {
  double product = 1;
  for (const std::vector<ChosenSolver>& of_solver : solvers) product *= static_cast<double>(of_solver.size());
  return product;
}

double Multiverse::universes() const {
  double all = 0;
  for (const OfStudy& study : studies) all += study.universes();
  return all;
}

bool is_of_universes(Metric metric) { return metric == Metric::position_error_cm || metric == Metric::variation_deg; }

const std::vector<std::vector<double>>& values_of(const Multiverse::ChosenSolver& own, Metric metric) {
  return metric == Metric::position_error_cm ? own.error_cm : own.variation_deg;
}

}  // namespace ikbench::inference
