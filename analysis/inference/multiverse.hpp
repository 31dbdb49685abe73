// A multiverse: each combination of a choice for the study with one choice of each solver (Steegen et al., Perspectives
// on Psychological Science 11 (2016) 702). Given the study's choice the solvers are independent, so products count the
// universes exactly, without listing them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/inference/metrics.hpp"
#include "results/dimension.hpp"

namespace ikbench::inference {

struct Multiverse {
  using Alternative = results::Alternative;
  using Dimension = results::Dimension;
  using Choice = results::Choice;
  // A solver's results under one of its choices: by seed, one value per run.
  struct ChosenSolver {
    std::vector<Choice> chosen;
    std::vector<std::vector<double>> error_cm, variation_deg;
  };
  // The universes of one choice for the study. They share its weight evenly.
  struct OfStudy {
    std::vector<Choice> chosen;
    double weight = 1;
    int out_of_reach = 0;
    std::vector<std::vector<ChosenSolver>> solvers;  // by solver, by its own choice; the default first

    double universes() const;
  };
  std::vector<Dimension> dimensions;
  std::vector<std::string> solvers;
  std::vector<OfStudy> studies;  // the default first

  std::size_t seeds() const { return studies.front().solvers.front().front().error_cm.size(); }
  double universes() const;
};

// Returns whether the metric is judged in universes: position error or variation.
bool is_of_universes(Metric metric);
// Values of the metric by seed.
const std::vector<std::vector<double>>& values_of(const Multiverse::ChosenSolver& own, Metric metric);

}  // namespace ikbench::inference
