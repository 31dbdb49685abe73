#include "experiments/external/external_solver.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "base/json.hpp"
#include "experiments/task.hpp"
#include "results/export.hpp"

namespace ikbench::experiments {

using namespace robots;
using namespace solvers;
using namespace results;

namespace {

constexpr int max_failures_in_a_row = 3;
constexpr double infinite_error = std::numeric_limits<double>::infinity();

Status status_of(ProcessFailure::Kind kind) {
  constexpr Status as_kinds[]{Status::crashed, Status::timed_out, Status::protocol_error, Status::declined};
  return as_kinds[static_cast<std::size_t>(kind)];
}

// Returns a new process of a program that has introduced itself before. Throws std::runtime_error if the program has
// changed since, or does not start.
std::unique_ptr<ChildProcess> restarted(const Program& program) {
  try {
    if (!program.is_unchanged())
      throw std::invalid_argument("the files of " + program.choice.process[0] + " changed while it ran");
    Hello hello;
    return launch(program.choice, program.folder, hello);
  } catch (const std::invalid_argument& error) {  // the program started before, so this is no result of the program
    throw std::runtime_error(fmt::format("{}; run the same command again to continue", error.what()));
  }
}

// Throws ProcessFailure if the process ended, or sent a second message. A program that answers twice would stay one
// answer behind, each answer that of the solve before. A new process gets 0.1 s for such a message.
void refuse_unsolicited_message(ChildProcess& child, bool is_new) {
  const ProcessFailure failure = unsolicited_message(child, is_new ? 0.1 : 0);
  if (failure.kind != ProcessFailure::Kind::timed_out) throw ProcessFailure(failure);
}

// Records the course of the best error as solvers::solve does.
void add_best(ProcessReport& report, std::int64_t evaluations, double best, double at_start) {
  Improvements& improved = report.improved;
  if (improved.at.empty()) {
    if (evaluations == 1) at_start = best;
    improved.add(1, std::max(at_start, best));
  } else {
    report.trace.push_back(best);
  }
  if (best < improved.to.back()) improved.add(evaluations, best);
}

double seconds_since(Clock::time_point began) { return std::chrono::duration<double>(Clock::now() - began).count(); }

// Returns the self-reported time [s] of a message; NaN if there is none, or 0, which no clock measures. Throws
// ProcessFailure if more is reported than the `passed` seconds allow.
double reported_seconds_in(const Message& message, double passed) {
  const double seconds = message.number("seconds");
  if (seconds < 0 || seconds > largest_possible_seconds(passed))
    message.fail(fmt::format("\"seconds\" from 0 to {:.2g}, which passed", passed));
  return seconds == 0 ? std::nan("") : seconds;
}

// Returns the smallest share of the error at the start that a solver can leave by these evaluations. One evaluation
// gives no direction, and the slope needs more evaluations than there are joints.
double min_error_ratio(std::int64_t evaluations, int joints) {
  if (evaluations == 1) return 1;
  return evaluations <= joints ? 0.1 : 0;
}

// Returns the smallest time [s] in which a program can have used `cpu_seconds`. The program may have two threads, and
// 1 ms is for messages.
constexpr double min_credible_seconds(double cpu_seconds) { return cpu_seconds / 2.2 - 0.001; }

}  // namespace

// The state of one solve while messages are exchanged.
struct ExternalSolver::Exchange {
  Exchange(const Problem& of_solve, Objective& counting, std::uint32_t of_seed)
      : problem(of_solve), objective(counting), seed(of_seed), uncounted(counting.arm(), counting.goal()) {
    error_at_start = uncounted.error(problem.start);
  }

  const Problem& problem;
  Objective& objective;
  std::uint32_t seed;
  Clock::time_point began = Clock::now();
  Objective uncounted;  // measures errors without counting evaluations
  double error_at_start = 0;
  double passed = 0;                // [s], until the last message
  Best best = {};                   // of the candidates that were evaluated
  std::vector<double> errors = {};  // of the candidates that were evaluated, in their order
};

std::optional<double> credible_report(const ProcessReport& report) {
  // A share of a batch may be too small for a double, and no solve takes 0 s.
  const bool is_credible = report.cpu_seconds > 0 && report.reported_seconds > 0 &&
                           report.reported_seconds >= min_credible_seconds(report.cpu_seconds);
  return is_credible ? std::optional(report.reported_seconds) : std::nullopt;
}

double credible_seconds(const ProcessReport& report, double wall) {
  const double reported = report.reported_seconds;
  return std::isnan(reported) ? wall : std::max(reported, min_credible_seconds(report.cpu_seconds));
}

Configuration nearest_answer(const Candidates& answers, const Problem& problem, const Chain& chain, WrapPolicy policy) {
  const JointLimits limits{problem.lower, problem.upper};
  Configuration nearest = answers.col(0);
  double nearest_distance = std::numeric_limits<double>::infinity();
  for (const Configuration q : answers.colwise()) {
    Configuration left = q;
    wrap(left, problem.start, limits, chain, policy);
    if (!(limits.violation(left) <= 1e-9)) continue;
    const double distance = (left - problem.start).norm();
    if (distance < nearest_distance) {
      nearest = q;
      nearest_distance = distance;
    }
  }
  return nearest;
}

WorkerProcess ProcessPool::acquire() {
  const std::scoped_lock lock(mutex_);
  if (idle_.empty()) return {};
  WorkerProcess worker = std::move(idle_.back());
  idle_.pop_back();
  return worker;
}

void ProcessPool::release(WorkerProcess worker) {
  const std::scoped_lock lock(mutex_);
  idle_.push_back(std::move(worker));
}

std::string ProcessPool::last_failure() const {
  const std::scoped_lock lock(mutex_);
  const auto failed = std::ranges::find_if(idle_, [](const auto& worker) { return !worker.last_failure.empty(); });
  return failed == idle_.end() ? "" : failed->last_failure;
}

void ProcessPool::end_processes() {
  const std::scoped_lock lock(mutex_);
  for (WorkerProcess& worker : idle_) worker.child.reset();
}

template <class Talk>
void ExternalSolver::with_failure_handling(Talk&& talk) {
  if (report_.failure) return;
  try {
    talk();
  } catch (const ProcessFailure& failure) {
    record_failure(failure);
    report_ = {.failure = status_of(failure.kind), .batch_size = report_.batch_size, .seconds = report_.seconds};
    best_.error = infinite_error;
  }
}

// Throws std::runtime_error if the program has changed since its hello.
bool ExternalSolver::ensure_running() {
  if (worker_.child && !worker_.child->is_running())
    record_failure({ProcessFailure::Kind::crashed, "it ended between two solves"});
  if (worker_.given_up) throw ProcessFailure(*worker_.given_up);
  if (worker_.child) return false;
  worker_.child = restarted(*pool_.program);
  worker_.child->write(pool_.robot, deadline_in(start_timeout));
  return true;
}

// Keeps the failure and ends the process, unless the program only declined, or answered one problem of a batch wrongly.
void ExternalSolver::record_failure(const ProcessFailure& failure) {
  if (worker_.given_up) return;
  failure_ = failure;
  if (failure.kind == ProcessFailure::Kind::declined || worker_.has_answers() || !worker_.child) return;
  failure_->why += worker_.child->end_after(failure.kind);
  worker_.child.reset();
}

void ExternalSolver::count_failure() {
  const bool counts = failure_ && failure_->kind != ProcessFailure::Kind::declined && !worker_.has_answers();
  if (counts) {
    ++worker_.failures_in_a_row;
    if (worker_.failures_in_a_row == max_failures_in_a_row) {
      failure_->why += "; after three failures in a row it is not asked again";
      worker_.given_up = failure_;
    }
  }
  note_failure();
  if (!report_.failure) worker_.failures_in_a_row = 0;
}

void ExternalSolver::excuse_failure() {
  note_failure();
  failure_.reset();
  report_.failure.reset();
}

void ExternalSolver::note_failure() {
  if (failure_) worker_.last_failure = fmt::format("{}: {}", name_of(status_of(failure_->kind)), failure_->why);
}

Clock::time_point ExternalSolver::deadline(double problems) const {
  const double solves = pool_.state == CacheState::warm ? 2 : 1;  // each has the whole budget
  const double timeout = pool_.program->choice.timeout;
  if (timeout > 0) return deadline_in(solves * timeout);
  if (stop_.seconds == 0) return deadline_in(solves * 60);
  return deadline_in(solves * std::clamp(20 * stop_.seconds * problems, 5.0, 1e6));
}

void ExternalSolver::clear_batch() {
  worker_.answers.clear();
  worker_.batch.clear();
}

bool ExternalSolver::send_batch() {
  report_ = {};
  failure_.reset();
  const auto size = static_cast<double>(worker_.batch.size());
  std::vector<std::string> problems;
  for (const SolveQuestion& question : worker_.batch) {
    worker_.answers[question.text].reset();
    problems.push_back(question.text);
  }
  Clock::time_point began = Clock::now();
  with_failure_handling([&] {
    ensure_running();
    const double cpu_before = worker_.child->cpu_seconds();
    began = Clock::now();
    const std::string text =
        fmt::format("{{\"message\":\"solve_batch\",\"problems\":[{}]}}\n", fmt::join(problems, ","));
    const Message message = send_request(*worker_.child, text, deadline(size));
    const double reported = reported_seconds_in(message, seconds_since(began));
    const double cpu = worker_.child->cpu_seconds() - cpu_before;
    report_.cpu_seconds = std::max(0.0, cpu) / size;
    if (reported >= min_credible_seconds(cpu)) report_.reported_seconds = reported / size;
    if (message.name() == "declined") throw ProcessFailure{ProcessFailure::Kind::declined, message.decline_reason()};
    if (message.name() != "solved_batch") message.fail("\"solved_batch\" or \"declined\"");
    worker_.answers = message.answers(worker_.batch);
  });
  report_.batch_size = static_cast<int>(worker_.batch.size());
  report_.seconds = seconds_since(began) / size;
  worker_.batch_report = report_;
  return !report_.failure;
}

void ExternalSolver::prepare(const Problem& problem, const Objective& objective) {
  report_ = {};
  failure_.reset();
  if (is_batched()) return;
  with_failure_handling([&] {
    const bool is_new = ensure_running();
    try {
      if (is_new && worker_.failures_in_a_row == 0)
        warm_up_calls([&](std::uint32_t seed) {
          Objective uncounted(objective.arm(), objective.goal());
          exchange_solve(problem, uncounted, seed);
        });
    } catch (const ProcessFailure& failure) {  // no target of the study fails, because a new process solves them
      if (failure.kind != ProcessFailure::Kind::declined) worker_.child.reset();
      ensure_running();
    }
    if (is_new || worker_.child->has_line()) refuse_unsolicited_message(*worker_.child, is_new);
  });
}

void ExternalSolver::start(const Problem& problem, Objective& objective, Random& random) {
  take(problem);
  with_failure_handling([&] {
    constexpr double seeds = 4294967296;  // 2^32: larger seeds do not survive every language's numbers
    exchange_solve(problem, objective, static_cast<std::uint32_t>(random.uniform() * seeds));
  });
}

void ExternalSolver::exchange_solve(const Problem& problem, Objective& objective, std::uint32_t seed) {
  report_ = {};
  const SolveQuestion question{.text = solve_message(problem, objective.goal(), stop_, seed, pool_.state),
                               .seed = seed};
  if (is_batched()) take_batch_report(question);
  if (report_.failure) {  // the failure of the whole batch was recorded when the batch failed
    best_.error = infinite_error;
    return;
  }
  Exchange exchange(problem, objective, seed);
  take_solved(is_batched() ? worker_.answers[question.text].value() : ask(question, exchange), exchange);
}

void ExternalSolver::take_batch_report(const SolveQuestion& question) {
  if (!worker_.answers.contains(question.text)) {
    if (!worker_.answers.empty()) clear_batch();  // the last batch was sent, so this question begins the next one
    worker_.batch.push_back(question);
    worker_.batch_report = {.failure = Status::declined};  // until the batch is sent
  }
  report_ = worker_.batch_report;
}

Message ExternalSolver::ask(const SolveQuestion& question, Exchange& exchange) {
  const Clock::time_point last = deadline(1);
  const double cpu_before = worker_.child->cpu_seconds();
  Tolerance tolerance(stop_, exchange.uncounted);
  bool is_over = false;
  Message message = send_request(*worker_.child, question.text + '\n', last);
  for (; message.name() == "evaluate"; ++report_.iterations) {
    const Candidates candidates = message.candidates(exchange.problem.joints());
    report_.ignored_budget |= is_over;
    const Eigen::VectorXd errors = evaluate(candidates, is_over, exchange);
    const std::optional<StopReason> end =
        spent(stop_, report_.iterations, exchange.objective.evaluations(), exchange.began);
    if (end && !is_over) report_.stopped = *end;
    is_over |= end || tolerance.is_reached(exchange.best);
    message = send_request(*worker_.child, errors_message(errors, is_over), last);
  }
  exchange.passed = seconds_since(exchange.began);
  report_.cpu_seconds = std::max(0.0, worker_.child->cpu_seconds() - cpu_before);  // 0: the process ended at once
  return message;
}

Eigen::VectorXd ExternalSolver::evaluate(const Candidates& candidates, bool is_over, Exchange& exchange) {
  const std::int64_t left =
      stop_.evaluations > 0 ? stop_.evaluations - exchange.objective.evaluations() : candidates.cols();
  const Eigen::Index taken = is_over ? 0 : std::min<Eigen::Index>(left, candidates.cols());
  Eigen::VectorXd errors = Eigen::VectorXd::Constant(candidates.cols(), std::numeric_limits<double>::quiet_NaN());
  if (taken <= 0) return errors;
  exchange.objective.errors(candidates.leftCols(taken), errors.head(taken));
  for (Eigen::Index i = 0; i < taken; ++i) exchange.best.improve(candidates.col(i), errors[i]);
  exchange.errors.insert(exchange.errors.end(), errors.begin(), errors.begin() + taken);
  add_best(report_, exchange.objective.evaluations(), exchange.best.error, exchange.error_at_start);
  return errors;
}

void ExternalSolver::take_time(const Message& message, const Exchange& exchange) {
  report_.reported_seconds = reported_seconds_in(message, exchange.passed);
  if (!message.is_of_second_solve()) return;
  if (pool_.state != CacheState::warm) message.fail("no \"timed\", as one solve was asked for");
  if (report_.iterations > 0) message.fail("no \"timed\", as candidates of both solves were evaluated");
  report_.is_of_second_solve = true;
  report_.differs_from_first = message.differs_from_first();
  report_.cpu_seconds /= 2;  // it was measured over both solves
}

void ExternalSolver::take_solved(const Message& message, Exchange& exchange) {
  if (message.name() == "declined") throw ProcessFailure{ProcessFailure::Kind::declined, message.decline_reason()};
  if (message.name() != "solved") message.fail("\"evaluate\", \"solved\" or \"declined\"");
  if (message.has("seed") && message.number("seed") != exchange.seed)
    message.fail(fmt::format("\"seed\" {}, as this answers another solve", exchange.seed));
  best_.q = answer_in(message, exchange);
  report_.reported_error = message.number("error");
  best_.error = exchange.uncounted.error(best_.q);
  if (!is_batched()) take_time(message, exchange);
  // Without a count, the requests to evaluate are counted. The first of them evaluates the start of the search.
  const std::int64_t reported = message.count("iterations");
  report_.iterations = reported >= 0 ? reported : std::max<std::int64_t>(0, report_.iterations - 1);
  set_evaluations(message.count("evaluations"), exchange);
}

Configuration ExternalSolver::answer_in(const Message& message, const Exchange& exchange) {
  for (const auto& [name, value] : message.extras()) {
    if (worker_.extras.size() < max_extras) worker_.extras.insert(name);
    if (!worker_.extras.contains(name)) message.fail(fmt::format("at most {} names of \"extras\" in all", max_extras));
    exchange.objective.note(name, value);
  }
  const int joints = exchange.problem.joints();
  if (message.has("answers")) {
    const Candidates answers = message.candidates(joints, "answers");
    const Eigen::Index kept = std::min(answers.cols(), max_kept_answers);
    for (const Configuration q : answers.leftCols(kept).colwise())
      report_.all_answers.insert(report_.all_answers.end(), q.begin(), q.end());
    return nearest_answer(answers, exchange.problem, exchange.uncounted.arm(), wrap_);
  }
  if (message.has("q") || exchange.best.q.size() == 0) return message.joints(joints);
  return exchange.best.q;
}

// Returns true if the evaluations made here explain the answer: the answer is one of the candidates, and so few
// evaluations can find it.
bool ExternalSolver::explains_answer(const Exchange& exchange) const {
  const double ratio = min_error_ratio(exchange.objective.evaluations(), exchange.problem.joints());
  const bool is_too_good = best_.error < ratio * exchange.error_at_start;
  return !is_too_good && std::ranges::count(exchange.errors, best_.error) > 0;
}

void ExternalSolver::set_evaluations(std::int64_t reported, const Exchange& exchange) {
  const std::int64_t counted = exchange.objective.evaluations();
  if (reported <= counted && explains_answer(exchange)) {
    report_.counted_by = CountedBy::ikbench;
    report_.evaluations = counted;
    if (report_.improved.at.back() < counted) report_.improved.add(counted, exchange.best.error);
    return;
  }
  report_.counted_by = reported >= 0 ? CountedBy::solver : CountedBy::none;
  report_.evaluations = reported >= 0 ? std::max(counted, reported) : 0;
  report_.trace.clear();
  report_.improved = {};
}

void check_answer(const Study& study, const Robot& arm, std::unique_ptr<ChildProcess>& child, SolveRecord& solve) {
  const Program& program = *study.checker;
  const bool is_new = child == nullptr;
  if (is_new) {
    child = restarted(program);
    child->write(robot_message({.arm = arm,
                                .searched = arm.chain,
                                .goal = Task(study, arm).goal(Pose::Identity()),
                                .urdf = urdf_text_for(program, study.robot),
                                .hello = program.hello,
                                .options = resolved_options(program.hello, {})}),
                 deadline_in(start_timeout));
  }
  const base::OrderedJson target{{"position", solve.target_position_m}, {"rotation", solve.target_rotation}};
  const base::OrderedJson question{
      {"message", "check"}, {"target", target}, {"start", solve.start_rad}, {"q", solve.answer_rad}};
  const double timeout = program.choice.timeout > 0 ? program.choice.timeout : 60;
  const Message checked = send_request(*child, base::text_of(question) + '\n', deadline_in(timeout));
  const std::string fault = checked.rejection_reason();
  std::map<std::string, double> numbers = checked.extras("numbers");
  for (const std::string& name : study.check.numbers()) {
    const auto number = numbers.extract(name);
    if (number.empty() || !std::isfinite(number.mapped()))
      checked.fail(fmt::format("\"numbers\" with a finite {}", name));
    solve.extras[fmt::format("{}{}", check_extra, name)] = number.mapped();
  }
  if (!numbers.empty())
    checked.fail(
        fmt::format("only \"numbers\" that [check] names as larger or smaller, and not {}", numbers.begin()->first));
  refuse_unsolicited_message(*child, is_new);
  if (fault.empty()) return;
  solve.status = Status::invalid;
  solve.extras[fmt::format("{}{}", invalid_extra, fault)] = 1;
}

}  // namespace ikbench::experiments
