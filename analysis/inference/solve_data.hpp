// Keeps what a study needs of its solves beside the numbers of each (solve.hpp). The records are read one by one, and
// forgotten unless they are drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "analysis/inference/solve.hpp"
#include "analysis/statistics/descriptive.hpp"
#include "results/record.hpp"

namespace ikbench::inference {

// The task of a solve. In a chained study, a start that equals the previous answer is not kept.
struct Problem {
  std::span<const double> target_position_m, target_rotation, start_rad;
  bool has_start = true;
};
bool same_target(const Problem& a, const Problem& b);
bool same_start(const Problem& a, const Problem& b);  // needs both starts

// Distinct problems, numbered from 0 in the order of their first solve.
class Problems {
 public:
  std::uint32_t number_of(const results::SolveRecord& solve, bool has_start);
  void forget_index();  // call after the last number_of()

  std::size_t size() const { return ends_.size(); }
  Problem operator[](std::size_t number) const;

 private:
  std::span<const double> list(std::size_t number) const;

  std::vector<double> numbers_, asked_;  // all lists joined, and the list that number_of() looks up
  std::vector<std::size_t> ends_;
  std::unordered_map<std::uint64_t, std::uint32_t> index_;  // by a hash of 64 bits
};

constexpr double much_longer = 3;

struct SolverFacts {
  double worst_outside_deg = 0;  // excess beyond the limit, worst joint
  int uneven_repeats = 0;        // solves whose longest repeat took more than `much_longer` times the shortest
};

// Mean absolute second difference of all joint angles of a run.
struct RunShape {
  std::uint16_t solver = 0;
  int run = 0;
  double mean_bend_deg = statistics::not_defined;
};

struct SolveData {
  std::vector<std::string> labels = {};
  std::vector<std::int64_t> sessions = {};
  std::string robot = {};
  Problems problems = {};
  std::deque<RareData> rare = {};
  std::vector<SolverFacts> of_solver = {};  // one per label
  std::vector<RunShape> shapes = {};        // by solver and run
  std::set<std::size_t> joints = {};        // numbers of angles in starts and answers
  // Records of the first run of each solver, without traces.
  std::vector<results::SolveRecord> drawn = {};
};

}  // namespace ikbench::inference
