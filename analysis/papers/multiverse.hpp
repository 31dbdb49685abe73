// A paper's claims in every reading of what it leaves open (Steegen et al., Perspectives on Psychological Science 11
// (2016) 702): with which answers one fails. A reading is a choice for the study and one for each solver. Given the
// study's, the solvers are independent, and pairs are judged alone, so products count all readings exactly.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/papers/claims.hpp"
#include "results/dimension.hpp"

namespace ikbench::papers {

constexpr std::array<std::string_view, 2> metrics_of_readings{"position_error_cm", "variation_deg"};

struct Multiverse : results::Multiverse {
  // By part and metric: the mean of each run over its targets.
  std::vector<std::array<compare::Group, metrics_of_readings.size()>> means;
};

// Readings, each seed of one by itself.
struct Readings {
  double holds = 0, fails = 0, undecided = 0;
};
struct InReadings {
  Condition condition;
  Readings count;
};

struct JudgedMultiverse {
  std::vector<InReadings> claims;
  show::Table table;  // "multiverse"
  // How many of the printed numbers' ranges hold the numbers of the same program by another seed; the mean over pairs
  // of seeds. None with one seed, or another number of runs than the paper's.
  std::optional<double> expected = {};

  std::vector<Condition> conditions() const;
};

JudgedMultiverse judged(const Paper& paper, const Multiverse& multiverse, const results::Plan& plan);

}  // namespace ikbench::papers
