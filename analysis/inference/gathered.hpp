// What the analysis knows of a study's solves beside their numbers (solve.hpp): what it takes from angles, targets,
// traces and repeats while the records are read one after another. A record is forgotten then, unless it is drawn.
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

// What a solve was asked for. A start that is the answer to the point before is not kept, where the study lets each
// solve start there.
struct Problem {
  std::span<const double> target_position_m, target_rotation, start_rad;
  double unavoidable_error_cm = 0;
  bool has_start = true;
};
bool same_target(const Problem& a, const Problem& b);
bool same_start(const Problem& a, const Problem& b);  // of which both are kept

// Problems, each once, numbered from 0 in the order in which they are met.
class Problems {
 public:
  std::uint32_t number_of(const results::SolveRecord& solve, bool has_start);
  void forget_index();  // after the last

  std::size_t size() const { return ends_.size(); }
  Problem operator[](std::size_t number) const;

 private:
  std::span<const double> list(std::size_t number) const;

  std::vector<double> numbers_, asked_;  // one list after another, and the one that is looked for
  std::vector<std::size_t> ends_;
  std::unordered_multimap<std::size_t, std::uint32_t> index_;  // by a hash of the bits
};

// Answers in which a joint is nearly straight: within near_deg of a multiple of 180 degrees.
struct Straight {
  static constexpr double near_deg = 5;
  int answers = 0, near = 0;
  double nearest_deg = std::numeric_limits<double>::infinity();
};

// The longest that a solve took in one of its repeats, and its shortest; outlying where that is more than `outlying`
// times as long.
constexpr double outlying = 3;
struct Outlier {
  std::uint16_t solver = 0;
  int run = 0, point = 0;
  double seconds = 0, usual = 0;
  bool is_repeated = false;
};

struct SolverFacts {
  double worst_outside_deg = 0;               // of the worst joint
  std::vector<double> transport_shares = {};  // of the times of a program
  std::vector<Straight> joints = {};
  int outlying_repeats = 0;
};

// How the angles of a run go.
struct RunShape {
  std::uint16_t solver = 0;
  int run = 0, points = 0;
  double second_difference_deg = statistics::not_defined;  // mean norm over the joints that turn
  double return_deg = statistics::not_defined;             // where the last target is the first one again
  double mean_bend_deg = statistics::not_defined;          // mean absolute second difference of all joints
};

struct Gathered {
  std::vector<std::string> labels = {};
  std::vector<std::int64_t> sessions = {};
  std::string robot = {};
  Problems problems = {};
  std::deque<Extras> extras = {};
  std::vector<SolverFacts> of_solver = {};   // as labels
  std::vector<RunShape> shapes = {};         // by solver and run
  std::set<std::size_t> joints = {};         // how many angles starts and answers have
  std::map<int, std::int64_t> repeats = {};  // how often, of the solves that are timed clean
  std::optional<double> interruptions = {};  // of all solves, where it is known of any
  std::optional<Outlier> worst_repeat = {};
  // Of the first run of each solver, without traces.
  std::vector<results::SolveRecord> drawn = {};
};

// Gathers from the solves of a study that are passed on by solver, run and point.
class Gatherer {
 public:
  Gatherer(std::set<std::size_t> slides, bool starts_anew) : slides_(std::move(slides)), starts_anew_(starts_anew) {}

  // `solver`: its place among the labels, which the caller keeps.
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
  // The run that is passed on.
  std::uint16_t solver_ = 0;
  int run_ = 0, point_ = 0;
  std::vector<std::vector<double>> answers_;
  Passed first_, last_;
};

}  // namespace ikbench::inference
