// Makes studies from their solves, which are read one by one and condensed (solve.hpp, solve_data.hpp).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/inference/solve_data.hpp"
#include "analysis/inference/study.hpp"
#include "results/record.hpp"
#include "results/store.hpp"

namespace ikbench::inference {

// Takes the solves of a study by solver, run and point, as Store::each_of_study passes them on. Numbers of runs and
// points come from the definition, or else from the solves. Throws std::invalid_argument for a solve recorded twice,
// runs beyond 1 to 1000000, points beyond 1 to 100000, more than 1000 solvers or 100000000 expected solves.
class StudyMaker {
 public:
  // Reserves memory for `solves` solves.
  explicit StudyMaker(const results::StudyEntry& entry, std::size_t solves = 0);

  void add(const results::SolveRecord& record);
  StudyResults finish(const std::vector<results::Session>& sessions = {});

 private:
  void check(const results::SolveRecord& record) const;
  std::uint16_t number_of(const std::string& solver);
  // Takes the facts from a record (solve_data.cpp).
  Solve condensed(const results::SolveRecord& record, std::uint16_t solver);
  bool is_following(const results::SolveRecord& record, std::uint16_t solver) const;
  void look_at(const results::SolveRecord& record, std::uint16_t solver);
  void keep_drawn(const results::SolveRecord& record, bool is_first_of_solver);
  std::uint16_t session_number(std::int64_t session);
  void end_run();

  StudyResults study_;
  std::vector<results::Series> series_ = {};  // from the study's definition
  std::vector<Solve> solves_;
  SolveData data_;
  std::vector<std::vector<double>> answers_;  // of the current run
};

StudyResults make_study(const results::StudyEntry& entry, std::vector<results::SolveRecord> solves,
                        const std::vector<results::Session>& sessions = {});
// Makes a study without a definition (a CSV of solves). Orders solvers by their first solve.
StudyResults make_study(std::string name, std::vector<results::SolveRecord> solves);
// Reads all solves of the study from the store.
StudyResults read_study(const results::Store& store, const results::StudyEntry& entry);

}  // namespace ikbench::inference
