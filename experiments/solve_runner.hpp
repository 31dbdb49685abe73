// Makes the solves of one solver entry of a study: each is timed, verified and recorded. The runner of studies has one
// SolveRunner per entry; readers of a store use it to repeat stored solves. How times are measured:
// docs/explanation/methods.md#times.
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

// Returns true if two lists of doubles have the same bits.
bool same_bits(const auto& a, const auto& b) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](double x, double y) { return bits(x) == bits(y); });
}

// One solve that a solver is asked for. The target must outlive the request. The start is a copy, because callers make
// it of several types of vectors.
struct SolveRequest {
  const Pose& target;
  Configuration start;
  int run, point;
};

// Makes solves of one entry. Study, entry and arm must outlive the runner. Several threads may use one runner at once,
// each with a solver of its own.
class SolveRunner {
 public:
  // `key` is the series_key of the entry; `jobs` is the number of solves at once.
  SolveRunner(const Study& study, const SolverEntry& entry, std::string key, const Robot& arm, int jobs = 1);

  const std::string& label() const { return entry_.label; }
  const std::string& key() const { return key_; }  // of the entry's series
  // Makes a solver for any number of solves, one after the other. Starting it for a new solve makes it forget all.
  std::unique_ptr<solvers::Solver> make_solver() const;
  // Ends the processes of a program, which starts again when it is asked. Call this when no solver is in use.
  void end_processes() const;
  // Counts a failure of a program in its last solve, which becomes the last failure. The third in a row gives the
  // program up. Not for a solve that is not stored.
  void count_failure(solvers::Solver& solver) const;
  // Returns the anomalies of a program or of a user's class: the last failure, and answers that change; empty: none.
  std::string anomalies() const;
  bool is_program() const { return processes_ != nullptr; }
  int batch() const { return entry_.program ? entry_.program->choice.batch : 0; }
  // Asks an entry with a batch for all calls that `warm_call` collected since the last batch; `solve` then has their
  // answers. Returns false if the batch failed, with all of its solves.
  bool send_batch(solvers::Solver& solver) const { return static_cast<ExternalSolver&>(solver).send_batch(); }
  // Starts a program, and makes a few unrecorded solves, whatever comes of them. A batch of them has `together` calls.
  void warm_up(solvers::Solver& solver, const SolveRequest& call, std::size_t together = 1) const;
  // Makes one unrecorded call, after which caches hold the data of this target. Throws like `solve`.
  void warm_call(solvers::Solver& solver, const SolveRequest& call) const { solve_timed(solver, call); }
  // Makes one timed call. A call in ten of a program or of a user's class is repeated, for `anomalies`. If the solver
  // throws, this throws with label, run and point: std::invalid_argument for that, otherwise std::runtime_error. If the
  // solver ends the process by `exit`, that prints a sentence, and the exit code is 2.
  results::SolveRecord solve(solvers::Solver& solver, const SolveRequest& call) const;

 private:
  struct TimedSolve {
    solvers::Solution solution = {};
    Configuration answer = {};                 // [rad, m], all joints
    double seconds = 0;                        // [s], to solve and to complete the answer
    std::optional<ProcessReport> report = {};  // of a program, or of a file of answers
    double cpu_seconds = 0;                    // [s], of the program, otherwise of this thread
    std::map<std::string, double> extras = {};
    std::vector<double> all_answers = {};  // [rad, m], if the solver gives all of its answers
  };
  TimedSolve solve_timed(solvers::Solver& solver, const SolveRequest& call) const;
  results::SolveRecord make_record(const SolveRequest& call, const TimedSolve& made, results::Status status,
                                   const Configuration& answer, const Verification& verified) const;
  results::Status status_of(const TimedSolve& timed, const Verification& verified, const Pose& target) const;
  bool missed_deadline(const TimedSolve& timed) const;
  results::Timing timing_of_solve(const TimedSolve& made) const;
  // Returns true if the solver ended the solve; otherwise the clock may have chosen the answer.
  bool ended_itself(const TimedSolve& timed) const;
  // Counts whether the second of two solves of a program gave another answer.
  void count_second_solve(const TimedSolve& made) const;
  // Repeats a solve if it is one in ten, and counts whether the answer differs.
  void count_rerun(solvers::Solver& solver, const SolveRequest& call, const TimedSolve& made) const;

  const Study& study_;
  const SolverEntry& entry_;
  const Robot& arm_;
  Task task_;
  solvers::Settings options_;
  std::string key_;
  results::Timing timing_;
  bool is_counted_;                         // true: evaluations are counted here, or by a program
  std::unique_ptr<ProcessPool> processes_;  // null if no program solves
  mutable std::atomic<int> rerun_count_ = 0, rerun_differences_ = 0;
  mutable std::atomic<int> second_count_ = 0, second_differences_ = 0;  // of second solves
};

}  // namespace ikbench::experiments
