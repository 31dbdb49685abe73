// Makes the solves of one solver entry of a study: each is timed, verified and recorded.
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "experiments/external/external_solver.hpp"
#include "experiments/study/study.hpp"
#include "experiments/task.hpp"
#include "experiments/verifier.hpp"
#include "results/store.hpp"
#include "solvers/registry.hpp"

namespace ikbench::experiments {

inline Eigen::VectorXd to_eigen(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
}

bool same_bits(const auto& a, const auto& b) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](double x, double y) { return bits(x) == bits(y); });
}

// The question to a solver. The target has to outlive it. The start is a copy, as it may be made of another type of
// vector.
struct SolveRequest {
  const Pose& target;
  Configuration start;
  int run, point;
};

// Makes solves of one entry. Study, entry and arm have to outlive it. Several threads may use it at once, each with a
// solver of its own.
class SolveRunner {
 public:
  // `key` is the series_key of the entry; `jobs` is the number of solves at once.
  SolveRunner(const Study& study, const SolverEntry& entry, std::string key, const Robot& arm, int jobs = 1);

  const std::string& label() const { return entry_.label; }
  const std::string& key() const { return key_; }  // key of its series
  // Makes a solver for any number of solves, one after the other. Starting it for a new solve makes it forget all.
  std::unique_ptr<solvers::Solver> make_solver() const;
  // Ends the processes of a program, which starts again when it is asked. Call this when no solver is left.
  void end_processes() const;
  // Counts a failure of a program in its last solve, which becomes the last failure. The third in a row gives the
  // program up. Not for a solve that is not stored.
  void count_failure(solvers::Solver& solver) const;
  std::string anomalies() const;  // anomalies of code of others: a failure, answers that change; empty: none
  int batch() const { return entry_.program ? entry_.program->choice.batch : 0; }
  // Asks an entry with a batch for all calls that `heat` collected since the last time; `solve` then has their answers.
  // Returns false if the batch failed, with all of its solves.
  bool send_batch(solvers::Solver& solver) const { return static_cast<ExternalSolver&>(solver).send_batch(); }
  // Starts a program, and makes a few unrecorded solves, whatever comes of them; with a batch, `together` calls at
  // once.
  void warm_up(solvers::Solver& solver, const SolveRequest& call, std::size_t together = 1) const;
  // Both throw std::runtime_error, with label, run and point, if the solver throws (std::invalid_argument, if it throws
  // that). This one solves once, unrecorded.
  void warm_call(solvers::Solver& solver, const SolveRequest& call) const { solve_timed(solver, call); }
  // Makes one timed call. Of code of others one call in ten is asked again, for `odd`. If the solver ends the process
  // by `exit`, that prints a sentence, and the exit code is 2.
  results::SolveRecord solve(solvers::Solver& solver, const SolveRequest& call) const;

 private:
  struct TimedSolve {
    solvers::Solution solution = {};
    Configuration answer = {};                 // all joints
    double seconds = 0;                        // [s] to solve, and to complete the answer
    std::optional<ProcessReport> report = {};  // if a program solved
    double cpu_seconds = 0;                    // [s] of the program, otherwise of this thread
    std::map<std::string, double> extras = {};
  };
  TimedSolve solve_timed(solvers::Solver& solver, const SolveRequest& call) const;
  results::SolveRecord make_record(const SolveRequest& call, const TimedSolve& made, results::Status status,
                                   const Configuration& answer, const Verification& verified) const;
  results::Status status_of(const TimedSolve& timed, const Verification& verified, const Pose& target) const;
  bool missed_deadline(const TimedSolve& timed) const;

  const Study& study_;
  const SolverEntry& entry_;
  const Robot& arm_;
  Task task_;
  solvers::Settings options_;
  std::string key_;
  results::Timing timing_;
  bool is_counted_;                         // true: counted here; false: by the program
  std::unique_ptr<ProcessPool> processes_;  // null if no program solves
  mutable std::atomic<int> rerun_count_ = 0, rerun_differences_ = 0;
};

}  // namespace ikbench::experiments
