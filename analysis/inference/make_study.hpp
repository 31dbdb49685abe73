// Studies made of their solves, which are read one after another and condensed (solve.hpp, gathered.hpp).
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/inference/gathered.hpp"
#include "analysis/inference/study.hpp"
#include "results/record.hpp"
#include "results/store.hpp"

namespace ikbench::inference {

// Takes the solves of a study by solver, run and point, as Store::each_of_study passes them on. Numbers of runs and
// points come from the definition, or where it does not say, from the solves. A solve twice in the records, runs beyond
// 1 to 1000000, points beyond 1 to 100000, more than 1000 solvers or 100000000 expected solves are
// std::invalid_argument.
class StudyMaker {
 public:
  // Memory for `solves` is taken at once.
  explicit StudyMaker(const results::StudyEntry& entry, std::size_t solves = 0);
  explicit StudyMaker(std::string name);  // without a definition (a CSV of solves)

  void add(const results::SolveRecord& record);
  StudyResults finish(const std::vector<results::Session>& sessions = {});

 private:
  void check(const results::SolveRecord& record) const;
  std::uint16_t number_of(const std::string& solver);

  StudyResults study_;
  std::vector<results::Series> series_ = {};  // of the study's definition
  std::vector<Solve> solves_;
  Gatherer gatherer_;
};

StudyResults make_study(const results::StudyEntry& entry, std::vector<results::SolveRecord> solves,
                        const std::vector<results::Session>& sessions = {});
// Solvers in the order of their first solve.
StudyResults make_study(std::string name, std::vector<results::SolveRecord> solves);
// With all its solves in the store.
StudyResults read_study(const results::Store& store, const results::StudyEntry& entry);

}  // namespace ikbench::inference
