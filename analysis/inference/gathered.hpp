// Facts taken from the angles, targets, traces and repeats of a study's solves while their records are read one by one.
// Afterwards a record is forgotten unless it is drawn. solve.hpp has the numbers of each solve.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <optional>
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
  double unavoidable_error_cm = 0;
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
  std::unordered_multimap<std::size_t, std::uint32_t> index_;  // by a hash of the bits
};

// Counts answers in which a joint is nearly straight: within near_deg of a multiple of 180 degrees.
struct Straight {
  static constexpr double near_deg = 5;
  int answers = 0, near = 0;
  double nearest_deg = std::numeric_limits<double>::infinity();
};

// A solve's longest and shortest repeat [s]. It is outlying if the longest takes more than `outlying` times the
// shortest.
constexpr double outlying = 3;
struct Outlier {
  std::uint16_t solver = 0;
  int run = 0, point = 0;
  double seconds = 0, usual = 0;
  bool is_repeated = false;
};

struct SolverFacts {
  double worst_outside_deg = 0;               // excess beyond the limit, worst joint
  std::vector<double> transport_shares = {};  // message share of each time of a program
  std::vector<Straight> joints = {};
  int outlying_repeats = 0;
};

// Smoothness of the joint angles of a run.
struct RunShape {
  std::uint16_t solver = 0;
  int run = 0, points = 0;
  double second_difference_deg = statistics::not_defined;  // mean norm over the joints that turn
  double return_deg = statistics::not_defined;             // defined if the last target equals the first
  double mean_bend_deg = statistics::not_defined;          // mean absolute second difference of all joints
};

struct Gathered {
  std::vector<std::string> labels = {};
  std::vector<std::int64_t> sessions = {};
  std::string robot = {};
  Problems problems = {};
  std::deque<Extras> extras = {};
  std::vector<SolverFacts> of_solver = {};   // one per label
  std::vector<RunShape> shapes = {};         // by solver and run
  std::set<std::size_t> joints = {};         // numbers of angles in starts and answers
  std::map<int, std::int64_t> repeats = {};  // number of solves by repeat count, among cleanly timed solves
  std::optional<double> interruptions = {};  // sum over all solves; nullopt if no solve has it
  std::optional<Outlier> worst_repeat = {};
  // Records of the first run of each solver, without traces.
  std::vector<results::SolveRecord> drawn = {};
};

// Gathers facts from solves that arrive ordered by solver, run and point.
class Gatherer {
 public:
  Gatherer(std::set<std::size_t> slides, bool starts_anew) : slides_(std::move(slides)), starts_anew_(starts_anew) {}

  // `solver`: its index among the caller's labels.
  Solve add(const results::SolveRecord& record, std::uint16_t solver);
  Gathered finish(std::vector<std::string> labels);

 private:
  struct Passed {
    std::vector<double> position_m, rotation;
  };

  bool is_following(const results::SolveRecord& record, std::uint16_t solver) const;
  void look_at_times(const results::SolveRecord& record, std::uint16_t solver, bool is_repeated);
  void look_at_answer(const results::SolveRecord& record, std::uint16_t solver);
  void keep_drawn(const results::SolveRecord& record, bool is_first_of_solver);
  std::uint16_t session_number(std::int64_t session);
  void end_run();
  double second_difference_deg() const;
  double mean_bend_deg() const;

  std::set<std::size_t> slides_;
  bool starts_anew_;
  Gathered gathered_;
  // State of the current run.
  std::uint16_t solver_ = 0;
  int run_ = 0, point_ = 0;
  std::vector<std::vector<double>> answers_;
  Passed first_, last_;
};

}  // namespace ikbench::inference
