// All combinations of what a paper leaves open, and the series that have to be solved to judge claims in each of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "experiments/dimensions.hpp"

namespace ikbench::experiments {

// Series that something needs, each once: the numbers of a solver are decided by its series key, so that combinations
// which do not differ for it share them.
class SeriesList {
 public:
  // The place in `parts` of one solver of the study.
  std::size_t add(const Study& study, std::size_t solver);
  std::vector<Study> parts;  // one solver, one seed each, in the order in which they were first needed

 private:
  std::map<std::string, std::size_t> known_;  // series key to place
};

// "seed=77" among overrides is std::invalid_argument: what counts seeds sets them.
void refuse_seed(const Overrides& overrides);

// A universe is a choice for the study and, for each solver, one of its own. Solvers are independent given the study's
// choice, so that each is solved by itself and no universe ever as a whole. A dimension is among the choices only where
// it has an alternative besides its default (Alternative::except). The default comes first. The study's choices weigh
// by equal parts: in each dimension its alternatives share the weight of what was chosen before it, so that a detail
// that only one of them has changes nothing for the others.
struct MultiversePlan {
  struct Own {
    Chosen chosen;
    std::vector<std::size_t> parts;  // by seed; indices of MultiversePlan::parts
  };
  struct OfStudy {
    Chosen chosen;
    double weight = 1;                      // all together 1
    int out_of_reach = 0;                   // targets that no configuration reaches
    std::vector<std::vector<Own>> solvers;  // in the order of `solvers`
  };
  std::vector<Dimension> dimensions;
  std::vector<std::string> solvers;
  std::vector<OfStudy> studies;
  std::vector<Study> parts;  // empty where only the size was asked for
};

// Before anything is loaded or solved: how many there are. More than 100000 choices or series for a seed, or more
// than 10^15 universes, are std::invalid_argument.
struct MultiverseSize {
  std::int64_t studies = 0, series = 0, universes = 0;
};
MultiverseSize size_of(const std::vector<Dimension>& dimensions, const std::vector<std::string>& solvers);

// `overrides` hold in every universe; the seeds are 1 to `seeds`. An override of what a dimension varies is
// std::invalid_argument.
MultiversePlan plan_multiverse(const std::string& study, const std::vector<Dimension>& dimensions, int seeds,
                               const Overrides& overrides = {});

}  // namespace ikbench::experiments
