// Counts the universes in which each claim of a paper holds.
#pragma once

#include <string>
#include <vector>

#include "analysis/claims/claims_file.hpp"
#include "analysis/claims/explained.hpp"
#include "analysis/inference/multiverse.hpp"
#include "results/analysis_plan.hpp"

namespace ikbench::claims {

// Weights of the universes in which a claim holds (its solver, or each of several, is found better than each rival),
// fails (a rival is found better) and is undecided. Each seed counts as a study of its own.
struct UniverseCounts {
  double holds = 0, fails = 0, undecided = 0;
  void operator+=(const UniverseCounts& more);
  double all() const { return holds + fails + undecided; }
};

struct ClaimCounts {
  std::string id;     // "most_accurate", or by geometric means "most_accurate_typically"
  std::string words;  // "IK-BA is the most accurate"
  UniverseCounts all = {};
  std::vector<UniverseCounts> seeds = {};
  UniverseCounts fitting = {};  // of `all`, the universes that fit the printed numbers
  // By dimension and alternative; a dimension does not count universes that make no choice in it.
  std::vector<std::vector<UniverseCounts>> alternatives = {};

  // The dimension whose alternatives change the share that holds most; the number of dimensions if none changes it.
  std::size_t deciding() const;
  double difference(std::size_t dimension) const;
};

// Counts the universes of each claim by each of its averages of the runs (ClaimEntry::universes); 0 if its solver or
// rival is missing. A claim holds if the solver is found better than the one that it is compared with or,
// if none is named, than every other. Means and typical values are tested by Games and Howell's test: Welch's t against
// the studentized range of all solvers. It needs the values of two solvers only, so pairs can be counted alone. Level
// and control come from the study's plan.
std::vector<ClaimCounts> counted(const inference::Multiverse& multiverse, const std::vector<ClaimEntry>& entries,
                                 const results::AnalysisPlan& plan, const Fit& fit = {});

}  // namespace ikbench::claims
