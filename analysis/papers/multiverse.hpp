// A paper's claims in every reading of what it leaves open (Steegen et al., Perspectives on Psychological Science 11
// (2016) 702): in how many one fails. A reading is a choice for the study and one for each solver. Given the
// study's, the solvers are independent, and pairs are judged alone, so products count all readings exactly.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/judge/observations.hpp"
#include "analysis/papers/rules.hpp"
#include "analysis/show/table.hpp"
#include "results/dimension.hpp"

namespace ikbench::papers {

constexpr std::array<std::string_view, 2> metrics_of_readings{"position_error_cm", "variation_deg"};

// Of the means of runs; one that is not finite is lost.
judge::Group group_of(std::vector<double> runs);

struct SolvedMultiverse : results::Multiverse {
  // By part and metric: the mean of each run over its targets.
  std::vector<std::array<judge::Group, metrics_of_readings.size()>> means;
};

struct JudgedMultiverse {
  std::map<std::string, InReadings> in_readings;  // of claims, by id
  show::Table table;                              // "multiverse"; readings, each seed of one by itself
  std::string explains = {};                      // Explanation::in_short
};

// What readings explain of the table of means: which of its numbers may be theirs, with the runs of all seeds together.
struct Explanation {
  show::Table numbers;   // "explained": those that the default's cannot be, each with the fewest departures by which
  show::Table rows;      // "rows": of each solver, the best reading, and on whose row another of its readings is
  show::Table readings;  // "readings": of each solver, all that were tried, by how much of its own row they explain
  std::string in_short = {};  // a sentence: which reading has which number; empty if no number can be told
};

// Of readings with few departures (MultiverseRequest::departures), the default among them.
Explanation explained(const Paper& paper, const SolvedMultiverse& multiverse);

JudgedMultiverse judged(const Paper& paper, const SolvedMultiverse& multiverse, const results::Plan& plan);

}  // namespace ikbench::papers
