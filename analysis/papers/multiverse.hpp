// A paper's claims in every reading of what it leaves open (Steegen et al., Perspectives on Psychological Science 11
// (2016) 702), and its printed numbers beside each. A reading is a choice for the study and one for each solver. Given
// the study's, the solvers are independent, and pairs are judged alone, so products count all readings exactly.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/figures/figure.hpp"
#include "analysis/papers/claims.hpp"
#include "results/dimension.hpp"

namespace ikbench::papers {

constexpr std::array<std::string_view, 2> metrics_of_readings{"position_error_cm", "variation_deg"};

struct Multiverse {
  struct ChosenSolver {
    results::Chosen chosen;
    // By metric and seed: the mean of each run over its targets.
    std::array<std::vector<compare::Group>, metrics_of_readings.size()> means;
  };
  // Its readings share its weight evenly.
  struct OfStudy {
    results::Chosen chosen;
    double weight = 1;
    std::vector<std::vector<ChosenSolver>> solvers;  // by solver; the default first
  };
  std::vector<results::Dimension> dimensions;
  std::vector<std::string> solvers;
  std::vector<OfStudy> studies;  // the default first; all weights sum to 1
};

struct JudgedMultiverse {
  std::vector<SharesOfClaim> claims;
  show::Table table;       // "multiverse": the shares, and what decides them most
  figures::Figure figure;  // "multiverse": the specification curve
};

JudgedMultiverse judged(const Paper& paper, const Multiverse& multiverse, const results::Plan& plan);

// The range of each statistic in 95 % of studies of so many runs, by Hill's A(n) (JASA 63 (1968) 677) on the logarithms
// of the values: the next one is equally likely in each gap of the known ones, and then is known itself; beyond the
// last there is an exponential tail of Hill's slope (Annals of Statistics 3 (1975) 1163). None for fewer than five
// values, or one that is not above 0.
using Ranges = std::array<compare::Interval, statistics.size()>;
std::optional<Ranges> predicted_ranges(const std::vector<double>& values, int runs);

}  // namespace ikbench::papers
