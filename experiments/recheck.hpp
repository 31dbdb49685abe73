// Whether what a store says of its solves follows from what was asked and answered. Anybody may have written it.
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

// The arm as the definition of a stored study has it, to the rounding of its degrees; empty where it has none that can
// be read.
std::optional<robots::Robot> stored_arm(const results::StudyEntry& entry);

// A value of a definition as TOML has it, in a line and without names; std::invalid_argument where it is nested deeper
// than that.
std::string toml_of(const nlohmann::json& json, int levels = 4);

// What that asks of every answer; the error of a whole pose is claimed, but not stored.
Requirement requirement_of(const results::StudyEntry& entry);

// Of a solve as it is stored, which has the sizes of one.
robots::Pose target_of(const results::SolveRecord& solve);

// What does not fit of the errors, moves, limits, counts and times of a study's solves, which are looked at one after
// another: errors, moves, violations and the status are computed again from arm, target, start and answer; counts and
// times must be possible; targets and starts must be those of the definition, as far as it gives them; a solve with a
// digest must have that of its columns.
class Recheck {
 public:
  explicit Recheck(const results::StudyEntry& entry);
  ~Recheck();

  void look_at(const results::SolveRecord& solve);
  // A sentence for each column, with the first solve of which it is so; none where all fits.
  std::vector<std::string> damages() const;

 private:
  struct Looking;
  std::unique_ptr<Looking> looking_;
};

}  // namespace ikbench::experiments
