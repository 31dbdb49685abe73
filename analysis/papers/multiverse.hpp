// A paper's claims in every reading of what it leaves open (Steegen et al., Perspectives on Psychological Science 11
// (2016) 702): in how many one fails. A pair of solvers is judged alone, and once for all readings that share its
// solves.
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

struct SolvedMultiverse : results::Multiverse {
  // By part and metric: the mean of each run over its targets.
  std::vector<std::array<judge::Group, metrics_of_readings.size()>> means;
};

struct JudgedMultiverse {
  std::map<std::string, InReadings> in_readings;  // of claims, by id
  show::Table table;                              // "multiverse"; readings, each seed of one by itself
};

// How many printed numbers of the table of means repeat, by the seed of a study (a multiverse of one reading).
struct SeedCounts {
  std::string reading = {};                      // of the study: Repeated::reading
  std::map<std::string, std::vector<int>> rows;  // by solver and seed
  std::vector<int> all;                          // by seed
  int together = 0;                              // by the runs of all seeds at once
  int of = 0;                                    // printed numbers; 0 if too few runs tell of any
  std::vector<int> same;  // of each seed's numbers in the ranges of each other's: what the same program would repeat
};
SeedCounts counts_by_seed(const Paper& paper, const SolvedMultiverse& multiverse);
std::string span_of(const std::vector<int>& counts);  // "41 to 47"

JudgedMultiverse judged(const Paper& paper, const SolvedMultiverse& multiverse, const results::AnalysisPlan& plan);

}  // namespace ikbench::papers
