// The targets and starts of a stored study, drawn again from its definition.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "experiments/study.hpp"
#include "results/store.hpp"

namespace ikbench::experiments {

// Looks at the solves of a study in the order of solver, run and point.
class AskedAgain {
 public:
  // Where another version of the source solved the study, or its definition cannot be read, nothing is drawn; neither
  // are the targets of a file, and those of the later runs where they are very many.
  AskedAgain(const results::StudyEntry& entry, const robots::Robot& arm);

  // The column in which the solve has something else than the definition gives; null where there is none, or where the
  // solve lacks numbers.
  const char* other_than_asked(const results::SolveRecord& solve);

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
  Place next_;                         // after the last solve
  robots::Configuration where_it_is_;  // the arm, after that
};

}  // namespace ikbench::experiments
