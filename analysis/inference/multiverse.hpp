// Judges claims between solvers in every universe: each combination of a choice for the study with one choice of each
// solver (Steegen et al., Perspectives on Psychological Science 11 (2016) 702). Given the study's choice the solvers
// are independent, so products count the universes exactly, without listing them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/inference/metrics.hpp"
#include "results/analysis_plan.hpp"
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

// A claim about one solver: better than a rival or, if none is named, than every other solver.
struct MultiverseClaim {
  std::string id;     // "most_accurate"
  std::string words;  // "IK-BA is the most accurate"
  std::string solver;
  std::string rival = {};
  Metric metric = Metric::position_error_cm;
  // The average of the runs that is tested: mean, or typical. Both use Games and Howell's test: Welch's t against the
  // studentized range of all solvers. It needs the values of two solvers only, so pairs can be counted alone. Level and
  // control come from the study's plan.
  results::Estimand by = results::Estimand::mean;
  // If set, the claim is instead: the solver is better with this dimension's default than with another alternative, all
  // else equal. It fails if both give the same bits. Universes with the default are not counted.
  std::string effect_of = {};
};

// Weights of the universes in which a claim holds (the solver is found better than each rival), fails (a rival is found
// better) and is undecided. Each seed counts as a study of its own.
struct UniverseCounts {
  double holds = 0, fails = 0, undecided = 0;
  void operator+=(const UniverseCounts& more);
  double all() const { return holds + fails + undecided; }
};

struct ClaimCounts {
  MultiverseClaim claim;
  UniverseCounts all = {};
  std::vector<UniverseCounts> seeds = {};
  // By dimension and alternative; a dimension does not count universes that make no choice in it.
  std::vector<std::vector<UniverseCounts>> alternatives = {};

  // The dimension whose alternatives change the share that holds most; the number of dimensions if none changes it.
  std::size_t deciding() const;
  double difference(std::size_t dimension) const;
};

// Counts the universes of each claim; 0 if its solver, rival or dimension is missing.
std::vector<ClaimCounts> counted(const Multiverse& multiverse, const std::vector<MultiverseClaim>& claims,
                                 const results::AnalysisPlan& plan);

}  // namespace ikbench::inference
