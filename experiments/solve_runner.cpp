#include "experiments/solve_runner.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <cfenv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "base/names.hpp"
#include "base/units.hpp"
#include "experiments/environment.hpp"
#include "experiments/external/answers.hpp"
#include "results/export.hpp"

namespace ikbench::experiments {

using namespace base;
using namespace solvers;
using namespace results;

namespace {

std::vector<double> to_vector(const Configuration& values) { return {values.begin(), values.end()}; }

// The floating-point environment at the begin of a solve. The destructor restores rounding, traps and subnormal
// numbers, whatever the solver did to them.
struct FloatingPointGuard {
  FloatingPointGuard() { std::fegetenv(&before); }
  ~FloatingPointGuard() { std::fesetenv(&before); }
  std::fenv_t before;
};

// The solve that a thread makes, for messages of errors, also if a user's class ends the process during the solve.
class SolveContext {
 public:
  SolveContext(const std::string& label, int run, int point) : label_(label), run_(run), point_(point) {
    [[maybe_unused]] static const int registered = std::atexit(refuse_to_exit);
    current = this;
  }
  ~SolveContext() { current = nullptr; }
  SolveContext(const SolveContext&) = delete;
  SolveContext& operator=(const SolveContext&) = delete;

  // Returns a message with the solve before `what`.
  std::string message(std::string_view what) const {
    return fmt::format("{}, run {}, point {}: {}", label_, run_, point_, what);
  }

 private:
  // Ends the process with an error, because a run that was cut must not look like a run that ended well.
  static void refuse_to_exit() {
    if (current == nullptr) return;
    const std::string message = one_line(current->message("the solver ends the program (exit)"));
    std::fputs(fmt::format("ikbench: {}; stored solves are kept\n", message).c_str(), stderr);
    std::fflush(stderr);
    ::_exit(2);
  }
  static thread_local const SolveContext* current;

  const std::string& label_;
  int run_, point_;
};
thread_local const SolveContext* SolveContext::current = nullptr;

Timing timing_of(const SolverEntry& entry, int jobs) {
  if (entry.answers) return Timing::elsewhere;
  if (entry.program && entry.program->choice.batch > 0) return Timing::batch;
  if (is_debug_build()) return Timing::debug_build;
  if (jobs > 1) return Timing::parallel;
  return entry.program ? Timing::process : Timing::clean;
}

// Returns why a solve ended. A program that ends by itself may have been told that its budget is used up.
StopReason stop_reason_of(const Solution& solution, const std::optional<ProcessReport>& report) {
  if (!report) return solution.stopped;
  if (report->failure) return *report->failure == Status::timed_out ? StopReason::time : report->stopped;
  return solution.stopped == StopReason::finished ? report->stopped : solution.stopped;
}

// Returns the side that counted the evaluations of a solve. `is_counted` is about a solver in this process.
CountedBy counted_by_of(const std::optional<ProcessReport>& report, bool is_counted) {
  if (report) return report->counted_by;
  return is_counted ? CountedBy::ikbench : CountedBy::none;
}

}  // namespace

SolveRunner::SolveRunner(const Study& study, const SolverEntry& entry, std::string key, const Robot& arm, int jobs)
    : study_(study),
      entry_(entry),
      arm_(arm),
      task_(study, arm),
      options_(effective_options(study, entry)),
      key_(std::move(key)),
      timing_(timing_of(entry, jobs)),
      is_counted_(entry.program || solver_info(entry).is_counted) {
  if (!entry.program) return;
  processes_ = std::make_unique<ProcessPool>(entry.program,
                                             robot_message({.arm = arm,
                                                            .searched = task_.arm(),
                                                            .goal = task_.goal(Pose::Identity()),
                                                            .hello = entry.program->hello,
                                                            .options = options_}),
                                             batch() > 0 ? CacheState::first : study.state);
}

std::unique_ptr<Solver> SolveRunner::make_solver() const {
  if (processes_) return std::make_unique<ExternalSolver>(*processes_, study_.stop, study_.wrap);
  if (entry_.answers) return std::make_unique<GivenSolver>(*entry_.answers, study_.wrap);
  return solver_info(entry_).make(options_);
}

void SolveRunner::count_failure(Solver& solver) const {
  if (processes_) static_cast<ExternalSolver&>(solver).count_failure();
}

void SolveRunner::end_processes() const {
  if (processes_) processes_->end_processes();
}

std::string SolveRunner::anomalies() const {
  std::vector<std::string> clauses;
  if (const std::string failure = processes_ ? processes_->last_failure() : ""; !failure.empty())
    clauses.push_back("last failure: " + failure);
  if (rerun_differences_ > 0)
    clauses.push_back(fmt::format("it gave other answers to the same question in {} of {} repeats",
                                  rerun_differences_.load(), rerun_count_.load()));
  if (second_differences_ > 0)
    clauses.push_back(fmt::format("its second solve of a target gave another answer than the first in {} of {} targets",
                                  second_differences_.load(), second_count_.load()));
  return fmt::format("{}", fmt::join(clauses, "; "));
}

SolveRunner::TimedSolve SolveRunner::solve_timed(Solver& solver, const SolveRequest& call) const {
  const auto& [target, start, run, point] = call;
  const Problem problem = task_.problem(start, effective_population(study_, entry_));
  Objective objective(task_.arm(), task_.goal(target));
  Random random(Key(study_.seed)
                    .with(entry_.label)
                    .with(static_cast<std::uint64_t>(run))
                    .with(static_cast<std::uint64_t>(point)));
  auto* const program = processes_ ? static_cast<ExternalSolver*>(&solver) : nullptr;
  auto* const given = entry_.answers ? static_cast<GivenSolver*>(&solver) : nullptr;
  if (given != nullptr) given->select(run, point);
  const auto prepared = std::chrono::steady_clock::now();
  if (program != nullptr) program->prepare(problem, objective);
  TimedSolve timed;
  const FloatingPointGuard guard;  // takes 0.1 us, outside the solver's time
  const SolveContext context(entry_.label, run, point);
  try {
    const bool has_failed = program != nullptr && program->report().failure;  // a failure in the warm-up
    const auto started = has_failed ? prepared : std::chrono::steady_clock::now();
    const auto solve_by = study_.trace == Trace::none ? &solvers::solve : &solvers::solve_traced;
    timed.solution = solve_by(solver, problem, objective, random, study_.stop);
    timed.answer = task_.with_wrist(timed.solution.best.q, target, start);
    timed.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    if (batch() > 0) timed.seconds = program->report().seconds;
    if (program != nullptr && program->is_given_up()) timed.seconds = std::numeric_limits<double>::quiet_NaN();
    timed.extras = objective.notes();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(context.message(error.what()));
  } catch (const std::exception& error) {
    throw std::runtime_error(context.message(error.what()));
  } catch (...) {
    throw std::runtime_error(context.message("the solver throws something that is not a std::exception"));
  }
  if (given != nullptr) {
    timed.seconds = given->seconds();
    timed.report = given->report();
    timed.all_answers = given->all_answers();
  }
  if (program == nullptr) return timed;
  const ProcessReport& report = timed.report.emplace(program->report());
  timed.cpu_seconds = report.cpu_seconds;
  if (task_.arm().joints() == arm_.joints()) timed.all_answers = report.all_answers;
  timed.solution.evaluations = report.evaluations;
  timed.solution.iterations = report.iterations;
  if (report.is_of_second_solve) timed.seconds /= 2;  // the clock ran while the program solved twice
  if (study_.trace == Trace::none) return timed;
  timed.solution.trace = report.trace;
  timed.solution.improved = report.improved;
  return timed;
}

void SolveRunner::warm_up(Solver& solver, const SolveRequest& call, std::size_t together) const {
  for (std::size_t i = 0; batch() > 0 && i < together; ++i) warm_call(solver, call);
  if (batch() > 0) {
    warm_up_calls([&](std::uint32_t) { send_batch(solver); });
    return static_cast<ExternalSolver&>(solver).clear_batch();  // a target may be asked for again
  }
  if (processes_) {
    const Problem problem = task_.problem(call.start, effective_population(study_, entry_));
    return static_cast<ExternalSolver&>(solver).prepare(problem, Objective(task_.arm(), task_.goal(call.target)));
  }
  try {
    warm_up_calls([&](std::uint32_t) { solve_timed(solver, call); });
  } catch (const std::exception&) {  // the first recorded solve will throw this, too
  }
}

SolveRecord SolveRunner::solve(Solver& solver, const SolveRequest& call) const {
  const double before = thread_cpu_seconds();
  TimedSolve made = solve_timed(solver, call);
  if (!made.report) made.cpu_seconds = thread_cpu_seconds() - before;
  const auto verified = [&](const Configuration& answer) {
    return verify(arm_, {.target = call.target,
                         .start = call.start,
                         .answer = answer,
                         .is_axis_free = study_.search == Search::axis,
                         .motion_joints = study_.motion_joints});
  };
  const Verification as_answered = verified(made.answer);
  const Status status = status_of(made, as_answered, call.target);
  if ((processes_ || entry_.custom) && !has_no_answer(status) && ended_itself(made)) {
    count_second_solve(made);
    count_rerun(solver, call, made);
  }
  if (arm_stays(status)) return make_record(call, made, status, call.start, verified(call.start));
  return make_record(call, made, status, made.answer, as_answered);
}

bool SolveRunner::ended_itself(const TimedSolve& timed) const {
  return study_.stop.seconds == 0 || timed.seconds < study_.stop.seconds;
}

void SolveRunner::count_second_solve(const TimedSolve& made) const {
  if (!made.report || !made.report->is_of_second_solve) return;
  ++second_count_;
  if (made.report->differs_from_first) ++second_differences_;
}

void SolveRunner::count_rerun(Solver& solver, const SolveRequest& call, const TimedSolve& made) const {
  constexpr int one_in = 10;
  if ((call.run + call.point) % one_in != 0) return;
  const TimedSolve again = solve_timed(solver, call);
  const bool has_failed = again.report && again.report->failure;
  if (has_failed) static_cast<ExternalSolver&>(solver).excuse_failure();
  if (!ended_itself(again) || has_failed) return;
  ++rerun_count_;
  if (!same_bits(again.answer, made.answer)) ++rerun_differences_;
}

Timing SolveRunner::timing_of_solve(const TimedSolve& made) const {
  const bool is_warm = made.report && made.report->is_of_second_solve && credible_report(*made.report);
  return timing_ == Timing::process && is_warm ? Timing::process_warm : timing_;
}

SolveRecord SolveRunner::make_record(const SolveRequest& call, const TimedSolve& made, Status status,
                                     const Configuration& answer, const Verification& verified) const {
  const Solution& solution = made.solution;
  const ProcessReport* const report = made.report ? &*made.report : nullptr;
  const bool is_counted = is_counted_ && solution.evaluations > 0;  // a solver that never asks has its own kinematics
  SolveRecord record{
      .study = study_.name,
      .robot = arm_.name,
      .label = entry_.label,
      .series = key_,
      .run = call.run,
      .point = call.point,
      .target_position_m = to_vector(call.target.translation()),
      .target_rotation = row_major(call.target.linear()),
      .start_rad = to_vector(call.start),
      .answer_rad = to_vector(answer),
      .reached_position_m = to_vector(verified.reached),
      .position_error_cm = verified.position_error / centimetre,
      .reported_error_cm = (report != nullptr ? report->reported_error : solution.position_error) / centimetre,
      .orientation_error = verified.orientation_error,
      .variation_deg = verified.joint_motion / degree,
      .largest_move_deg = verified.largest_move / degree,
      .limit_violation_deg = verified.limit_violation / degree,
      .evaluations = is_counted ? solution.evaluations : 0,
      .iterations = solution.iterations,
      .stop_reason = stop_reason_of(solution, made.report),
      .status = status,
      .seconds = report != nullptr ? credible_report(*report).value_or(made.seconds) : made.seconds,
      .wall_seconds = timing_ == Timing::elsewhere ? std::numeric_limits<double>::quiet_NaN() : made.seconds,
      .cpu_seconds = made.cpu_seconds,
      .timing = timing_of_solve(made),
      .batch_size = report != nullptr ? report->batch_size : 1,
      .variation_m = verified.joint_motion_m,
      .limit_violation_m = verified.limit_violation_m,
      .counted_by = counted_by_of(made.report, is_counted),
      .restarts = solution.restarts,
      .all_answers_rad = made.all_answers,
      .extras = made.extras};
  if (arm_stays(status) && report != nullptr && !report->failure) {  // otherwise the program's answer would be lost
    for (int j = 0; j < arm_.joints(); ++j) record.extras[fmt::format("{}{}", refused_prefix, j + 1)] = made.answer[j];
  }
  for (const double error : solution.trace) record.trace_cm.push_back(error / centimetre);
  if (is_counted) {
    record.improved_at.assign(solution.improved.at.begin(), solution.improved.at.end());
    for (const double error : solution.improved.to) record.improved_to_cm.push_back(error / centimetre);
  }
  return record;
}

Status SolveRunner::status_of(const TimedSolve& timed, const Verification& verified, const Pose& target) const {
  if (timed.report && timed.report->failure) return *timed.report->failure;
  if (timed.solution.stopped == StopReason::not_finite) return Status::not_finite;
  const bool is_self_reported = timed.report && !std::isnan(timed.report->reported_error);
  const Status status = classify(
      verified, {.reported_error = is_self_reported ? timed.report->reported_error : timed.solution.position_error,
                 .report_tolerance = timed.report ? program_report_tolerance : 0,
                 .reported_pose_error = timed.solution.best.error,
                 .rotation_weight = task_.goal(target).rotation_weight,
                 .stop = study_.stop,
                 .orientation_is_exact = study_.search == Search::wrist,
                 .limits_are_enforced = study_.limits == LimitPolicy::enforced});
  return is_sound(status) && missed_deadline(timed) ? Status::over_budget : status;
}

// Programs and libraries stop by themselves, so they may exceed their budget. On a busy machine they wait, so the
// smaller of wall and processor time counts.
bool SolveRunner::missed_deadline(const TimedSolve& timed) const {
  if (!timed.report && solver_info(entry_).library.empty()) return false;
  if (timed.report && timed.report->ignored_budget) return true;
  const double seconds =
      timed.report ? credible_seconds(*timed.report, timed.seconds) : std::min(timed.seconds, timed.cpu_seconds);
  if (entry_.answers) return study_.stop.seconds > 0 && seconds > study_.stop.seconds;  // nothing is waited for
  return exceeds_budget(
      {.seconds = seconds, .evaluations = timed.solution.evaluations, .iterations = timed.solution.iterations},
      study_.stop);
}

}  // namespace ikbench::experiments
