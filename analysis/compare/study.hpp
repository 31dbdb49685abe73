// A study as it is judged: its definition, its plan and all of its solves.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/definition.hpp"
#include "results/record.hpp"
#include "results/store.hpp"

namespace ikbench::compare {

struct StudyResults {
  results::StudyEntry entry;                 // name, definition as JSON, series
  results::Definition definition;            // the same, read
  std::vector<std::string> solvers;          // labels, in the order of the study
  int runs = 0, points = 0;                  // as defined
  std::vector<results::SolveRecord> solves;  // by solver, run and point; only current ones
  std::vector<results::Session> sessions;    // that made them

  // By run and point.
  std::span<const results::SolveRecord> of(std::string_view solver) const;
};

// Reads the current solves of a study. Throws std::invalid_argument for more than `most_solves`.
constexpr std::int64_t most_solves = 2'000'000;
StudyResults read_study(const results::Store& store, const results::StudyEntry& entry);

}  // namespace ikbench::compare
