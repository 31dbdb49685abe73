// A program as a solver, and as a study's check of answers. Its process is started when it is needed, asked and
// watched, and started again if it dies. The runner of solves and `ikbench check-solver` drive it. Protocol:
// docs/reference/protocol.md.
#pragma once

#include <chrono>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "experiments/external/program.hpp"
#include "experiments/study/study.hpp"
#include "results/record.hpp"
#include "solvers/solve.hpp"

namespace ikbench::experiments {

// The report on one solve by a program, besides its answer.
struct ProcessReport {
  std::optional<results::Status> failure;
  double cpu_seconds = 0;  // [s], of the program
  solvers::StopReason stopped = solvers::StopReason::finished;
  bool ignored_budget =
      false;  // the program asked for more evaluations after ikbench had said that its budget is used up
  // The side that counted the evaluations. It is not `ikbench` if the program reports more evaluations than were made
  // here, or if those made here do not explain the answer. Then `evaluations` is the larger count; 0 if the program
  // reports none.
  results::CountedBy counted_by = results::CountedBy::none;
  std::int64_t evaluations = 0, iterations = 0;
  std::vector<double> all_answers = {};  // [rad, m], of the searched joints, if the program gives all of its answers
  std::vector<double> trace = {};        // [m], best error after each request to evaluate but the first
  solvers::Improvements improved = {};
  double reported_error = std::numeric_limits<double>::quiet_NaN();    // [m], self-reported; NaN: none
  double reported_seconds = std::numeric_limits<double>::quiet_NaN();  // [s], self-reported; NaN: none
  bool is_of_second_solve = false;  // the program solved twice in a row, and reports the second solve
  bool differs_from_first = false;  // the second solve gave another answer
  int batch_size = 1;               // by which times of a batch are divided
  double seconds = 0;               // [s], the share of a batch's wall time
};

// Returns the self-reported time [s] of a program if its processor time is known and the program cannot have taken
// longer; nothing otherwise.
std::optional<double> credible_report(const ProcessReport& report);
// Returns the time [s] that a program took: the self-reported one, but at least what its processor time needs; `wall`
// [s] if the program reports none.
double credible_seconds(const ProcessReport& report, double wall);

// A running process of a program, and what is kept of it from solve to solve.
struct WorkerProcess {
  std::unique_ptr<ChildProcess> child = {};  // null until it is needed, and after a failure
  int failures_in_a_row = 0;
  std::string last_failure = {};      // "crashed: it ended (exit code 3); its last words: ..."; empty: none so far
  std::set<std::string> extras = {};  // names of extras so far
  std::optional<ProcessFailure> given_up = {};  // set if the program is given up
  std::vector<SolveQuestion> batch = {};
  std::map<std::string, std::optional<Message>> answers = {};  // by the text of a question; none: the batch failed
  ProcessReport batch_report = {};                             // shared by all questions of the batch

  bool has_answers() const { return !answers.empty() && answers.begin()->second; }
};

// Makes a few unrecorded solves: solve(0), solve(1), solve(2), or fewer if they take longer than 0.1 s.
template <class Solve>
void warm_up_calls(Solve&& solve) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(100);
  for (std::uint32_t i = 0; i < 3 && std::chrono::steady_clock::now() < end; ++i) solve(i);
}

// The idle processes of a program. Any thread may take one and give it back.
class ProcessPool {
 public:
  // `robot_text` is the first message to each process. A program that is `asked` warm solves twice in a row.
  ProcessPool(std::shared_ptr<const Program> of_program, std::string robot_text,
              results::CacheState asked = results::CacheState::first)
      : program(std::move(of_program)), robot(std::move(robot_text)), state(asked) {}

  WorkerProcess acquire();
  void release(WorkerProcess worker);
  std::string last_failure() const;  // the last failure of an idle process; empty: none
  void end_processes();              // ends idle processes; a program that is given up stays so

  const std::shared_ptr<const Program> program;
  const std::string robot;
  const results::CacheState state;

 private:
  mutable std::mutex mutex_;
  std::vector<WorkerProcess> idle_;
};

// Returns the largest time [s] that a program can report where `passed` seconds went by, since clocks differ by a tenth
// and some tick only every 20 ms.
constexpr double largest_possible_seconds(double passed) { return 1.1 * passed + 0.02; }

// Returns the answer inside the limits that is nearest to the start, or the first answer if none is inside. Each answer
// is measured as the policy will leave it, so that whole turns of an answer choose no other branch. `answers` must have
// at least one column, and `chain` is of its joints.
robots::Configuration nearest_answer(const robots::Candidates& answers, const solvers::Problem& problem,
                                     const robots::Chain& chain, results::WrapPolicy policy);

// The answers to one target that are kept in the store; further ones are lost.
constexpr Eigen::Index max_kept_answers = 1000;

// A program as a solver, which solvers::solve drives like any other; `start` is the whole exchange of messages. If the
// program fails, the error is infinite.
class ExternalSolver final : public solvers::Searcher {
 public:
  // The pool and the rule must outlive the solver. `policy` is how the study wraps answers.
  ExternalSolver(ProcessPool& pool, const solvers::StopRule& stop, results::WrapPolicy policy)
      : pool_(pool), stop_(stop), wrap_(policy), worker_(pool.acquire()) {}
  ~ExternalSolver() override { pool_.release(std::move(worker_)); }

  // Sends the next batch in one message, and returns false if it failed. A batch may be sent more than once. With
  // batches, `start` takes the answer that came for the problem. If none was asked for, `start` puts the problem into
  // the next batch.
  bool send_batch();
  void clear_batch();
  // Starts the process if there is none, and warms it up; does nothing with batches. Call it before the clock starts.
  void prepare(const solvers::Problem& problem, const solvers::Objective& objective);
  void start(const solvers::Problem& problem, solvers::Objective& objective, numerics::Random& random) override;
  void step(solvers::Objective&, numerics::Random&) override {}
  bool finished() const override { return true; }
  const ProcessReport& report() const { return report_; }
  bool is_given_up() const { return worker_.given_up.has_value(); }
  // Counts the failure of the last solve, or ends the row of failures if the solve had none. Call it after each solve
  // that counts. The worker keeps the failure as `last_failure`; the third in a row gives the program up.
  void count_failure();
  // Keeps the failure of the last solve as the worker's `last_failure`, but does not count it. Call it after a solve
  // that repeats one with an answer.
  void excuse_failure();

 private:
  struct Exchange;

  bool is_batched() const { return pool_.program->choice.batch > 0; }
  template <class Talk>
  void with_failure_handling(Talk&& talk);  // a ProcessFailure becomes the report's failure
  bool ensure_running();                    // true if the process is new
  void record_failure(const ProcessFailure& failure);
  void note_failure();  // the worker keeps it
  Clock::time_point deadline(double problems) const;

  void exchange_solve(const solvers::Problem& problem, solvers::Objective& objective, std::uint32_t seed);
  // Sets the report to that of the question's batch. A question that no batch has is put into the next one.
  void take_batch_report(const SolveQuestion& question);
  // Sends the question, and evaluates candidates until the program asks for no more. Returns the message that follows.
  Message ask(const SolveQuestion& question, Exchange& exchange);
  // Returns the errors of candidates, NaN for those that the budget leaves no room for.
  Eigen::VectorXd evaluate(const robots::Candidates& candidates, bool is_over, Exchange& exchange);
  // Takes the self-reported time of a solve, and whether the solve was the second of two.
  void take_time(const Message& message, const Exchange& exchange);
  // Takes the answer of a solve, with everything that the program reports of it.
  void take_solved(const Message& message, Exchange& exchange);
  // Returns the answer, and notes the extras of the message. Without an answer, the best candidate that was evaluated
  // is returned.
  robots::Configuration answer_in(const Message& message, const Exchange& exchange);
  bool explains_answer(const Exchange& exchange) const;
  // Sets the evaluations to those counted here if these explain the answer, otherwise to the self-reported ones.
  // `reported` is -1 if the program reports none.
  void set_evaluations(std::int64_t reported, const Exchange& exchange);

  ProcessPool& pool_;
  const solvers::StopRule& stop_;
  const results::WrapPolicy wrap_;
  WorkerProcess worker_;
  ProcessReport report_;
  std::optional<ProcessFailure> failure_;  // last failure of this solve, with how the process ended
};

// Asks the study's checker about an answer that reached its target, and starts a process of it if there is none. If the
// checker refuses the answer, the record becomes `invalid`. The record keeps the reason and the checker's numbers as
// extras. Throws ProcessFailure if the checker breaks the protocol, and std::runtime_error if its files have changed.
void check_answer(const Study& study, const Robot& arm, std::unique_ptr<ChildProcess>& child,
                  results::SolveRecord& solve);

}  // namespace ikbench::experiments
