#include "experiments/foreign/foreign_solver.hpp"

#include <algorithm>
#include <utility>

#include "experiments/foreign/session.hpp"
#include "solvers/solve.hpp"

namespace ikbench::experiments {

using namespace numerics;
using namespace robots;
using namespace solvers;
using namespace results;

namespace {

constexpr int warm_ups = 3;
constexpr std::size_t most_examples = 100;
constexpr double infinite = std::numeric_limits<double>::infinity();

// The seed that a program gets: the first number of the solve's stream.
std::uint32_t seed_of(Random& random) {
  constexpr double seeds = 4294967296;  // 2^32: larger seeds do not survive every language's numbers
  return static_cast<std::uint32_t>(random.uniform() * seeds);
}

}  // namespace

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
    const ProgramNotes& notes = session->notes();
    all.deaths += notes.deaths;
    all.noise += notes.noise;
    all.is_given_up |= notes.is_given_up;
    if (!notes.last_failure.empty()) all.last_failure = notes.last_failure;
    for (const std::string& line : notes.examples) {
      if (all.examples.size() < most_examples) all.examples.push_back(line);
    }
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
    try {
      talk();
    } catch (const Breach& breach) {
      throw Trouble{Status::broke_protocol, breach.what()};
    }
  } catch (const Trouble& trouble) {
    session_->note(trouble);
    trouble_ = trouble.why;
    account_.failure = trouble.status;
    best_.error = infinite;
    is_finished_ = true;
  }
}

void ForeignSolver::prepare(const Problem& problem, const Objective& objective) {
  account_ = {};
  is_open_ = is_warming_up_ = true;
  bool is_new = false;
  guarded([&] {
    is_new = session_->ensure_running();
    session_->drain();
  });
  for (int i = 0; is_new && i < warm_ups && !account_.failure; ++i) {
    Objective unrecorded(objective.arm(), objective.goal());
    Random random(Key(0).with("warm-up").with(static_cast<std::uint64_t>(i)));
    solvers::solve(*this, problem, unrecorded, random, stop_);
    if (!account_.failure) conclude();
  }
  if (account_.failure) {
    conclude();
  } else {
    account_ = {};
  }
  is_open_ = is_warming_up_ = false;
}

void ForeignSolver::start(const Problem& problem, Objective& objective, Random& random) {
  best_.q = problem.start;
  best_.error = infinite;
  is_finished_ = false;
  is_telling_ = false;
  joints_ = problem.joints();
  guarded([&] {
    is_open_ = true;
    session_->begin_solve(stop_.seconds);
    cpu_before_ = session_->cpu_seconds();
    const std::uint32_t seed = seed_of(random);
    const Mode mode = sessions_.program().mode;
    const std::int64_t id = session_->new_id();
    const std::string text =
        solve_message(mode, {.id = id, .problem = problem, .goal = objective.goal(), .stop = stop_, .seed = seed});
    if (mode == Mode::ask) {
      take_in(session_->exchange(text, {"ask", "solved", "declined"}), objective);
    } else {
      solve_at_once(text, objective);
    }
  });
}

void ForeignSolver::solve_at_once(const std::string& text, Objective& objective) {
  const Clock::time_point began = Clock::now();  // before it is sent: the program may have the processor at once
  const Message message = session_->exchange(text, {"solved", "declined"});
  account_.seconds = std::chrono::duration<double>(Clock::now() - began).count();
  if (message.name == "declined") throw Trouble{Status::declined, why_in(message.json)};
  account_.word = solved_in(message, joints_);
  best_.q = account_.word.q;
  best_.error = objective.error(best_.q);
  is_finished_ = true;
}

void ForeignSolver::take_in(const Message& message, Objective& objective) {
  is_telling_ = false;
  if (message.name == "declined") throw Trouble{Status::declined, why_in(message.json)};
  if (message.name == "solved") {
    is_finished_ = true;
    return;
  }
  const Candidates q = candidates_in(message, joints_);
  const std::int64_t budget = stop_.evaluations > 0 ? stop_.evaluations - objective.evaluations() : q.cols();
  const Eigen::Index taken = std::clamp<Eigen::Index>(budget, 0, q.cols());
  errors_ = Eigen::VectorXd::Constant(q.cols(), std::numeric_limits<double>::quiet_NaN());
  if (taken > 0) objective.errors(q.leftCols(taken), errors_.head(taken));
  for (Eigen::Index i = 0; i < taken; ++i) best_.improve(q.col(i), errors_[i]);
  is_telling_ = true;
}

void ForeignSolver::step(Objective& objective, Random&) {
  guarded([&] {
    take_in(
        session_->exchange(tell_message(session_->id(), errors_, best_.error, Over::no), {"ask", "solved", "declined"}),
        objective);
  });
}

void ForeignSolver::conclude() {
  if (!std::exchange(is_open_, false)) return;
  if (account_.failure) {
    session_->recover({*account_.failure, trouble_});
    return;
  }
  account_.cpu_seconds = session_->cpu_seconds() - cpu_before_;
  try {
    if (is_telling_) {
      session_->exchange(tell_message(session_->id(), errors_, best_.error, Over::yes), {"solved"});
    }
    if (!is_warming_up_) session_->forgive();
  } catch (const Trouble& trouble) {  // the answer counts all the same
    session_->recover(trouble);
    if (is_warming_up_) account_.failure = trouble.status;
  }
}

}  // namespace ikbench::experiments
