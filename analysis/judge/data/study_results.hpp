// A study as it is judged: its definition, its plan and all of its solves.
//
// A study may have millions of solves. A record takes about 1 kB, so judging keeps numbers of each and a hash of its
// lists, 150 bytes: a million within 400 MB. Whole records are kept only of what figures draw.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/judge/data/samples.hpp"
#include "results/record.hpp"
#include "results/store.hpp"

namespace ikbench::judge {

// What judging needs of a solve; the columns of results/columns.inc have the same names.
struct SolveSummary {
  int run = 1, point = 1;
  int label = 0;  // its place in StudyResults::labels
  int session = 0, restarts = 0;
  results::Status status = results::Status::ok;
  results::StopReason stop_reason = results::StopReason::iterations;
  results::Timing timing = results::Timing::clean;
  results::CountedBy counted_by = results::CountedBy::ikbench;
  bool is_outside_limits = false;
  bool was_preempted = false;  // took more than 10 % longer than its processor time; of solves at once not known
  bool is_self_timed = false;  // by a program: its own time, for which its processor time leaves room
  // Of a control loop: longer than its period, where times count; further than a joint can move in one.
  bool missed_deadline = false, exceeds_velocity = false;
  double position_error_cm = 0, orientation_error_deg = 0, variation_deg = 0, variation_m = 0;
  double largest_move_deg = 0, seconds = 0;  // of a single call; NaN: in a batch
  double second_difference_deg = 0;  // mean second difference of all joint angles of its run until here; NaN: not known
  std::int64_t evaluations = 0, iterations = 0;
  std::uint64_t target = 0, start = 0, answer = 0;  // hashes of the bits of position and rotation, and of all joints
  std::vector<double> check_values = {};            // of the study's check, if it was asked
};

using Solves = std::span<const SolveSummary>;

// Solvers of another machine (beside.hpp), which belong to no session.
struct ImportedResults {
  std::string origin = {};         // "on another machine, 11/2026"
  bool is_control_chosen = false;  // the plan had none, so that the study's first solver is the control
  std::vector<std::string> labels = {};
  std::string local_reference = {};  // the LM with the same options as one there; empty: none
  double reference_seconds = 0;      // [s] of that one there

  bool has(std::string_view label) const { return std::ranges::count(labels, label) > 0; }
};
constexpr std::string_view time_reference_solver = "levenberg_marquardt";

// A control that is no solver is empty in its plan.
struct StudyResults : results::StoredStudy {
  std::vector<std::string> labels;   // of its solvers, in the order of the study
  std::vector<SolveSummary> solves;  // by solver, run and point; only current ones
  std::vector<results::SolveRecord>
      plotted;                             // whole, in this order: the first run of each solver, and all with a trace
  std::vector<results::Session> sessions;  // that made them
  std::map<std::string, std::map<std::string, std::vector<double>>> extras;  // by name and solver; finite ones
  std::map<std::string, std::map<std::string, int>> rejections;  // by solver: of answers that the study's check refused
  // By solver that was asked in batches: their sizes, and the parts of their times [s] of each pose.
  std::map<std::string, std::pair<std::set<int>, std::vector<double>>> batch_timings;
  ImportedResults imported = {};
  Warning stale_solves = {.kind = WarningKind::stale_solves};  // solves that stand in the store instead of missing ones

  // By run and point.
  Solves of(std::string_view solver) const;
  // Of its first run.
  std::span<const results::SolveRecord> first_run_of(std::string_view solver) const;
};

bool has_answer(const SolveSummary& solve);
std::vector<double> solve_times(const StudyResults& study, std::string_view solver);  // [s] of solves with an answer
// All solves are the same, bit for bit, and took as many evaluations.
bool are_identical(Solves solves, Solves others);

std::vector<Solves> runs_of(Solves solves);
std::vector<Solves> complete_runs_of(const StudyResults& study, std::string_view solver);  // with all targets
// The same targets and answers in every run, bit for bit. Such runs are copies where a run is an observation.
bool repeats_itself(const StudyResults& study, std::string_view solver);

// What sessions say of one fact of their environment, such as "cpu".
std::set<std::string> environment_values(const StudyResults& study, const std::string& name);

constexpr int min_sessions = 4;  // that compare times

// Of one clock: all but those of stores that a former version began.
bool uses_current_clock(const results::Session& session);
// "first calls on a target": which calls this clock timed; empty: none.
std::string timed_calls_text(const StudyResults& study);
// What times are compared by; lists are by solver.
struct SessionSets {
  std::set<int> comparable = {};             // of this clock
  std::vector<std::set<int>> all = {};       // of its solves
  std::vector<std::set<int>> complete = {};  // of these: compared, and it made as many solves as anybody
  std::vector<std::set<int>> quiet = {};  // of these: not over a tenth took over a tenth more than their processor time
};
SessionSets session_sets(const StudyResults& study);

constexpr std::int64_t max_solves = 10'000'000;
constexpr int max_plotted = 10'000;  // of a first run
constexpr std::size_t max_traces = 2'000'000;
constexpr int max_extras = 50;  // names; more are left out

// Reads the current solves of a study, and passes each on to `also`. Throws std::invalid_argument for more than
// `most_solves`, or more than `max_traces` with a trace; and, as all do, if solvers had other targets or starts.
StudyResults read_study(const results::Store& store, const results::StoredStudy& entry,
                        const results::SolveVisitor& also = {});
// Throws std::invalid_argument: no solver chooses its targets, nor its starts, but those that its own answers left.
void require_same_targets(const StudyResults& study);

}  // namespace ikbench::judge
