// A program as a solver, and as a study's check of answers. Its process is started when needed, asked and watched, and
// started again if it dies.
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

#include "experiments/external/program.hpp"
#include "experiments/study/study.hpp"
#include "results/record.hpp"
#include "solvers/solve.hpp"

namespace ikbench::experiments {

// The report on one solve by a program, besides its answer.
struct ProcessReport {
  std::optional<results::Status> failure;
  double cpu_seconds = 0;  // of the program
  solvers::StopReason stopped = solvers::StopReason::finished;
  bool ignored_budget = false;  // it asked for more evaluations after it was told that its budget is used up
  // Who counted the evaluations. Not `ikbench` if the answer is none of the candidates evaluated here, or too few were
  // evaluated to find it: then the program has its own kinematics, and `evaluations` is its own count.
  results::CountedBy counted_by = results::CountedBy::none;
  std::int64_t evaluations = 0, iterations = 0;
  std::vector<double> trace = {};  // errors of the evaluations made here, as in Solution
  solvers::Improvements improved = {};
  double reported_error = std::numeric_limits<double>::quiet_NaN();  // [m], self-reported
  double reported_seconds = std::numeric_limits<double>::quiet_NaN();
  int batch_size = 1;  // size of its batch, by which times are divided
  double seconds = 0;  // [s] of the wall time of a batch
};

// Returns the time [s] that a program reports, if its processor time is known and leaves room for the report.
std::optional<double> credible_report(const ProcessReport& account);
// Returns the time [s] that a program took: its self-reported one, or its processor time if that leaves no room for the
// report; `wall` if it reports nothing.
double credible_seconds(const ProcessReport& account, double wall);

// A running process of a program, and what is kept of it from solve to solve.
struct WorkerProcess {
  std::unique_ptr<ChildProcess> child = {};  // null until it is needed, and after a failure
  int failures_in_a_row = 0;
  std::string last_failure = {};      // "crashed: it ended (exit code 3); its last words: ..."; empty: none so far
  std::set<std::string> extras = {};  // names
  std::optional<ProcessFailure> given_up = {};  // set if the program is given up
  // A batch: its problems, as their messages; the answer to each, nothing if it failed; and the report that they share.
  std::vector<std::string> batch = {};
  std::map<std::string, std::optional<Message>> answers = {};
  ProcessReport batch_report = {};
  bool has_answers() const { return !answers.empty() && answers.begin()->second; }
};

// Makes a few unrecorded solves: solve(0), solve(1), solve(2), or fewer if they take long.
template <class Solve>
void warm_up_calls(Solve&& solve) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(100);
  for (std::uint32_t i = 0; i < 3 && std::chrono::steady_clock::now() < end; ++i) solve(i);
}

// The idle processes of a program. Any thread may take one and give it back.
class ProcessPool {
 public:
  // `robot` is the first message to each process.
  ProcessPool(std::shared_ptr<const Program> its_program, std::string its_robot)
      : program(std::move(its_program)), robot(std::move(its_robot)) {}

  WorkerProcess acquire();
  void release(WorkerProcess conversation);
  std::string last_failure() const;  // the last failure of an idle process
  void end_processes();              // ends idle processes; a program that is given up stays so

  const std::shared_ptr<const Program> program;
  const std::string robot;

 private:
  mutable std::mutex mutex_;
  std::vector<WorkerProcess> idle_;
};

// A program as a solver, which solvers::solve drives like any other; `start` is the whole exchange of messages. If the
// program fails, the error is infinite.
class ExternalSolver final : public solvers::Searcher {
 public:
  ExternalSolver(ProcessPool& all, const solvers::StopRule& stop)  // both outlive it
      : pool_(all), stop_(stop), worker_(all.acquire()) {}
  ~ExternalSolver() override { pool_.release(std::move(worker_)); }

  // Sends the next batch in one message, always again; returns false if it failed. With a batch, `start` gives the
  // answer that came for the problem. If none was asked for, `start` puts the problem into the next batch.
  bool send_batch();
  void clear_batch();
  // Starts the process if there is none, and warms it up; does nothing with batches. Call it before the clock starts.
  void prepare(const solvers::Problem& problem, const solvers::Objective& objective);
  void start(const solvers::Problem& problem, solvers::Objective& objective, numerics::Random& random) override;
  void step(solvers::Objective&, numerics::Random&) override {}
  bool finished() const override { return true; }
  const ProcessReport& report() const { return report_; }
  bool is_given_up() const { return worker_.given_up.has_value(); }
  // Counts a failure. Call it after a solve that counts: its failure becomes the last one of all, and the third in a
  // row gives the program up.
  void count_failure();

 private:
  template <class Talk>
  void with_failure_handling(Talk&& talk);  // a Trouble becomes the account's failure
  bool ensure_running();                    // true if the process is new
  void record_failure(const ProcessFailure& trouble);
  Clock::time_point deadline(double problems) const;
  robots::Configuration select_answer(const robots::Candidates& answers, const solvers::Problem& problem,
                                      solvers::Objective& objective) const;
  // Notes what the message reports, and takes its answer; without one, the best candidate that was evaluated.
  void take_answer(const Message& message, const solvers::Problem& problem, solvers::Objective& objective,
                   const robots::Configuration& evaluated);
  void exchange_solve(const solvers::Problem& problem, solvers::Objective& objective, std::uint32_t seed);
  // Takes our count of evaluations if these explain the answer, otherwise the program's own, if it has one.
  void set_evaluations(std::int64_t ours, std::int64_t own, bool is_explained, double best);

  ProcessPool& pool_;
  const solvers::StopRule& stop_;
  WorkerProcess worker_;
  ProcessReport report_;
  std::optional<ProcessFailure> failure_;  // last failure of this solve, with how the process ended
};

// Asks the study's checker about an answer that reached its target, and starts a process of it if there is none. If the
// checker refuses the answer, the record becomes `invalid`. The record keeps the reason and the checker's numbers as
// extras. Throws Trouble if the checker breaks the protocol, and std::runtime_error if its files have changed.
void check_answer(const Study& study, const Robot& arm, std::unique_ptr<ChildProcess>& child,
                  results::SolveRecord& solve);

}  // namespace ikbench::experiments
