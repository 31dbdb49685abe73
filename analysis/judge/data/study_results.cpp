#include "analysis/judge/data/study_results.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <initializer_list>
#include <numeric>
#include <stdexcept>
#include <unordered_map>

#include "analysis/judge/statistics/descriptives.hpp"
#include "base/names.hpp"
#include "base/units.hpp"
#include "results/export.hpp"

namespace ikbench::judge {

using namespace results;

namespace {

// Returns a hash of the bits of all numbers, where -0.0 counts as 0.0; 0 if there are no numbers.
std::uint64_t hash_of(std::initializer_list<std::span<const double>> lists) {
  std::uint64_t hash = 0;
  for (const std::span<const double> list : lists) {
    for (const double number : list) {
      hash = (std::rotl(hash + 1, 29) ^ std::bit_cast<std::uint64_t>(number + 0.0)) * 0x9E3779B97F4A7C15;
      hash ^= hash >> 32;
    }
  }
  return hash;
}

// The mean absolute second difference of all joint angles of a run, updated answer by answer.
struct SecondDifference {
  std::vector<double> before = {}, here = {};  // the last two answers [rad]
  double sum = 0, count = 0;

  // Adds the next answer [rad]. Returns the mean until then [deg]; NaN before the third answer.
  double with(const std::vector<double>& after) {
    if (!before.empty() && (before.size() != here.size() || after.size() != here.size())) sum = unknown;
    for (std::size_t joint = 0; joint < std::min(before.size(), after.size()); ++joint, ++count)
      sum += std::abs(before[joint] - 2 * here[joint] + after[joint]) / base::degree;
    before.swap(here);
    here = after;
    return count > 0 ? sum / count : unknown;
  }
};

// Returns the angle [deg] between two rotations from ||R - Rd|| / ||Rd||, because ||R - Rd|| is sqrt(8) sin(angle / 2)
// and ||Rd|| is sqrt(3). NaN stays NaN.
double angle_deg(double orientation_error) {
  const double sine = orientation_error * std::sqrt(3.0 / 8);
  return 2 * std::asin(sine > 1 ? 1.0 : sine) / base::degree;
}

// Returns whether a joint moved further than the joint can within a period of the control loop. The first point of a
// run never counts.
bool exceeds_velocity(const StudyDefinition& study, const SolveRecord& solve) {
  for (std::size_t j = 0; j < std::min({study.max_steps.size(), solve.start_rad.size(), solve.answer_rad.size()});
       ++j) {
    const auto [furthest, is_endless] = study.max_steps[j];
    const double move = solve.answer_rad[j] - solve.start_rad[j];
    if (std::abs(is_endless ? std::remainder(move, 360 * base::degree) : move) > furthest) return solve.point > 1;
  }
  return false;
}

// Adds the rejections by the study's check, and the self-reported numbers of solvers.
void add_extras(const SolveRecord& record, StudyResults& study) {
  const bool has_check = !study.definition.check.process.empty();
  for (const auto& [name, value] : record.extras) {
    if (has_check && name.starts_with(invalid_extra))
      ++study.rejections[record.label][name.substr(invalid_extra.size())];
    if (has_check && (name.starts_with(invalid_extra) || name.starts_with(check_extra))) continue;
    const bool has_room = study.extras.contains(name) || std::ssize(study.extras) < max_extras;
    const bool is_metric = std::isfinite(value) && !name.starts_with(results::refused_prefix);
    if (is_metric && has_room) study.extras[name][record.label].push_back(value);
  }
}

void require_valid_record(const SolveRecord& record, const StudyResults& study) {
  if (record.run < 1 || record.point < 1)
    throw std::invalid_argument(fmt::format("study '{}', solver '{}': run {}, point {}; expected them from 1",
                                            study.name, record.label, record.run, record.point));
  if (!record.trace_cm.empty() && study.plotted.size() >= max_traces)
    throw std::invalid_argument(
        fmt::format("study '{}' has too many solves with a trace; expected at most {}", study.name, max_traces));
}

// Returns whether the time of a solve was reported by an external solver: the stored time is then not the wall time, or
// the solve was made elsewhere.
bool is_self_timed(const SolveRecord& record) {
  if (record.timing == Timing::elsewhere) return std::isfinite(record.seconds);
  return std::isfinite(record.wall_seconds) && record.seconds != record.wall_seconds;
}

// Adds the size and the time per pose of a batch.
void add_batch(const SolveRecord& record, StudyResults& study) {
  auto& [sizes, times] = study.batch_timings[record.label];
  sizes.insert(record.batch_size);
  if (std::isfinite(record.seconds) && !has_no_answer(record.status)) times.push_back(record.seconds);
}

// Adds the place of a target in the plane of a grid. A target without a solve has the place (0, 0).
void add_grid_place(const SolveRecord& record, StudyResults& study) {
  const TargetGrid& grid = study.definition.grid;
  const auto point = static_cast<std::size_t>(record.point);
  if (!study.definition.is_grid() || record.target_position_m.size() != 3) return;
  if (record.point > study.definition.points) return;
  study.grid_places.resize(std::max(study.grid_places.size(), point));
  const auto along = [&](const std::vector<double>& direction) {
    return std::inner_product(direction.begin(), direction.end(), record.target_position_m.begin(), 0.0);
  };
  study.grid_places[point - 1] = {along(grid.across), along(grid.up)};
}

std::vector<double> check_values(const SolveRecord& record, const StudyResults& study) {
  std::vector<double> values;
  for (const std::string& name : study.definition.check.numbers())
    if (const auto found = record.extras.find(std::string(check_extra) + name); found != record.extras.end())
      values.push_back(found->second);
  return values;
}

// Adds a record to a study. Records must come ordered by solver, run and point. `second_difference` carries the state
// of the current run from call to call.
void add(const SolveRecord& record, SecondDifference& second_difference, StudyResults& study) {
  require_valid_record(record, study);
  const Solves earlier = study.of(record.label);
  const bool is_of_first_run = earlier.empty() || earlier.front().run == record.run;
  if (earlier.empty() || earlier.back().run != record.run) second_difference = {};
  if (!record.trace_cm.empty() || (is_of_first_run && std::ssize(earlier) < max_plotted))
    study.plotted.push_back(record);
  add_extras(record, study);
  study.has_several_answers |= !record.all_answers_rad.empty();
  add_grid_place(record, study);
  const bool is_single = record.timing != Timing::batch;
  if (!is_single) add_batch(record, study);
  const bool is_timed = is_timed_alone(record.timing);
  const bool is_time_of_solver =
      record.timing == Timing::clean || (is_of_process(record.timing) && is_self_timed(record));
  const double period = study.definition.loop.period;
  study.solves.push_back(
      {.run = record.run,
       .point = record.point,
       .label = static_cast<int>(std::ranges::find(study.labels, record.label) - study.labels.begin()),
       .session = static_cast<int>(record.session),
       .restarts = record.restarts,
       .status = record.status,
       .stop_reason = record.stop_reason,
       .timing = record.timing,
       .counted_by = record.counted_by,
       .is_outside_limits = record.limit_violation_deg > 0 || record.limit_violation_m > 0,
       .was_preempted = is_time_of_solver && record.cpu_seconds > 0 && record.seconds > 1.1 * record.cpu_seconds,
       .is_self_timed = is_self_timed(record),
       .missed_deadline = is_timed && period > 0 && (record.seconds > period || has_no_answer(record.status)),
       .exceeds_velocity = exceeds_velocity(study.definition, record),
       .position_error_cm = record.position_error_cm,
       .orientation_error_deg = angle_deg(record.orientation_error),
       .variation_deg = record.variation_deg,
       .variation_m = record.variation_m,
       .largest_move_deg = record.largest_move_deg,
       .seconds = is_single ? record.seconds : unknown,
       .second_difference_deg = second_difference.with(record.answer_rad),
       .evaluations = record.evaluations,
       .iterations = record.iterations,
       .target = hash_of({record.target_position_m, record.target_rotation}),
       .start = hash_of({record.start_rad}),
       .answer = hash_of({record.answer_rad}),
       .check_values = check_values(record, study)});
}

// Returns whether two solves have the same target, outcome and answer, bit for bit.
bool are_same(const SolveSummary& first, const SolveSummary& second) {
  return first.target == second.target && first.status == second.status && first.answer == second.answer;
}

// Returns which calls were timed in a warm study.
std::string warm_calls_text(const StudyResults& study) {
  const WarmStudySolvers solvers = solvers_of_warm_study(study);
  if (solvers.through_pipe.empty()) return "second calls on a target";
  if (solvers.warm.empty()) return "calls through a pipe, which are not warm";
  return fmt::format("second calls on a target, but those of {} through a pipe, which are not warm",
                     base::listed(solvers.through_pipe));
}

}  // namespace

void require_same_targets(const StudyResults& study) {
  const auto place = [](const SolveSummary& solve) { return (std::int64_t{solve.run} << 32) + solve.point; };
  const auto is_own = [&](const SolveSummary& solve) { return study.definition.is_chained() && solve.point > 1; };
  std::unordered_map<std::int64_t, const SolveSummary*> first;
  for (const SolveSummary& solve : study.solves) {
    const SolveSummary& here = *first.try_emplace(place(solve), &solve).first->second;
    if (here.target == solve.target && (here.start == solve.start || is_own(solve))) continue;
    const auto label = [&](const SolveSummary& each) { return study.labels[static_cast<std::size_t>(each.label)]; };
    throw std::invalid_argument(fmt::format(
        "study {}, run {}, point {}: {} and {} had different {}; expected the same task for all solvers; rerun with "
        "--out NEW",
        study.name, solve.run, solve.point, label(here), label(solve),
        here.target == solve.target ? "starts" : "targets"));
  }
}

Solves StudyResults::of(std::string_view solver) const {
  const auto here = std::ranges::find(labels, solver) - labels.begin();
  return {std::ranges::lower_bound(solves, here, {}, &SolveSummary::label),
          std::ranges::upper_bound(solves, here, {}, &SolveSummary::label)};
}

std::span<const SolveRecord> StudyResults::first_run_of(std::string_view solver) const {
  const auto first = std::ranges::find(plotted, solver, &SolveRecord::label);
  const auto end = std::find_if(
      first, plotted.end(), [&](const SolveRecord& solve) { return solve.label != solver || solve.run != first->run; });
  return {first, end};
}

std::set<std::string> environment_values(const StudyResults& study, const std::string& name) {
  std::set<std::string> values;
  for (const Session& session : study.sessions)
    if (const auto fact = session.environment.find(name); fact != session.environment.end())
      values.insert(fact->second);
  return values;
}

WarmStudySolvers solvers_of_warm_study(const StudyResults& study) {
  WarmStudySolvers found;
  if (!environment_values(study, "state").contains("warm")) return found;
  const auto is_warm = [](const SolveSummary& solve) {
    return solve.timing == Timing::clean || solve.timing == Timing::process_warm;
  };
  const auto is_through_pipe = [](const SolveSummary& solve) {
    return solve.timing == Timing::process && has_answer(solve);
  };
  for (const std::string& solver : study.labels) {
    if (study.imported.has(solver)) continue;
    const Solves solves = study.of(solver);
    if (10 * std::ranges::count_if(solves, is_through_pipe) > std::ssize(solves))
      found.through_pipe.push_back(solver);
    else if (std::ranges::any_of(solves, is_warm))
      found.warm.push_back(solver);
  }
  return found;
}

std::string timed_calls_text(const StudyResults& study) {
  const std::set<std::string> states = environment_values(study, "state");
  if (states.empty()) return "";
  if (states.contains("first")) return "first calls on a target";
  if (states.contains("warm")) return warm_calls_text(study);
  return "calls in the order of the runs";
}

SessionSets session_sets(const StudyResults& study) {
  struct Counts {
    int solves = 0, preempted = 0;
  };
  std::map<int, std::map<std::size_t, Counts>> sessions;  // counts by session and solver
  for (const SolveSummary& solve : study.solves) {
    const auto solver = static_cast<std::size_t>(solve.label);
    if (study.imported.has(study.labels[solver]) || solve.timing == Timing::elsewhere) continue;
    Counts& counts = sessions[solve.session][solver];
    ++counts.solves;
    if (solve.was_preempted) ++counts.preempted;
  }
  const std::vector<std::set<int>> none(study.labels.size());
  SessionSets sets{.all = none, .complete = none, .quiet = none};
  for (const auto& [session, solvers] : sessions) {
    int most = 0;
    for (const auto& [solver, counts] : solvers) most = std::max(most, counts.solves);
    const bool is_comparable = std::ranges::count(study.sessions, session, &Session::id) > 0;
    if (is_comparable) sets.comparable.insert(session);
    for (const auto& [solver, counts] : solvers) {
      const bool is_busy = counts.preempted > 1 && 10 * counts.preempted > counts.solves;
      sets.all[solver].insert(session);
      if (!is_comparable || counts.solves < most) continue;
      sets.complete[solver].insert(session);
      if (!is_busy) sets.quiet[solver].insert(session);
    }
  }
  return sets;
}

StudyResults read_study(const Store& store, const StoredStudy& entry, const SolveVisitor& also) {
  const std::int64_t solves = store.solve_count(entry);
  if (solves > max_solves)
    throw std::invalid_argument(
        fmt::format("study '{}' has {} solves; expected at most {}", entry.name, solves, max_solves));
  StudyResults study{entry};
  for (const Series& series : entry.series) {
    if (series.label.empty())
      throw std::invalid_argument(fmt::format("study '{}' has a solver without a label; expected one", entry.name));
    study.labels.push_back(series.label);
  }
  study.solves.reserve(static_cast<std::size_t>(solves));
  SecondDifference second_difference;
  store.for_each_in_study(entry, [&](const SolveRecord& record) {
    if (also) also(record);
    add(record, second_difference, study);
  });
  study.answers = store.counted_answers(entry.name);
  std::set<std::int64_t> used;
  for (const SolveSummary& solve : study.solves) used.insert(solve.session);
  study.sessions = store.sessions();
  std::erase_if(study.sessions, [&](const Session& session) { return !used.contains(session.id); });
  std::string& control = study.definition.plan.control;
  if (std::ranges::count(study.labels, control) == 0) control.clear();
  require_same_targets(study);
  for (const Series& series : entry.series) {
    if (std::ssize(study.of(series.label)) >= std::int64_t{study.definition.runs} * study.definition.points) continue;
    const std::int64_t others = store.stale_solve_count(series.key);
    if (others == 0) continue;
    study.stale_solves.solvers.push_back(series.label);
    study.stale_solves.count += static_cast<double>(others);
  }
  return study;
}

std::vector<Solves> runs_of(Solves solves) {
  std::vector<Solves> runs;
  while (!solves.empty()) {
    const auto is_other = [&](const SolveSummary& solve) { return solve.run != solves.front().run; };
    runs.push_back(solves.first(static_cast<std::size_t>(std::ranges::find_if(solves, is_other) - solves.begin())));
    solves = solves.subspan(runs.back().size());
  }
  return runs;
}

std::vector<Solves> complete_runs_of(const StudyResults& study, std::string_view solver) {
  std::vector<Solves> runs = runs_of(study.of(solver));
  std::erase_if(runs, [&](Solves run) { return std::ssize(run) != study.definition.points; });
  return runs;
}

bool is_deterministic(const StudyResults& study, std::string_view solver) {
  const std::vector<Solves> runs = complete_runs_of(study, solver);
  return runs.size() > 1 && std::ranges::all_of(runs, [&](Solves run) {
           return std::ranges::equal(run, runs.front(), [](const SolveSummary& solve, const SolveSummary& first) {
             return solve.answer != 0 && are_same(solve, first);
           });
         });
}

bool has_answer(const SolveSummary& solve) {
  return !has_no_answer(solve.status) && solve.status != Status::not_finite;
}

std::vector<double> solve_times(const StudyResults& study, std::string_view solver) {
  std::vector<double> seconds;
  for (const SolveSummary& solve : study.of(solver))
    if (!has_no_answer(solve.status) && std::isfinite(solve.seconds)) seconds.push_back(solve.seconds);
  return seconds;
}

std::vector<std::string> never_answering(const StudyResults& study) {
  const auto is_failed = [](const SolveSummary& solve) {
    return solve.status >= Status::crashed && solve.status <= Status::protocol_error;
  };
  std::vector<std::string> labels;
  for (const std::string& label : study.labels)
    if (const Solves solves = study.of(label); !solves.empty() && std::ranges::all_of(solves, is_failed))
      labels.push_back(label);
  return labels;
}

bool are_identical(Solves solves, Solves others) {
  return std::ranges::equal(solves, others, [](const SolveSummary& a, const SolveSummary& b) {
    return a.run == b.run && a.point == b.point && are_same(a, b) && a.evaluations == b.evaluations;
  });
}

}  // namespace ikbench::judge
