// All combinations of what a paper leaves open, and the series that have to be solved to judge claims in each of them.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "experiments/dimensions.hpp"

namespace ikbench::experiments {

// A universe is a choice for the study and, for each solver, one of its own. Solvers are independent given the study's
// choice, so that each is solved by itself and no universe ever as a whole. A dimension is among the choices only where
// it has an alternative besides its default (Alternative::except). The default comes first. The study's choices weigh
// by equal parts: in each dimension its alternatives share the weight of what was chosen before it, so that a detail
// that only one of them has changes nothing for the others.
struct MultiversePlan {
  struct Own {
    results::Chosen chosen;
    std::vector<std::size_t> parts;  // by seed; indices of MultiversePlan::parts
  };
  struct OfStudy {
    results::Chosen chosen;
    double weight = 1;                      // all together 1
    int out_of_reach = 0;                   // targets that no configuration reaches
    std::vector<std::vector<Own>> solvers;  // in the order of `solvers`
  };
  std::vector<results::Dimension> dimensions;
  std::vector<std::string> solvers;
  std::vector<OfStudy> studies;
  // One solver and one seed each, each series once, in the order in which they are first needed: the numbers of a
  // solver are decided by its series key, so that choices which do not differ for it share them.
  std::vector<Study> parts;
};

// every: all that go together. one_at_a_time: the default, and each other alternative alone beside it. Then a choice
// of the study has the solvers' defaults only, and with the default one the choices of solvers are not combined.
enum class Combined { every, one_at_a_time };

// Before anything is loaded or solved: how many there are. More than 100000 choices or series for a seed, or more
// than 10^15 universes, are std::invalid_argument.
struct MultiverseSize {
  std::int64_t studies = 0, series = 0, universes = 0;
};
MultiverseSize size_of(const std::vector<results::Dimension>& dimensions, const std::vector<std::string>& solvers,
                       Combined combined = Combined::every);

struct MultiverseRequest {
  int seeds = 1;             // from 1 on
  Overrides overrides = {};  // hold in every universe
  Combined combined = Combined::every;
  const std::atomic<bool>* cancelled = nullptr;  // what is planned by then is of no use
};

// An override of a seed, or of what a dimension varies, is std::invalid_argument.
void refuse_varied(const Overrides& overrides, const std::vector<results::Dimension>& dimensions);

// The overrides are checked.
MultiversePlan plan_multiverse(const std::string& study, const std::vector<results::Dimension>& dimensions,
                               const MultiverseRequest& request = {});

}  // namespace ikbench::experiments
