// Checks that a store's numbers follow from the questions and answers in it. Stores are not trusted.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "experiments/verifier.hpp"
#include "results/store.hpp"
#include "robots/chain.hpp"

namespace ikbench::experiments {

// The study requires this of every answer. The store has the claimed position error, but not the claimed pose error.
Requirement requirement_of(const results::StudyEntry& entry);

// The target of a stored solve whose lists have the right sizes.
robots::Pose target_of(const results::SolveRecord& solve);

// Finds contradictions in a study's solves, one after another. It computes errors, moves, violations and status again
// from arm, target, start and answer. Counts and times must be possible. Targets and starts must be those of the
// definition, as far as it gives them. A solve with a digest must have the digest of its columns.
class Recheck {
 public:
  explicit Recheck(const results::StudyEntry& entry);
  ~Recheck();

  void look_at(const results::SolveRecord& solve);
  // One sentence per damaged column, with its first such solve; none if all fits.
  std::vector<std::string> damages() const;

 private:
  struct Looking;
  std::unique_ptr<Looking> looking_;
};

}  // namespace ikbench::experiments
