#include "experiments/foreign/foreign_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "solvers/solve.hpp"
#include "solvers/tolerance.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace results;

namespace {

constexpr int warm_ups = 3, most_deaths_in_a_row = 3;
constexpr double infinite = std::numeric_limits<double>::infinity();

// The seed that a program gets: the first number of the solve's stream.
std::uint32_t seed_of(Random& random) {
  constexpr double seeds = 4294967296;  // 2^32: larger seeds do not survive every language's numbers
  return static_cast<std::uint32_t>(random.uniform() * seeds);
}

// Records the course of the best error as solvers::solve does.
void add_best(Account& account, std::int64_t evaluations, double best, double at_start) {
  Improvements& improved = account.improved;
  if (improved.at.empty()) {
    if (evaluations == 1) at_start = best;
    improved.add(1, std::max(at_start, best));
  } else {
    account.trace.push_back(best);
  }
  if (best < improved.to.back()) improved.add(evaluations, best);
}

}  // namespace

class Session {
 public:
  Session(const Program& program, const std::string& robot) : program_(program), robot_(robot) {}
  ~Session() {
    if (child_) child_->end(std::chrono::seconds(1));
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // Returns true if the process is new. Throws std::runtime_error if the program is not what it was.
  bool ensure_running() {
    if (refusal_) throw Trouble(*refusal_);
    if (child_ && !child_->is_running()) fail({Status::crashed, "it ended between two solves"});
    if (refusal_) throw Trouble(*refusal_);
    if (child_) {
      for (int i = 0; i < 1000 && child_->has_line(); ++i) {
        if (const std::string line = child_->read_line(Clock::now()); line.starts_with('{'))
          Message(line).fail("nothing before it is asked");
      }
      return false;
    }
    constexpr const char* advice = "run the study again, and it goes on";
    if (!program_.is_unchanged())
      throw std::runtime_error(
          fmt::format("the files of {} changed while it ran; {}", program_.choice.process[0], advice));
    try {
      Hello hello;
      child_ = started(program_.choice, program_.folder, hello);
    } catch (const std::invalid_argument& error) {  // it started before, so this is no result of the program
      throw std::runtime_error(fmt::format("{}, which it could before; {}", error.what(), advice));
    }
    child_->write(robot_, Clock::now() + std::chrono::seconds(20));
    return true;
  }

  Message exchange(const std::string& text, Clock::time_point deadline) {
    child_->write(text, deadline);
    return next_message(*child_, deadline);
  }

  // Notes the trouble and ends the process, unless it only declined.
  void fail(const Trouble& trouble) {
    if (refusal_) return;
    notes_.last_failure = fmt::format("{}: {}", name_of(trouble.status), trouble.why);
    if (trouble.status == Status::declined) return;
    if (child_) {
      const bool has_ended = trouble.status == Status::crashed;
      child_->end(std::chrono::seconds(has_ended ? 1 : 0));
      if (has_ended) notes_.last_failure += fmt::format(" ({})", child_->how_it_ended());
      notes_.last_failure += child_->last_words();
    }
    child_.reset();
    ++notes_.deaths;
    if (++deaths_in_a_row_ < most_deaths_in_a_row) return;
    notes_.last_failure += "; it is given up after three failures in a row";
    refusal_ = trouble;
  }

  const Program& program() const { return program_; }
  double cpu_seconds() const { return child_->cpu_seconds(); }
  void forgive() { deaths_in_a_row_ = 0; }
  const ProgramNotes& notes() const { return notes_; }

 private:
  const Program& program_;
  const std::string& robot_;
  std::unique_ptr<ChildProcess> child_;
  int deaths_in_a_row_ = 0;
  std::optional<Trouble> refusal_;  // set if it is given up
  ProgramNotes notes_;
};

Sessions::Sessions(std::shared_ptr<const Program> program, std::string robot)
    : program_(std::move(program)), robot_(std::move(robot)) {}

Sessions::~Sessions() = default;

std::unique_ptr<Session> Sessions::take() {
  const std::scoped_lock lock(mutex_);
  if (idle_.empty()) return std::make_unique<Session>(*program_, robot_);
  std::unique_ptr<Session> session = std::move(idle_.back());
  idle_.pop_back();
  return session;
}

void Sessions::give_back(std::unique_ptr<Session> session) {
  const std::scoped_lock lock(mutex_);
  idle_.push_back(std::move(session));
}

ProgramNotes Sessions::notes() const {
  const std::scoped_lock lock(mutex_);
  ProgramNotes all;
  for (const auto& session : idle_) {
    all.deaths += session->notes().deaths;
    if (!session->notes().last_failure.empty()) all.last_failure = session->notes().last_failure;
  }
  return all;
}

ForeignSolver::ForeignSolver(Sessions& sessions, const StopRule& stop)
    : sessions_(sessions), stop_(stop), session_(sessions.take()) {}

ForeignSolver::~ForeignSolver() { sessions_.give_back(std::move(session_)); }

template <class Talk>
void ForeignSolver::guarded(Talk&& talk) {
  if (account_.failure) return;
  try {
    talk();
  } catch (const Trouble& trouble) {
    session_->fail(trouble);
    account_ = {.failure = trouble.status};
    best_.error = infinite;
  }
}

void ForeignSolver::prepare(const Problem& problem, const Objective& objective) {
  account_ = {};
  guarded([&] {
    if (!session_->ensure_running()) return;
    for (std::uint32_t i = 0; i < warm_ups; ++i) {
      Objective unrecorded(objective.arm(), objective.goal());
      converse(problem, unrecorded, i);
    }
  });
}

void ForeignSolver::start(const Problem& problem, Objective& objective, Random& random) {
  best_ = {problem.start};
  guarded([&] {
    converse(problem, objective, seed_of(random));
    session_->forgive();
  });
}

// The rule that ends the evaluations, in the order of solvers::solve.
std::optional<StopReason> ForeignSolver::end_of_budget(const Objective& objective, Clock::time_point began) const {
  if (account_.iterations >= stop_.iterations) return StopReason::iterations;
  if (stop_.evaluations > 0 && objective.evaluations() >= stop_.evaluations) return StopReason::evaluations;
  const std::chrono::duration<double> took = Clock::now() - began;
  if (stop_.seconds > 0 && took.count() >= stop_.seconds) return StopReason::time;
  return std::nullopt;
}

void ForeignSolver::converse(const Problem& problem, Objective& objective, std::uint32_t seed) {
  account_ = {};
  const Clock::time_point began = Clock::now();
  const double patience = session_->program().choice.patience;
  const std::chrono::duration<double> given(patience > 0 ? patience : std::clamp(20 * stop_.seconds, 5.0, 1e6));
  const Clock::time_point deadline = began + std::chrono::duration_cast<Clock::duration>(given);
  const double cpu_before = session_->cpu_seconds();
  const int joints = problem.joints();
  Objective uncounted(objective.arm(), objective.goal());
  Tolerance tolerance(stop_.tolerance, stop_.angle_tolerance, uncounted);
  const double at_start = uncounted.error(problem.start);
  Best best;
  std::vector<double> seen;  // errors
  bool is_over = false;
  Message message = session_->exchange(solve_message(problem, objective.goal(), stop_, seed), deadline);
  for (; message.name() == "evaluate"; ++account_.iterations) {
    const Candidates q = message.candidates(joints);
    account_.went_on |= is_over;
    const std::int64_t left = stop_.evaluations > 0 ? stop_.evaluations - objective.evaluations() : q.cols();
    const Eigen::Index taken = is_over ? 0 : std::min<Eigen::Index>(left, q.cols());
    Eigen::VectorXd errors = Eigen::VectorXd::Constant(q.cols(), std::numeric_limits<double>::quiet_NaN());
    if (taken > 0) objective.errors(q.leftCols(taken), errors.head(taken));
    for (Eigen::Index i = 0; i < taken; ++i) best.improve(q.col(i), errors[i]);
    seen.insert(seen.end(), errors.begin(), errors.begin() + taken);
    if (taken > 0) add_best(account_, objective.evaluations(), best.error, at_start);
    const std::optional<StopReason> end = end_of_budget(objective, began);
    if (end && !is_over) account_.stopped = *end;
    is_over |= end || tolerance.is_reached(best);
    message = session_->exchange(errors_message(errors, is_over), deadline);
  }
  account_.cpu_seconds = std::max(0.0, session_->cpu_seconds() - cpu_before);  // 0: it ended at once
  if (message.name() == "declined") throw Trouble{Status::declined, message.why()};
  if (message.name() != "solved") message.fail("\"evaluate\", \"solved\" or \"declined\"");

  best_.q = message.has("q") || best.q.size() == 0 ? message.joints(joints) : best.q;
  best_.error = uncounted.error(best_.q);
  account_.claimed_error = message.number("error");
  account_.claimed_seconds = message.number("seconds");
  const std::int64_t steps = message.count("iterations");  // else its questions; the first is the start of the search
  account_.iterations = steps >= 0 ? steps : std::max<std::int64_t>(0, account_.iterations - 1);
  const std::int64_t ours = objective.evaluations(), own = message.count("evaluations");
  const bool was_evaluated = std::ranges::find(seen, best_.error) != seen.end();
  // One tells nothing, and no more than joints not even the slope.
  const bool is_too_good = best_.error < (ours == 1 ? 1 : ours <= joints ? 0.1 : 0) * at_start;
  if (was_evaluated && !is_too_good && own <= ours) {
    account_.counted_by = CountedBy::suite;
    account_.evaluations = ours;
    if (account_.improved.at.back() < ours) account_.improved.add(ours, best.error);
  } else {
    account_.counted_by = own >= 0 ? CountedBy::solver : CountedBy::nobody;
    account_.evaluations = own >= 0 ? std::max(ours, own) : 0;
    account_.trace.clear();
    account_.improved = {};
  }
}

}  // namespace ikbench::experiments
