// The lock of a paper: what its text leaves open of a study's set-up, and which set-up gives the printed integers or,
// in a table without integers, the most numbers within the range of chance.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "analysis/report/table.hpp"
#include "results/record.hpp"

namespace ikbench::report {

// An open point of the set-up, and what it may be; the study has the first.
struct SetUpPoint {
  struct Alternative {
    std::vector<std::string> set = {};  // arguments of --set; none for the first
    std::string where = {};             // completes "... where"
  };
  std::string open = {};
  std::vector<Alternative> alternatives = {};
};

// Counts the printed numbers that ours round to.
struct PrintedNumbers {
  int integers = 0, agreeing_integers = 0, numbers = 0, agreeing = 0;
  int by_chance = 0;  // without integers: how many are within the range of chance
};

struct Lock {
  std::string study = {};
  std::vector<std::string> solvers = {};  // those whose numbers last bits leave as they are
  std::vector<SetUpPoint> points = {};
  // Compares the solves of these solvers, in any order.
  std::function<PrintedNumbers(std::span<const results::SolveRecord>)> compared = {};
};

// A set-up: the alternative of each point, by index.
using SetUp = std::vector<std::size_t>;
std::vector<SetUp> set_ups(const Lock& lock);  // all, the study's own first
std::vector<std::string> overrides_of(const Lock& lock, const SetUp& chosen);

// `found` are the printed numbers of set_ups(lock), in their order.
Table lock_table(const Lock& lock, std::span<const PrintedNumbers> found);
// Names the set-up that the printed numbers single out.
std::string lock_sentence(const Lock& lock, std::span<const PrintedNumbers> found);

}  // namespace ikbench::report
