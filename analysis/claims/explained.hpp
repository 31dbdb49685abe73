// Compares universes with the paper: the printed numbers of error and variation that each explains.
#pragma once

#include <array>
#include <bitset>
#include <map>
#include <utility>
#include <vector>

#include "analysis/claims/claims_file.hpp"
#include "analysis/claims/printed.hpp"
#include "analysis/inference/multiverse.hpp"
#include "analysis/statistics/predictive_study.hpp"

namespace ikbench::claims {

constexpr std::array<inference::Metric, 2> explained_metrics{inference::Metric::position_error_cm,
                                                             inference::Metric::variation_deg};
constexpr std::size_t numbers_of_solver = explained_metrics.size() * statistics::predicted_statistics;
// Marks which numbers of a solver are explained: those of error, then those of variation.
using Explained = std::bitset<numbers_of_solver>;

// Values of all seeds.
std::vector<double> pooled(const inference::Multiverse::ChosenSolver& own, inference::Metric metric);

// Holds what the paper prints of the solvers of a multiverse. A solver's results explain a printed number if, up to its
// rounding, it lies in the range of 95 % of studies with as many runs.
class PrintedSolvers {
 public:
  PrintedSolvers(const ClaimsFile& file, const inference::Multiverse& multiverse);

  int numbers() const;  // 0 if no solver is printed, or there are too few runs to say what another study would print
  bool is_printed(std::size_t solver) const { return row(solver, 0).printed.n > 0; }
  int most_runs() const;  // of a printed number
  const PrintedRow& row(std::size_t solver, std::size_t metric) const { return rows_[solver][metric]; }
  using Ranges = std::array<statistics::Estimate, numbers_of_solver>;
  Ranges ranges(std::size_t solver, const inference::Multiverse::ChosenSolver& own);
  Explained explained(std::size_t solver, const inference::Multiverse::ChosenSolver& own);  // none if it is not printed

 private:
  std::vector<std::array<PrintedRow, explained_metrics.size()>> rows_;
  bool can_predict_;
  // Known ranges by runs and values, since many universes share a series.
  std::map<std::pair<std::size_t, std::vector<double>>, statistics::PredictedRanges> known_ = {};
};

// What each choice of each solver explains: by the choice of the study, by solver, by its own choice.
using ExplainedUniverses = std::vector<std::vector<std::vector<Explained>>>;
ExplainedUniverses explained_in(const inference::Multiverse& multiverse, PrintedSolvers& printed);

// The universes that fit are those that explain so many printed numbers at least; without `explained` none is known.
struct Fit {
  ExplainedUniverses explained = {};
  int least = 0;
};

// Counts universes: how many printed numbers they explain, and the best, which explain the most of all.
struct Support {
  double explained = 0, weight = 0;  // sum of their explained numbers by their weights, and of the weights
  int most = 0;                      // explained numbers at most
  double best = 0;                   // number of the best universes among them
};

struct UniverseSupport {
  Support all;
  double more = 0;     // weight of the universes that explain more numbers than the default
  double fitting = 0;  // weight of those that fit
  int by_default = 0;
  std::vector<std::vector<Support>> alternatives;               // by dimension
  std::vector<std::array<Support, numbers_of_solver>> numbers;  // of the universes that explain it, by solver
};
UniverseSupport support_of(const inference::Multiverse& multiverse, const Fit& fit);

}  // namespace ikbench::claims
