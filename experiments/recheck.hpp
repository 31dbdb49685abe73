// Checks that a store's numbers follow from the questions and answers in it. Stores are not trusted.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "experiments/verifier.hpp"
#include "results/store.hpp"
#include "robots/robot.hpp"

namespace ikbench::experiments {

// The arm in the definition of a stored study, to the rounding of its degrees; empty if none can be read.
std::optional<robots::Robot> stored_arm(const results::StudyEntry& entry);

// A value of a definition as one line of TOML, without names; std::invalid_argument if it is nested deeper than
// `levels`.
std::string toml_of(const nlohmann::json& json, int levels = 4);

// What the study requires of every answer. The store has the claimed position error, but not the claimed pose error.
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
