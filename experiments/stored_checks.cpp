#include "experiments/stored_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "base/json.hpp"
#include "base/names.hpp"
#include "base/units.hpp"
#include "experiments/external/answers.hpp"
#include "experiments/runner.hpp"
#include "experiments/solve_runner.hpp"
#include "experiments/study/reader.hpp"
#include "experiments/study/series_key.hpp"
#include "experiments/verifier.hpp"
#include "results/export.hpp"
#include "robots/robot.hpp"
#include "solvers/registry.hpp"

namespace ikbench::experiments {

using namespace base;
using namespace numerics;
using namespace results;

Study study_in_store(const StoredStudy& stored) {
  const std::optional<Robot> arm = robots::stored_arm(stored.definition.arm);
  if (!arm)
    throw std::invalid_argument(
        fmt::format("study {}: its stored arm cannot be read, so it was changed; solve the study again with --out NEW",
                    stored.name));
  Study study;
  static_cast<StudySpec&>(study) = stored.definition;
  study.robot_of_file = std::make_shared<const Robot>(*arm);
  study.initial = default_configuration(*arm);
  return study;
}

Pose target_of(const SolveRecord& solve) {
  if (solve.target_position_m.size() != 3 || solve.target_rotation.size() != 9)
    throw std::invalid_argument(fmt::format("{}, run {}, point {} has no target", solve.label, solve.run, solve.point));
  Pose target = Pose::Identity();
  target.translation() = to_eigen(solve.target_position_m);
  target.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(solve.target_rotation.data());
  return target;
}

namespace {

[[noreturn]] void refuse(const SolveRecord& solve, const std::string& what) {
  throw std::invalid_argument(
      fmt::format("study {}, {}, run {}, point {}: {}", solve.study, solve.label, solve.run, solve.point, what));
}

// Calls `action`, and adds to its error that the solve was changed in the store.
template <class Action>
void with_store_context(Action&& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format(
        "{}; the solve was changed since it was stored; solve the study again with --out NEW", error.what()));
  }
}

// Refuses a stored number that differs from the computed one by more than rounding. Two numbers that are not finite are
// alike. An arm from a URDF file was verified by its origins and axes. The store has the arm's table, which may be
// 1e-9 m and rad off.
void expect(const char* column, const SolveRecord& solve, double stored, double computed, double rounding) {
  const bool is_same = std::isfinite(computed) ? std::abs(stored - computed) <= rounding * (1 + std::abs(computed))
                                               : !std::isfinite(stored);
  if (!is_same) refuse(solve, fmt::format("{} is {}, but {} follows from the answer", column, stored, computed));
}

// The way in which a solver is run, which decides what it can have used.
enum class SolverKind {
  built_in,     // stopped after each iteration
  single_call,  // a library or a user's class, of which a step is one call
  program       // counts its own iterations, or was run elsewhere
};

// Returns the entry of a built-in solver with these `options`, which are those of the series; nothing for others. A
// program may have the name of a built-in solver.
std::optional<SolverEntry> built_in(const Series& series, const Json& options) {
  const std::vector<solvers::SolverInfo>& known = solvers::all_solvers();
  const auto info = std::ranges::find(known, series.algorithm, &solvers::SolverInfo::name);
  if (info == known.end() || !info->library.empty() || options.contains("process")) return std::nullopt;
  SolverEntry entry{.label = series.label, .solver = series.algorithm};
  for (const auto& [name, value] : options.items()) {
    if (name == "population") {
      if (!value.is_number_integer() || value < population_range.first || value > population_range.second)
        throw std::invalid_argument(fmt::format(
            "the population of {} is not a whole number from {} to {}, so it was changed; solve the study again with --out NEW",
            base::one_line(base::front(series.label, 60)), population_range.first, population_range.second));
      entry.population = value;
    } else if (value.is_number()) {
      entry.options[name] = value.get<double>();
    } else {
      entry.options[name] = value.is_string() ? value.get<std::string>() : value.dump();
    }
  }
  return entry;
}

SolverKind kind_of(const Series& series) {
  const Json options = parsed_json(series.options);
  if (built_in(series, options)) return SolverKind::built_in;
  const bool is_external = options.contains("process") || options.contains("answers");
  return is_external ? SolverKind::program : SolverKind::single_call;
}

// Returns true if a solver of this kind can have used as much as the solve did.
bool can_have_used(const StopRule& stop, SolverKind kind, const SolveRecord& solve) {
  if (solve.evaluations == 0 && solve.counted_by == CountedBy::ikbench) return false;
  if (kind != SolverKind::program && solve.stop_reason == StopReason::iterations && solve.iterations != stop.iterations)
    return false;
  if (kind == SolverKind::built_in)
    return solve.counted_by == CountedBy::ikbench && solve.iterations <= stop.iterations &&
           (solve.stop_reason != StopReason::evaluations || solve.evaluations >= stop.evaluations);
  return !is_sound(solve.status) ||
         !exceeds_budget({.evaluations = solve.evaluations, .iterations = solve.iterations}, stop);
}

// Returns true if a solve has the results of the study's check. An answer that reached its target has all numbers of
// the check, and an invalid one has one reason. Without a check, no answer is invalid.
bool has_check_results(const StudyDefinition& study, const SolveRecord& solve) {
  const bool is_invalid = solve.status == Status::invalid;
  if (study.check.process.empty()) return !is_invalid;
  const auto is_there = [&](const std::string& number) {
    const auto extra = solve.extras.find(fmt::format("{}{}", check_extra, number));
    return extra != solve.extras.end() && std::isfinite(extra->second);
  };
  const auto is_reason = [](const auto& extra) { return extra.first.starts_with(invalid_extra); };
  if (is_reached(solve.status) && !std::ranges::all_of(study.check.numbers(), is_there)) return false;
  return std::ranges::count_if(solve.extras, is_reason) == (is_invalid ? 1 : 0);
}

// Refuses a solve whose values are none of this study and arm.
void check_shape(const StudyDefinition& study, const Robot& arm, const SolveRecord& solve) {
  if (const std::string wrong = wrong_number(solve); !wrong.empty())
    refuse(solve, fmt::format("{}, which no solve has", wrong));
  if (solve.run < 1 || solve.point < 1 || solve.point > study.points)
    refuse(solve, fmt::format("a study of {} has no such solve", counted(study.points, "targets")));
  const auto joints = static_cast<std::size_t>(arm.joints());
  if (solve.target_position_m.size() != 3 || solve.reached_position_m.size() != 3 ||
      solve.target_rotation.size() != 9 || solve.start_rad.size() != joints || solve.answer_rad.size() != joints)
    refuse(solve,
           fmt::format("its target, start or answer does not fit an arm with {}", counted(arm.joints(), "joints")));
  if (arm_stays(solve.status) && solve.answer_rad != solve.start_rad)
    refuse(solve, fmt::format("the arm moved, but its status is {}", name_of(solve.status)));
}

// Refuses a solve whose status is not that of its answer. Tolerances may be passed by rounding.
void check_status(const StudyDefinition& study, const Verification& computed, const SolveRecord& solve) {
  const auto status = [&](double rounding) {
    constexpr double min_tolerance = std::numeric_limits<double>::min();  // 0 would be no tolerance
    const auto moved_by_rounding = [&](double tolerance) {
      return tolerance > 0 ? std::max(tolerance + rounding, min_tolerance) : 0;
    };
    StopRule stop = study.stop;
    stop.tolerance = moved_by_rounding(stop.tolerance);
    stop.angle_tolerance = moved_by_rounding(stop.angle_tolerance);
    return classify(computed, {.reported_error = computed.position_error, .stop = stop});
  };
  const Status reached = solve.status == Status::invalid ? Status::ok : solve.status;
  if (reached != status(1e-8) && reached != status(-1e-8))
    refuse(solve,
           fmt::format("status is {}, but {} follows from the answer", name_of(solve.status), name_of(status(0))));
}

void check(const StudyDefinition& study, const Robot& arm, SolverKind kind, const SolveRecord& solve) {
  check_shape(study, arm, solve);
  if (!can_have_used(study.stop, kind, solve))
    refuse(solve, fmt::format("it has {} (counted by {}) in {} and stops by {}, which no solve of this study does",
                              counted(solve.evaluations, "evaluations"), name_of(solve.counted_by),
                              counted(solve.iterations, "iterations"), name_of(solve.stop_reason)));
  const Verification computed = verify(arm, {.target = target_of(solve),
                                             .start = to_eigen(solve.start_rad),
                                             .answer = to_eigen(solve.answer_rad),
                                             .is_axis_free = study.search == Search::axis,
                                             .motion_joints = study.motion_joints});
  expect("position_error_cm", solve, solve.position_error_cm, computed.position_error / centimetre, 1e-7);
  expect("orientation_error", solve, solve.orientation_error, computed.orientation_error, 1e-8);
  expect("variation_deg", solve, solve.variation_deg, computed.joint_motion / degree, 1e-7);
  expect("largest_move_deg", solve, solve.largest_move_deg, computed.largest_move / degree, 1e-7);
  expect("variation_m", solve, solve.variation_m, computed.joint_motion_m, 1e-9);
  expect("limit_violation_deg", solve, solve.limit_violation_deg, computed.limit_violation / degree, 1e-6);
  expect("limit_violation_m", solve, solve.limit_violation_m, computed.limit_violation_m, 1e-8);
  const double distance = computed.reached.norm();  // rounding grows with the distance, which prismatic joints may have
  for (Eigen::Index i = 0; i < 3; ++i)
    expect("reached_position_m", solve, solve.reached_position_m[static_cast<std::size_t>(i)], computed.reached[i],
           1e-8 * (1 + distance));
  if (solve.status == Status::not_finite && solve.stop_reason != StopReason::not_finite &&
      std::isfinite(computed.position_error + computed.orientation_error))
    refuse(solve, "its status is not_finite, but its numbers are finite");
  if (kind != SolverKind::program && solve.seconds != solve.wall_seconds)
    refuse(solve, "its seconds are not its wall_seconds, but only a program may report its own time");
  if (solve.batch_size < 1 || (kind != SolverKind::program && solve.batch_size > 1))
    refuse(solve, fmt::format("its batch_size is {}; expected 1, or more for a program", solve.batch_size));
  if (solve.all_answers_rad.size() % solve.answer_rad.size() != 0)
    refuse(solve, "its all_answers_rad do not have one number for each joint");
  if (!has_check_results(study, solve)) refuse(solve, "its status or extras are not what the study's check gives");
  if (!is_sound(solve.status) && solve.status != Status::invalid && solve.status != Status::limit_violated)
    return;                         // the answer is not stored: the arm stayed, or the reported error decided
  if (kind != SolverKind::program)  // a program may round, or have the arm from a file
    expect("reported_error_cm", solve, solve.reported_error_cm, computed.position_error / centimetre, 2e-7);
  check_status(study, computed, solve);
}

// Refuses a repeated solve that is not the stored one. The study's check is not asked again, so an answer that it
// refused is `ok` here.
void expect_same(const SolveRecord& solve, const SolveRecord& again) {
  const auto compare = [&](const char* column, const auto& repeated, const auto& stored) {
    if (repeated != stored) refuse(solve, fmt::format("repeated, it has {} {}, not {}", column, repeated, stored));
  };
  const bool is_before_check = again.status == Status::ok && is_reached(solve.status);
  compare("status", name_of(is_before_check ? solve.status : again.status), name_of(solve.status));
  compare("stop_reason", name_of(again.stop_reason), name_of(solve.stop_reason));
  compare("evaluations", again.evaluations, solve.evaluations);
  compare("iterations", again.iterations, solve.iterations);
  compare("restarts", again.restarts, solve.restarts);
  if (again.improved_at != solve.improved_at) refuse(solve, "repeated, it has another improved_at");
  if (!same_bits(again.answer_rad, solve.answer_rad)) refuse(solve, "repeated, it has another answer");
}

}  // namespace

SolveVisitor answer_check(const StoredStudy& study) {
  std::map<std::string, SolverKind> kinds;  // by label
  for (const Series& series : study.series) kinds[series.label] = kind_of(series);
  return [definition = study.definition, arm = *study_in_store(study).robot_of_file, kinds](const SolveRecord& solve) {
    check(definition, arm, kinds.at(solve.label), solve);
  };
}

SolveVisitor stored_solve_check(const StoredStudy& study) {
  return [check = answer_check(study), start = study.definition.start, is_chained = study.definition.is_chained(),
          next = std::tuple(std::string(), 0, 0), left_rad = std::vector<double>()](const SolveRecord& solve) mutable {
    with_store_context([&] {
      if (is_chained && next == std::tie(solve.label, solve.run, solve.point) && left_rad != solve.start_rad)
        refuse(solve, "it does not start at the previous answer");
      check(solve);
    });
    next = {solve.label, solve.run, solve.point + 1};
    left_rad = continues_from(solve, start) ? solve.answer_rad : solve.start_rad;
  };
}

SolveVisitor target_replay_check(const StoredStudy& stored) {
  Study study = study_in_store(stored);
  if (!read_stored_targets(stored, study)) return {};
  return [study, run = 0, poses = std::vector<Pose>(),
          own_starts = std::vector<Configuration>()](const SolveRecord& solve) mutable {
    if (run != solve.run) {
      run = solve.run;
      poses = targets_of_run(study, *study.robot_of_file, run);
      own_starts = starts_of_run(study, *study.robot_of_file, run);
    }
    const auto place = static_cast<std::size_t>(solve.point - 1);
    const bool is_drawn = same_bits(poses[place].translation(), solve.target_position_m) &&
                          same_bits(row_major(poses[place].linear()), solve.target_rotation);
    const bool has_own_start = !study.is_chained() || solve.point == 1;
    with_store_context([&] {
      if (!is_drawn) refuse(solve, "the study's seed draws another target");
      const Configuration start = own_starts.empty() ? Configuration(study.initial) : own_starts[place];
      if (has_own_start && !same_bits(start, solve.start_rad)) refuse(solve, "the study's seed draws another start");
    });
  };
}

namespace {

// Throws std::invalid_argument if the key has the source of a built-in solver, but the series has another name.
void check_name(const StoredStudy& study, const Series& series) {
  std::vector<std::string> names;
  for (const solvers::SolverInfo& info : solvers::all_solvers()) {
    if (info.library.empty() && series.key.find(source_key({.solver = info.name})) != std::string::npos)
      names.push_back(info.name);
  }
  if (names.empty() || std::ranges::count(names, series.algorithm) > 0) return;
  throw std::invalid_argument(
      fmt::format("study {}, {}: its solves are by {}, not by {}, so the name was changed since then", study.name,
                  one_line(front(series.label, 60)), names.front(), one_line(front(series.algorithm, 60))));
}

}  // namespace

namespace {

// Returns whether the current folder has the file of answers of a series, and it is another one than that of the
// solves.
bool has_changed_answers(const Series& series, const std::vector<Session>& sessions) {
  const Json options = parsed_json(series.options);
  if (!options.contains("answers") || !options["answers"].is_string()) return false;
  const auto digest = digest_of_answers(options["answers"].get<std::string>());
  return digest && std::ranges::none_of(sessions, [&](const Session& session) {
           const auto shared = session.environment.find("source");
           return shared != session.environment.end() &&
                  series.key.find(source_key_of(shared->second, *digest)) != std::string::npos;
         });
}

}  // namespace

RerunReport rerun_sample(const Store& store, const StoredStudy& stored, std::int64_t max_solves,
                         const std::function<void(const Progress&)>& progress) {
  Study study = study_in_store(stored);
  RerunReport report;
  const std::vector<Session> sessions = store.sessions();
  std::map<std::string, SolverEntry> entries;  // by label
  std::map<std::string, SolveRunner> runners;
  for (const Series& series : stored.series) {
    check_name(stored, series);
    if (has_changed_answers(series, sessions)) report.changed_answers.push_back(series.label);
    std::optional<SolverEntry> entry = built_in(series, parsed_json(series.options));
    if (!entry)
      report.external.push_back(series.label);
    else if (series.key.find(source_key(*entry)) == std::string::npos)
      report.changed_source.push_back(series.label);
    else if (study.stop.seconds == 0)
      runners.try_emplace(series.label, study, entries[series.label] = *entry, series.key, *study.robot_of_file);
  }
  std::vector<SolveRecord> drawn;
  std::mt19937_64 random(std::random_device{}());  // so that the chosen solves cannot be known before
  store.for_each_in_study(stored, [&](SolveRecord& solve) {
    if (!runners.contains(solve.label)) return;
    const auto place = std::uniform_int_distribution<std::int64_t>(0, report.eligible)(random);
    ++report.eligible;
    if (std::ssize(drawn) < max_solves)
      drawn.push_back(std::move(solve));
    else if (place < max_solves)
      drawn[static_cast<std::size_t>(place)] = std::move(solve);
  });
  for (const SolveRecord& solve : drawn) {
    if (progress) progress({.done = report.solves, .total = std::ssize(drawn)});
    study.trace = solve.trace_cm.empty() ? solvers::Trace::none : solvers::Trace::best_error;
    const SolveRunner& runner = runners.at(solve.label);
    const SolveRecord again =
        runner.solve(*runner.make_solver(), {target_of(solve), to_eigen(solve.start_rad), solve.run, solve.point});
    with_store_context([&] { expect_same(solve, again); });
    ++report.solves;
  }
  return report;
}

}  // namespace ikbench::experiments
