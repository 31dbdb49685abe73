// Studies small enough to be run many times.
#pragma once

#include <string>
#include <vector>

#include "experiments/runner.hpp"
#include "experiments/study.hpp"
#include "tests/results/samples.hpp"

namespace ikbench {

// Two runs of three solvers over four points of the paper's helix: 24 solves.
inline Study small_study() {
  Study study;
  study.name = "small";
  study.path = Helix{.points = 4};
  study.initial = Eigen::VectorXd::Zero(7);
  study.population = 6;
  study.stop.iterations = 5;
  study.runs = 2;
  study.solvers = {{"IK-BA", "ik_bat", {}}, {"BA", "bat", {}}, {"DE", "differential_evolution", {}}};
  return study;
}

// A solve without what differs from one run of the program to the next.
inline SolveRecord without_times(SolveRecord record) {
  record.seconds = 0;
  record.cpu_seconds = 0;
  record.timing = Timing::clean;
  record.session = 0;
  return record;
}

inline bool same_numbers(const std::vector<SolveRecord>& a, const std::vector<SolveRecord>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](const auto& x, const auto& y) {
           return same(without_times(x), without_times(y));
         });
}

// The solves of a study that is run into a store of its own.
inline std::vector<SolveRecord> solves_of(const Study& study, int jobs = 1) {
  const ScratchFolder folder;
  Store store(folder.path / "store.sqlite", Store::Mode::write);
  run(study, store, {.jobs = jobs});
  return store.solves(study.name);
}

inline std::vector<SolveRecord> only(const std::string& solver, const std::vector<SolveRecord>& records) {
  std::vector<SolveRecord> chosen;
  for (const SolveRecord& record : records) {
    if (record.solver == solver) chosen.push_back(record);
  }
  return chosen;
}

}  // namespace ikbench
