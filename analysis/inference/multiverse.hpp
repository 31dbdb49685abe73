// Claims between solvers judged in every universe: every combination of a choice for the study with one of each
// solver's own (Steegen et al., Perspectives on Psychological Science 11 (2016) 702). Given the study's choice the
// solvers are independent, so that universes are counted by products, exactly, and never listed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/metrics.hpp"
#include "results/analysis_plan.hpp"
#include "results/dimension.hpp"

namespace ikbench::inference {

struct Multiverse {
  using Alternative = results::Alternative;
  using Dimension = results::Dimension;
  using Choice = results::Choice;
  // One solver as one of its choices has it: by seed, a value a run.
  struct Own {
    std::vector<Choice> chosen;
    std::vector<std::vector<double>> error_cm, variation_deg;
  };
  // The universes of one choice for the study. They share its weight evenly.
  struct OfStudy {
    std::vector<Choice> chosen;
    double weight = 1;
    int out_of_reach = 0;
    std::vector<std::vector<Own>> solvers;  // by solver, by its own choice; the default first

    double universes() const;
  };
  std::vector<Dimension> dimensions;
  std::vector<std::string> solvers;
  std::vector<OfStudy> studies;  // the default first

  std::size_t seeds() const { return studies.front().solvers.front().front().error_cm.size(); }
  double universes() const;
};

// Position error and variation.
bool is_of_universes(Metric metric);
// One of these, by seed.
const std::vector<std::vector<double>>& values_of(const Multiverse::Own& own, Metric metric);

// What of the runs decides: their mean or, typical, their geometric mean. Either way by Games and Howell's test,
// Welch's t against the studentized range of all solvers: it takes the values of two solvers only, so that pairs can be
// counted by themselves. The level and the control are those of the study's plan.
enum class JudgedBy { mean, typical };

// A claim about one solver: better than a rival or, where none is named, than every other.
struct MultiverseClaim {
  std::string id;     // "most_accurate"
  std::string words;  // "IK-BA is the most accurate"
  std::string solver;
  std::string rival = {};
  Metric metric = Metric::position_error_cm;
  JudgedBy by = JudgedBy::mean;
  // Instead: that the solver is better with this dimension's default than with another alternative of it, all else the
  // same. It fails where these give the same bits. Universes with the default are not counted.
  std::string effect_of = {};
};

// Weights of the universes in which a claim holds (the solver is found better than each rival), fails (a rival is found
// better) and is undecided. Each seed is a study of its own, and counts as such.
struct UniverseCounts {
  double holds = 0, fails = 0, undecided = 0;
  void operator+=(const UniverseCounts& more);
  double all() const { return holds + fails + undecided; }
};

struct ClaimCounts {
  MultiverseClaim claim;
  UniverseCounts all;
  std::vector<UniverseCounts> seeds;
  // By dimension, by alternative; universes in which a dimension has no choice are in none of its counts.
  std::vector<std::vector<UniverseCounts>> alternatives;

  // The dimension between whose alternatives the share that holds differs most; the number of dimensions where it
  // differs between none.
  std::size_t deciding() const;
  double difference(std::size_t dimension) const;
};

// A claim whose solver, rival or dimension is not there has counts of 0.
std::vector<ClaimCounts> counted(const Multiverse& multiverse, const std::vector<MultiverseClaim>& claims,
                                 const results::AnalysisPlan& plan);

}  // namespace ikbench::inference
