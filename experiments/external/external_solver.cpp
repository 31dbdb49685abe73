#include "experiments/external/external_solver.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
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

constexpr int most_failures_in_a_row = 3;

Status status_of(ProcessFailure::Kind kind) {
  constexpr Status as_kinds[]{Status::crashed, Status::timed_out, Status::protocol_error, Status::declined};
  return as_kinds[static_cast<std::size_t>(kind)];
}

// A fresh process of a program that was met. Throws std::runtime_error if it is not what it was.
std::unique_ptr<ChildProcess> restarted(const Program& program) {
  try {
    if (!program.is_unchanged())
      throw std::invalid_argument("the files of " + program.choice.process[0] + " changed while it ran");
    Hello hello;
    return launch(program.choice, program.folder, hello);
  } catch (const std::invalid_argument& error) {  // it started before, so this is no result of the program
    throw std::runtime_error(fmt::format("{}; run the study again, and it goes on", error.what()));
  }
}

// Records the course of the best error as solvers::solve does.
void add_best(ProcessReport& account, std::int64_t evaluations, double best, double at_start) {
  Improvements& improved = account.improved;
  if (improved.at.empty()) {
    if (evaluations == 1) at_start = best;
    improved.add(1, std::max(at_start, best));
  } else {
    account.trace.push_back(best);
  }
  if (best < improved.to.back()) improved.add(evaluations, best);
}

double seconds_since(Clock::time_point began) { return std::chrono::duration<double>(Clock::now() - began).count(); }

// What it says that it took [s]; NaN if nothing.
double told_seconds(const Message& message, double passed) {
  const double told = message.number("seconds");
  if (told < 0 || told > 1.1 * passed + 0.02)  // clocks differ, and some tick so rarely
    message.fail(fmt::format("\"seconds\" from 0 to {:.2g}, which passed", passed));
  return told == 0 ? std::nan("") : told;  // no clock tells so little
}

// Returns the smallest time [s] that a program can have taken that used `cpu_seconds`, with two threads and 1 ms for
// messages.
constexpr double min_credible_seconds(double cpu_seconds) { return cpu_seconds / 2.2 - 0.001; }

}  // namespace

std::optional<double> credible_report(const ProcessReport& account) {
  const bool is_credible =
      account.cpu_seconds > 0 && account.reported_seconds >= min_credible_seconds(account.cpu_seconds);
  return is_credible ? std::optional(account.reported_seconds) : std::nullopt;
}

double credible_seconds(const ProcessReport& account, double wall) {
  const double told = account.reported_seconds;
  return std::isnan(told) ? wall : std::max(told, min_credible_seconds(account.cpu_seconds));
}

WorkerProcess ProcessPool::acquire() {
  const std::scoped_lock lock(mutex_);
  if (idle_.empty()) return {};
  WorkerProcess conversation = std::move(idle_.back());
  idle_.pop_back();
  return conversation;
}

void ProcessPool::release(WorkerProcess conversation) {
  const std::scoped_lock lock(mutex_);
  idle_.push_back(std::move(conversation));
}

std::string ProcessPool::last_failure() const {
  const std::scoped_lock lock(mutex_);
  const auto has_failed = std::ranges::find_if(idle_, [](auto& its) { return !its.last_failure.empty(); });
  return has_failed == idle_.end() ? "" : has_failed->last_failure;
}

void ProcessPool::end_processes() {
  const std::scoped_lock lock(mutex_);
  for (WorkerProcess& idle : idle_) idle.child.reset();
}

template <class Talk>
void ExternalSolver::with_failure_handling(Talk&& talk) {
  if (report_.failure) return;
  try {
    talk();
  } catch (const ProcessFailure& trouble) {
    record_failure(trouble);
    report_ = {.failure = status_of(trouble.kind), .batch_size = report_.batch_size, .seconds = report_.seconds};
    best_.error = std::numeric_limits<double>::infinity();
  }
}

// Throws std::runtime_error if the program is not what it was.
bool ExternalSolver::ensure_running() {
  if (worker_.child && !worker_.child->is_running())
    record_failure({ProcessFailure::Kind::crashed, "it ended between two solves"});
  if (worker_.given_up) throw ProcessFailure(*worker_.given_up);
  if (worker_.child) return false;
  worker_.child = restarted(*pool_.program);
  worker_.child->write(pool_.robot, deadline_in(start_timeout));
  return true;
}

// Keeps the trouble and ends the process, unless it only declined, or answered one problem of a batch wrongly.
void ExternalSolver::record_failure(const ProcessFailure& trouble) {
  if (worker_.given_up) return;
  failure_ = trouble;
  if (trouble.kind == ProcessFailure::Kind::declined || worker_.has_answers() || !worker_.child) return;
  failure_->why += worker_.child->end_after(trouble.kind);
  worker_.child.reset();
}

void ExternalSolver::count_failure() {
  const bool counts = failure_ && failure_->kind != ProcessFailure::Kind::declined && !worker_.has_answers();
  if (counts && ++worker_.failures_in_a_row == most_failures_in_a_row) {
    failure_->why += "; it is given up after three failures in a row";
    worker_.given_up = failure_;
  }
  if (failure_) worker_.last_failure = fmt::format("{}: {}", name_of(status_of(failure_->kind)), failure_->why);
  if (!report_.failure) worker_.failures_in_a_row = 0;
}

Clock::time_point ExternalSolver::deadline(double problems) const {
  const double patience = pool_.program->choice.timeout;
  return deadline_in(patience > 0         ? patience
                     : stop_.seconds == 0 ? 60
                                          : std::clamp(20 * stop_.seconds * problems, 5.0, 1e6));
}

void ExternalSolver::clear_batch() { worker_.answers.clear(), worker_.batch.clear(); }

bool ExternalSolver::send_batch() {
  report_ = {};
  failure_.reset();
  const auto size = static_cast<double>(worker_.batch.size());
  for (const std::string& problem : worker_.batch) worker_.answers[problem].reset();
  Clock::time_point began = Clock::now();
  with_failure_handling([&] {
    ensure_running();
    const double cpu_before = worker_.child->cpu_seconds();
    began = Clock::now();
    const std::string problems = fmt::format("{}", fmt::join(worker_.batch, ","));
    const Message message =
        send_request(*worker_.child, R"({"message":"solve_batch","problems":[)" + problems + "]}\n", deadline(size));
    const double told = told_seconds(message, seconds_since(began)), cpu = worker_.child->cpu_seconds() - cpu_before;
    report_.cpu_seconds = std::max(0.0, cpu) / size;
    if (told >= min_credible_seconds(cpu)) report_.reported_seconds = told / size;
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
  if (pool_.program->choice.batch > 0) return;
  with_failure_handling([&] {
    const bool is_new = ensure_running();
    try {
      if (is_new && worker_.failures_in_a_row == 0)
        warm_up_calls([&](std::uint32_t seed) {
          Objective uncounted(objective.arm(), objective.goal());
          exchange_solve(problem, uncounted, seed);
        });
    } catch (const ProcessFailure& trouble) {  // which no target has: a new process solves it
      if (trouble.kind != ProcessFailure::Kind::declined) worker_.child.reset();
      ensure_running();
    }
    if (!is_new && !worker_.child->has_line()) return;
    // Who answers twice after a pause would stay behind, each answer that of the solve before.
    const ProcessFailure heard = unsolicited_message(*worker_.child, is_new ? 0.1 : 0);
    if (heard.kind != ProcessFailure::Kind::timed_out) throw ProcessFailure(heard);
  });
}

void ExternalSolver::start(const Problem& problem, Objective& objective, Random& random) {
  take(problem);
  with_failure_handling([&] {
    constexpr double seeds = 4294967296;  // 2^32: larger seeds do not survive every language's numbers
    exchange_solve(problem, objective, static_cast<std::uint32_t>(random.uniform() * seeds));
  });
}

// Of several answers that which is inside the limits and nearest to the start, else the first; notes how many there
// are, and how many of them are right.
Configuration ExternalSolver::select_answer(const Candidates& answers, const Problem& problem,
                                            Objective& objective) const {
  Configuration best = answers.col(0);
  double least = std::numeric_limits<double>::infinity();
  int right = 0;
  for (const Configuration q : answers.colwise()) {
    if (!(JointLimits{problem.lower, problem.upper}.violation(q) <= 1e-9)) continue;
    const Deviation off = objective.deviation(q);
    right +=
        off.position <= stop_.tolerance && (!objective.goal().has_direction() || off.angle <= stop_.angle_tolerance);
    if (const double far = (q - problem.start).norm(); far < least) best = q, least = far;
  }
  objective.note("answers", static_cast<double>(answers.cols()));
  if (stop_.tolerance > 0) objective.note("answers_right", right);
  return best;
}

void ExternalSolver::take_answer(const Message& message, const Problem& problem, Objective& objective,
                                 const Configuration& evaluated) {
  for (const auto& [name, value] : message.extras()) {
    if (worker_.extras.size() < max_extras) worker_.extras.insert(name);
    if (!worker_.extras.contains(name)) message.fail(fmt::format("at most {} names of \"extras\" in all", max_extras));
    objective.note(name, value);
  }
  if (message.has("answers"))
    best_.q = select_answer(message.candidates(problem.joints(), "answers"), problem, objective);
  else
    best_.q = message.has("q") || evaluated.size() == 0 ? message.joints(problem.joints()) : evaluated;
  report_.reported_error = message.number("error");
}

void ExternalSolver::exchange_solve(const Problem& problem, Objective& objective, std::uint32_t seed) {
  report_ = {};
  const std::string question = solve_message(problem, objective.goal(), stop_, seed);
  const bool is_of_batch = pool_.program->choice.batch > 0;
  if (is_of_batch && !worker_.answers.contains(question)) {
    if (!std::exchange(worker_.answers, {}).empty()) worker_.batch.clear();  // which was asked for
    worker_.batch.push_back(question);
    worker_.batch_report = {.failure = Status::declined};
  }
  if (is_of_batch) report_ = worker_.batch_report;
  if (report_.failure) {  // noted once, for all
    best_.error = std::numeric_limits<double>::infinity();
    return;
  }
  const Clock::time_point began = Clock::now(), last = deadline(1);
  const double cpu_before = is_of_batch ? 0 : worker_.child->cpu_seconds();
  const int joints = problem.joints();
  Objective uncounted(objective.arm(), objective.goal());
  Tolerance tolerance(stop_, uncounted);
  const double at_start = uncounted.error(problem.start);
  Best best;
  std::vector<double> seen;  // errors
  bool is_over = false;
  Message message =
      is_of_batch ? worker_.answers[question].value() : send_request(*worker_.child, question + '\n', last);
  for (; !is_of_batch && message.name() == "evaluate"; ++report_.iterations) {
    const Candidates q = message.candidates(joints);
    report_.ignored_budget |= is_over;
    const std::int64_t left = stop_.evaluations > 0 ? stop_.evaluations - objective.evaluations() : q.cols();
    const Eigen::Index taken = is_over ? 0 : std::min<Eigen::Index>(left, q.cols());
    Eigen::VectorXd errors = Eigen::VectorXd::Constant(q.cols(), std::numeric_limits<double>::quiet_NaN());
    if (taken > 0) objective.errors(q.leftCols(taken), errors.head(taken));
    for (Eigen::Index i = 0; i < taken; ++i) best.improve(q.col(i), errors[i]);
    seen.insert(seen.end(), errors.begin(), errors.begin() + taken);
    if (taken > 0) add_best(report_, objective.evaluations(), best.error, at_start);
    const std::optional<StopReason> end = spent(stop_, report_.iterations, objective.evaluations(), began);
    if (end && !is_over) report_.stopped = *end;
    is_over |= end || tolerance.is_reached(best);
    message = send_request(*worker_.child, errors_message(errors, is_over), last);
  }
  const double passed = seconds_since(began);
  if (!is_of_batch)
    report_.cpu_seconds = std::max(0.0, worker_.child->cpu_seconds() - cpu_before);  // 0: it ended at once
  if (message.name() == "declined") throw ProcessFailure{ProcessFailure::Kind::declined, message.decline_reason()};
  if (message.name() != "solved") message.fail("\"evaluate\", \"solved\" or \"declined\"");
  if (message.has("seed") && message.number("seed") != seed)
    message.fail(fmt::format("\"seed\" {}, as this answers another solve", seed));
  take_answer(message, problem, objective, best.q);
  best_.error = uncounted.error(best_.q);
  if (!is_of_batch) report_.reported_seconds = told_seconds(message, passed);
  const std::int64_t steps = message.count("iterations");  // else its questions; the first is the start of the search
  report_.iterations = steps >= 0 ? steps : std::max<std::int64_t>(0, report_.iterations - 1);
  const std::int64_t ours = objective.evaluations();
  // One tells nothing, and no more than joints not even the slope.
  const bool is_too_good = best_.error < (ours == 1 ? 1 : ours <= joints ? 0.1 : 0) * at_start;
  set_evaluations(ours, message.count("evaluations"), !is_too_good && std::ranges::count(seen, best_.error) > 0,
                  best.error);
}

void ExternalSolver::set_evaluations(std::int64_t ours, std::int64_t own, bool is_explained, double best) {
  if (is_explained && own <= ours) {
    report_.counted_by = CountedBy::ikbench;
    report_.evaluations = ours;
    if (report_.improved.at.back() < ours) report_.improved.add(ours, best);
  } else {
    report_.counted_by = own >= 0 ? CountedBy::solver : CountedBy::none;
    report_.evaluations = own >= 0 ? std::max(ours, own) : 0;
    report_.trace.clear();
    report_.improved = {};
  }
}

void check_answer(const Study& study, const Robot& arm, std::unique_ptr<ChildProcess>& child, SolveRecord& solve) {
  const Program& program = *study.checker;
  const bool is_new = child == nullptr;
  if (is_new) {
    child = restarted(program);
    child->write(robot_message(arm, arm.chain, Task(study, arm).goal(Pose::Identity()),
                               urdf_text_for(program, study.robot), program.hello, resolved_options(program.hello, {})),
                 deadline_in(start_timeout));
  }
  const base::OrderedJson target{{"position", solve.target_position_m}, {"rotation", solve.target_rotation}},
      question{{"message", "check"}, {"target", target}, {"start", solve.start_rad}, {"q", solve.answer_rad}};
  const Message said = send_request(*child, base::text_of(question) + '\n',
                                    deadline_in(program.choice.timeout > 0 ? program.choice.timeout : 60));
  const std::string fault = said.rejection_reason();
  std::map<std::string, double> numbers = said.extras("numbers");
  for (const std::string& name : study.check.numbers()) {
    const auto number = numbers.extract(name);
    if (number.empty() || !std::isfinite(number.mapped())) said.fail(fmt::format("\"numbers\" with a finite {}", name));
    solve.extras[fmt::format("{}{}", check_extra, name)] = number.mapped();
  }
  if (!numbers.empty())
    said.fail(
        fmt::format("only \"numbers\" that [check] names as larger or smaller, and not {}", numbers.begin()->first));
  // Who answers twice would stay behind, each answer that of the solve before.
  const ProcessFailure heard = unsolicited_message(*child, is_new ? 0.1 : 0);
  if (heard.kind != ProcessFailure::Kind::timed_out) throw ProcessFailure(heard);
  if (fault.empty()) return;
  solve.status = Status::invalid;
  solve.extras[fmt::format("{}{}", invalid_extra, fault)] = 1;
}

}  // namespace ikbench::experiments
