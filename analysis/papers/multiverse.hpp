// A paper's claims in every interpretation of what the paper leaves open (Steegen et al., Perspectives on Psychological
// Science 11 (2016) 702): in how many interpretations a claim fails. Each pair of solvers is judged by itself, and once
// for all interpretations that share the pair's solves.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/judge/data/samples.hpp"
#include "analysis/papers/rules.hpp"
#include "analysis/show/table.hpp"
#include "results/dimension.hpp"

namespace ikbench::papers {

constexpr std::array<std::string_view, 2> metrics_of_readings{"position_error_cm", "variation_deg"};

// Returns a group of the means of runs. A mean that is not finite is a missing value.
judge::Group group_of(std::vector<double> runs);

// A multiverse with the results of all solves.
struct SolvedMultiverse : results::Multiverse {
  // The mean of each run over the run's targets, by part and metric.
  std::vector<std::array<judge::Group, metrics_of_readings.size()>> means;
};

// The judgement of a multiverse.
struct JudgedMultiverse {
  std::map<std::string, InReadings> in_readings;  // counts of each claim, by id
  show::Table table;                              // "multiverse": a row per claim
};

// The number of printed numbers in the table of means that repeat, by the seed of a study (a multiverse of one
// interpretation).
struct SeedCounts {
  std::string reading = {};                      // words for the interpretation: Repeated::reading
  std::map<std::string, std::vector<int>> rows;  // by solver and seed
  std::vector<int> all;                          // by seed
  int together = 0;                              // by the runs of all seeds at once
  int of = 0;                                    // all printed numbers; 0 if the runs are too few for any
  // The number of one seed's numbers that lie in the ranges of another seed: what the same program would repeat.
  std::vector<int> same;
  // By seed: how many numbers the row of another solver would match. The printed rows of the other solvers are compared
  // with a solver's ranges. The mean number over these rows is summed over the solvers.
  std::vector<int> other_rows;
  std::vector<int> wide;  // by seed: the number of ranges that are wider than a factor of ten
};
// Returns the counts of a multiverse of one interpretation.
SeedCounts counts_by_seed(const Paper& paper, const SolvedMultiverse& multiverse);
// Returns the smallest and the largest count: "41 to 47".
std::string span_of(const std::vector<int>& counts);

// Returns how each claim does in all interpretations, with pairs judged by `plan`.
JudgedMultiverse judged(const Paper& paper, const SolvedMultiverse& multiverse, const results::AnalysisPlan& plan);

}  // namespace ikbench::papers
