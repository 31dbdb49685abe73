// A study as it is judged: its definition, its plan and all of its solves, which `read_study` takes from a store.
// A stored record takes about 1 kB, and a study may have millions. So only numbers and hashes of each solve are kept,
// 150 bytes per solve: a million solves need less than 400 MB. Full records are kept only for figures.
#pragma once

#include <algorithm>
#include <array>
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

// The part of a solve that judging needs. Members have the names of the columns in results/columns.inc.
struct SolveSummary {
  int run = 1, point = 1;
  int label = 0;  // index in StudyResults::labels
  int session = 0, restarts = 0;
  results::Status status = results::Status::ok;
  results::StopReason stop_reason = results::StopReason::iterations;
  results::Timing timing = results::Timing::clean;
  results::CountedBy counted_by = results::CountedBy::ikbench;
  bool is_outside_limits = false;
  bool was_preempted = false;     // took more than 10 % longer than its processor time; false if that is not known
  bool is_self_timed = false;     // the time is self-reported by an external solver, and credible
  bool missed_deadline = false;   // took longer than the period of the control loop
  bool exceeds_velocity = false;  // moved a joint further than it can within this period
  double position_error_cm = 0, orientation_error_deg = 0, variation_deg = 0, variation_m = 0;
  double largest_move_deg = 0;
  double seconds = 0;                // of a single call; NaN: solved in a batch
  double second_difference_deg = 0;  // mean of all joint angles of the run until this solve; NaN: not known
  std::int64_t evaluations = 0, iterations = 0;
  std::uint64_t target = 0, start = 0, answer = 0;  // hashes of the bits of position and rotation, and of all joints
  std::vector<double> check_values = {};            // numbers of the study's check, if it was asked
};

using Solves = std::span<const SolveSummary>;

// Solvers of another machine (imported.hpp), which belong to no session.
struct ImportedResults {
  std::string origin = {};         // "on another machine, 11/2026"
  bool is_control_chosen = false;  // the plan had no control, so that the study's first solver is the control
  std::vector<std::string> labels = {};
  std::string local_reference = {};  // the study's LM with the options of an imported LM; empty: none
  double reference_seconds = 0;      // median time of that imported LM [s]

  bool has(std::string_view label) const { return std::ranges::count(labels, label) > 0; }
};
constexpr std::string_view time_reference_solver = "levenberg_marquardt";

// A stored study with its solves. If the plan's control is not among the solvers, `read_study` clears the control.
struct StudyResults : results::StoredStudy {
  std::vector<std::string> labels;   // solvers, in the order of the study
  std::vector<SolveSummary> solves;  // ordered by solver, run and point; none of another version
  // Full records for figures: the first run of each solver, and every solve with a trace; in the order of the solves.
  std::vector<results::SolveRecord> plotted;
  std::vector<std::array<double, 2>> grid_places;  // of a grid: each target's place in the plane [m], by point
  std::vector<results::Session> sessions;          // those that made the solves
  std::map<std::string, std::map<std::string, std::vector<double>>> extras;  // by name and solver; finite values
  std::map<std::string, std::map<std::string, int>> rejections;  // by solver and reason: answers that the check refused
  // By solver that was asked in batches: the sizes of the batches, and the time per pose [s].
  std::map<std::string, std::pair<std::set<int>, std::vector<double>>> batch_timings;
  results::CountedAnswers answers = {};  // empty if the answers were not counted
  bool has_several_answers = false;      // a solver gave all of its answers
  ImportedResults imported = {};
  Warning stale_solves = {.kind = WarningKind::stale_solves};  // solves of another version, which are ignored

  // Returns the solves of a solver, ordered by run and point; empty if there is no such solver.
  Solves of(std::string_view solver) const;
  // Returns the plotted records of the first run of a solver.
  std::span<const results::SolveRecord> first_run_of(std::string_view solver) const;
};

bool has_answer(const SolveSummary& solve);
// Returns the finite times [s] of solves with an answer.
std::vector<double> solve_times(const StudyResults& study, std::string_view solver);
// Returns the solvers whose process failed in every solve: by a crash, a timeout or a breach of the protocol. A solver
// that misses all targets, or declines them, does answer.
std::vector<std::string> never_answering(const StudyResults& study);
// Returns whether all solves are the same, bit for bit, with the same numbers of evaluations.
bool are_identical(Solves solves, Solves others);

// Splits solves of one solver into runs.
std::vector<Solves> runs_of(Solves solves);
// Returns the runs of a solver that have all targets.
std::vector<Solves> complete_runs_of(const StudyResults& study, std::string_view solver);
// Returns whether a solver is deterministic: all of at least two complete runs have the same targets and answers, bit
// for bit. Where a value is a run, such runs are copies.
bool is_deterministic(const StudyResults& study, std::string_view solver);

// Returns all values that the sessions have for a fact of their environment, such as "cpu".
std::set<std::string> environment_values(const StudyResults& study, const std::string& name);

constexpr int min_sessions = 4;  // fewer sessions compare no times

// The solvers of a warm study, by the calls that were timed. Solvers whose solves are imported, in batches or made
// elsewhere are in neither list.
struct WarmStudySolvers {
  std::vector<std::string> warm = {};
  // Programs that, on more than a tenth of their targets, did not time a second solve in their own process.
  std::vector<std::string> through_pipe = {};
};
// Returns empty lists for a study that is not warm.
WarmStudySolvers solvers_of_warm_study(const StudyResults& study);
// Returns which calls were timed, such as "first calls on a target"; empty if no session says it.
std::string timed_calls_text(const StudyResults& study);
// The sessions by which times are compared. Lists have one set per solver.
struct SessionSets {
  std::set<int> comparable = {};             // recorded in the store
  std::vector<std::set<int>> all = {};       // sessions with solves of the solver
  std::vector<std::set<int>> complete = {};  // comparable ones in which no solver has more solves
  std::vector<std::set<int>> quiet = {};     // complete ones in which at most a tenth of the solves were preempted
};
SessionSets session_sets(const StudyResults& study);

constexpr std::int64_t max_solves = 10'000'000;
constexpr int max_plotted = 10'000;  // records of a first run
constexpr std::size_t max_traces = 2'000'000;
constexpr int max_extras = 50;  // names; further ones are left out

// Reads the current solves of a study, and passes each record to `also` if that is not empty. Throws
// std::invalid_argument for more than `max_solves` solves, for more than `max_traces` solves with a trace, and if
// solvers had different targets or starts.
StudyResults read_study(const results::Store& store, const results::StoredStudy& entry,
                        const results::SolveVisitor& also = {});
// Throws std::invalid_argument if solvers had different targets or starts. Starts that the solver's own answers left
// are not compared.
void require_same_targets(const StudyResults& study);

}  // namespace ikbench::judge
