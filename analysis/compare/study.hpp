// A study as it is judged: its definition, its plan and all of its solves.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/definition.hpp"
#include "results/record.hpp"
#include "results/store.hpp"

namespace ikbench::compare {

struct StudyResults {
  results::StudyEntry entry;                  // name, definition as JSON, series
  results::Definition definition;             // the same, read; a control that is no solver is empty
  std::vector<std::string> solvers;           // labels, in the order of the study
  int runs = 0, points = 0;                   // as defined
  std::vector<results::SolveRecord> solves;   // by solver, run and point; only current ones
  std::vector<results::Session> sessions;     // that made them
  bool had_same_targets = true;               // all solvers, and where solves are not chained the same starts
  std::int64_t solves_of_other_versions = 0;  // that stand in the store instead of missing ones
  std::vector<std::string> solvers_of_other_versions = {};  // whose these are

  // By run and point.
  std::span<const results::SolveRecord> of(std::string_view solver) const;
};

// Reads the current solves of a study. Throws std::invalid_argument for more than `most_solves`.
constexpr std::int64_t most_solves = 2'000'000;
StudyResults read_study(const results::Store& store, const results::StudyEntry& entry);
// The same from records in any order. Solvers that the entry lacks follow.
StudyResults study_of(const results::StudyEntry& entry, std::vector<results::SolveRecord> solves,
                      const std::vector<results::Session>& sessions = {});

}  // namespace ikbench::compare
