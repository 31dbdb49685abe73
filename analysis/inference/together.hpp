// The observations of several studies as one set, so that the one engine judges all of them by one test. A set has the
// groups that all studies have. Where the studies have blocks, its blocks are theirs: a block is a problem of a study.
// Else runs are the unit: run r of the set is the mean over the studies of run r's values, of the typical value the
// mean of logarithms. Studies that are one study with several seeds are the blocks themselves: the value of a block is
// the mean over the runs of that seed.
#pragma once

#include <string>
#include <vector>

#include "analysis/inference/judged_study.hpp"
#include "analysis/inference/observations.hpp"

namespace ikbench::inference {

struct OfStudy {
  std::string study;
  Observations observations;
};

// All have blocks, or none has; seeds have none. Runs beyond those of the study with the fewest count nowhere, and a
// note says so.
Observations together(std::vector<OfStudy> all, bool are_seeds = false);

// A metric by an estimand: by blocks if every study has them or is a seed, else by runs. Its name begins with
// "together-".
Observations together(const JudgedStudies& studies, Metric metric, results::Estimand estimand, bool are_seeds = false);

// Names what is judged over all studies: the metrics and estimands that each of them judges, the deciding one first.
struct Judged {
  Metric metric;
  results::Estimand estimand;
};
std::vector<Judged> judged_together(const JudgedStudies& studies);

}  // namespace ikbench::inference
