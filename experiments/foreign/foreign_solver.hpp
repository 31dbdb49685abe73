// A program as a solver, and as a study's check of answers. Its process is started when needed, asked and watched, and
// started anew if it dies.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "experiments/foreign/program.hpp"
#include "experiments/study.hpp"
#include "results/record.hpp"
#include "solvers/solve.hpp"

namespace ikbench::experiments {

// Facts about one solve besides its answer.
struct Account {
  std::optional<results::Status> failure;
  double cpu_seconds = 0;  // of the program
  solvers::StopReason stopped = solvers::StopReason::finished;
  bool went_on = false;  // it wanted more evaluations after it was told that its budget is used up
  // It is not `suite` if its answer is none of the candidates evaluated here, or if these are too few to have found it:
  // then it has kinematics of its own, and `evaluations` is its own count.
  results::CountedBy counted_by = results::CountedBy::nobody;
  std::int64_t evaluations = 0, iterations = 0;
  std::vector<double> trace = {};  // of the evaluations made here, as in Solution
  solvers::Improvements improved = {};
  double claimed_error = std::numeric_limits<double>::quiet_NaN();  // [m], its word
  double claimed_seconds = std::numeric_limits<double>::quiet_NaN();
  int together = 1;    // the size of its batch, whose times are divided by it
  double seconds = 0;  // its part of the wall time of a batch
};

// What a program took by its own word [s], or by its processor time if that leaves no room for it; `wall` if it tells
// nothing.
double own_seconds(const Account& account, double wall);

// A process of a program, and what is kept from solve to solve.
struct Conversation {
  std::unique_ptr<ChildProcess> child = {};  // null until it is needed, and after a failure
  int failures_in_a_row = 0;
  std::string last_failure = {};        // "crashed: it ended (exit code 3); its last words: ..."; empty: none so far
  std::set<std::string> extras = {};    // names
  std::optional<Trouble> refusal = {};  // set if it is given up
  // Of a batch: its problems, as their messages; what was answered to them, nothing if it failed; what they share.
  std::vector<std::string> batch = {};
  std::map<std::string, std::optional<Message>> answers = {};
  Account each = {};
  bool is_answered() const { return !answers.empty() && answers.begin()->second; }
};

// A few unrecorded solves: solve(0), solve(1), solve(2), or fewer that take long.
template <class Solve>
void solve_unrecorded(Solve&& solve) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(100);
  for (std::uint32_t i = 0; i < 3 && std::chrono::steady_clock::now() < end; ++i) solve(i);
}

// The idle conversations with a program. Any thread may take one and give it back.
class Conversations {
 public:
  // `robot` is the first message to each process.
  Conversations(std::shared_ptr<const Program> its_program, std::string its_robot)
      : program(std::move(its_program)), robot(std::move(its_robot)) {}

  Conversation take();
  void give_back(Conversation conversation);
  std::string last_failure() const;  // of an idle one
  void end_processes();              // of the idle ones; a program that is given up stays so

  const std::shared_ptr<const Program> program;
  const std::string robot;

 private:
  mutable std::mutex mutex_;
  std::vector<Conversation> idle_;
};

// solvers::solve drives it like any other solver; `start` is the whole conversation. If the program fails, the error is
// infinite.
class ForeignSolver final : public solvers::Searcher {
 public:
  ForeignSolver(Conversations& all, const solvers::StopRule& stop)  // both outlive it
      : all_(all), stop_(stop), own_(all.take()) {}
  ~ForeignSolver() override { all_.give_back(std::move(own_)); }

  // Of an entry with a batch `start` gives the answer that came for the problem in a batch. Where none was asked for,
  // it puts the problem into the next batch, and `ask` sends this in one message, every time anew; false: it failed.
  bool ask();
  void forget_batch();
  // Call before the clock starts: starts the process if there is none, and warms it up; nothing where batches are
  // asked.
  void prepare(const solvers::Problem& problem, const solvers::Objective& objective);
  void start(const solvers::Problem& problem, solvers::Objective& objective, numerics::Random& random) override;
  void step(solvers::Objective&, numerics::Random&) override {}
  bool finished() const override { return true; }
  const Account& account() const { return account_; }
  bool is_given_up() const { return own_.refusal.has_value(); }
  // Call it after a solve that counts: its failure becomes the last one of all, and the third in a row gives the
  // program up.
  void count_failure();

 private:
  template <class Talk>
  void guarded(Talk&& talk);  // Trouble becomes the account's failure
  bool ensure_running();      // true if the process is new
  void note(const Trouble& trouble);
  Clock::time_point deadline(double problems) const;
  robots::Configuration nearest(const robots::Candidates& answers, const solvers::Problem& problem,
                                solvers::Objective& objective) const;
  // Notes what it tells, and takes its answer; without one, the best that it let evaluate.
  void take_answer(const Message& message, const solvers::Problem& problem, solvers::Objective& objective,
                   const robots::Configuration& evaluated);
  void converse(const solvers::Problem& problem, solvers::Objective& objective, std::uint32_t seed);
  // Our count of evaluations where they explain the answer, or the program's own, if it has one.
  void count(std::int64_t ours, std::int64_t own, bool is_explained, double best);

  Conversations& all_;
  const solvers::StopRule& stop_;
  Conversation own_;
  Account account_;
  std::optional<Trouble> failure_;  // the last one of this solve, with how the process ended
};

// Asks the study's checker about an answer that reached; a process of it is started if there is none. The record
// becomes `invalid` if it says so, and keeps as extras why, and its numbers. Throws Trouble if it says nothing that
// makes sense, and std::runtime_error if it is not what it was.
void check_answer(const Study& study, const Robot& arm, std::unique_ptr<ChildProcess>& child,
                  results::SolveRecord& solve);

}  // namespace ikbench::experiments
