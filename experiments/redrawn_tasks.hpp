// The targets and starts of a stored study, drawn again from its definition.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "experiments/study.hpp"
#include "results/store.hpp"

namespace ikbench::experiments {

// Compares the stored solves of a study, in the order of solver, run and point, with what the definition asks.
class RedrawnTasks {
 public:
  // Draws nothing if another version of the source solved the study, if its definition cannot be read, or if its arm is
  // from a URDF file. Skips later runs once very many targets are drawn.
  RedrawnTasks(const results::StudyEntry& entry, const robots::Robot& arm);

  // The column in which the solve differs from the definition; null if none does, or if its lists have wrong sizes.
  const char* differing_column(const results::SolveRecord& solve);

 private:
  struct Run {
    std::vector<robots::Pose> targets;
    std::vector<robots::Configuration> starts;
  };
  const Run* drawn(int run);
  bool has_its_target(const results::SolveRecord& solve);
  bool has_its_start(const results::SolveRecord& solve);

  Study study_;
  robots::Robot arm_;
  bool is_drawn_ = false;
  std::map<int, Run> runs_ = {};
  struct Place {
    std::string series;
    int run = 0, point = 0;
    bool operator==(const Place&) const = default;
  };
  Place next_;                         // the place after the last solve
  robots::Configuration where_it_is_;  // the arm's configuration after the last solve
};

}  // namespace ikbench::experiments
