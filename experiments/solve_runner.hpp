// One entry of a study: its solves, each timed, verified and recorded.
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "experiments/foreign/foreign_solver.hpp"
#include "experiments/study.hpp"
#include "experiments/task.hpp"
#include "experiments/verifier.hpp"
#include "results/store.hpp"
#include "solvers/registry.hpp"

namespace ikbench::experiments {

inline Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
}

bool same_bits(const auto& a, const auto& b) {
  const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](double x, double y) { return bits(x) == bits(y); });
}

// What a solver is asked. The target outlives it; the start is its own, as it may be made of another type of vector.
struct Call {
  const Pose& target;
  Configuration start;
  int run, point;
};

// Study, entry and arm outlive it. It may be used by several threads at once, each with a solver of its own.
class SolveRunner {
 public:
  // `key` is its series_key; `jobs` of solves at once.
  SolveRunner(const Study& study, const SolverEntry& entry, std::string key, const Robot& arm, int jobs = 1);

  const std::string& label() const { return entry_.label; }
  const std::string& key() const { return key_; }  // of its series
  // Makes a solver for any number of solves, one after the other: starting it anew makes it forget all.
  std::unique_ptr<solvers::Solver> make_solver() const;
  // Of a program, which starts anew when it is asked again; call it when no solver is left.
  void end_processes() const;
  // If it is a program that failed in its last solve, this becomes the last failure, and the third in a row gives it
  // up. Not for a solve that is not stored.
  void count_failure(solvers::Solver& solver) const;
  std::string odd() const;  // of what others wrote: a failure, or answers that it does not repeat; empty: nothing
  int batch() const { return entry_.program ? entry_.program->choice.batch : 0; }
  // Asks an entry with a batch for all calls by `heat` since the last time; `solve` then has their answers. False: it
  // failed, with all of them.
  bool ask(solvers::Solver& solver) const { return static_cast<ForeignSolver&>(solver).ask(); }
  // Starts a program; solves a few times, unrecorded, whatever comes of it; so many calls together in a batch.
  void warm_up(solvers::Solver& solver, const Call& call, std::size_t together = 1) const;
  // Both throw std::runtime_error, with label, run and point, if the solver throws (std::invalid_argument, if it throws
  // that). Solves once, unrecorded.
  void heat(solvers::Solver& solver, const Call& call) const { timed(solver, call); }
  // One timed call. Of what others wrote one in ten is asked again, for `odd`. Where the solver ends the process by
  // `exit`, that prints a sentence, and its code is 2.
  results::SolveRecord solve(solvers::Solver& solver, const Call& call) const;

 private:
  struct Timed {
    solvers::Solution solution = {};
    Configuration answer = {};            // all joints
    double seconds = 0;                   // to solve, and to complete the answer
    std::optional<Account> account = {};  // if a program solved
    double cpu_seconds = 0;               // of the program, else of this thread
    std::map<std::string, double> extras = {};
  };
  Timed timed(solvers::Solver& solver, const Call& call) const;
  results::SolveRecord record_of(const Call& call, const Timed& made, results::Status status,
                                 const Configuration& answer, const Verification& verified) const;
  results::Status status_of(const Timed& timed, const Verification& verified, const Pose& target) const;
  bool is_late(const Timed& timed) const;

  const Study& study_;
  const SolverEntry& entry_;
  const Robot& arm_;
  Task task_;
  solvers::Settings options_;
  std::string key_;
  results::Timing timing_;
  bool is_counted_;                               // we count its evaluations; false if the program does
  std::unique_ptr<Conversations> conversations_;  // null if no program solves
  mutable std::atomic<int> asked_again_ = 0, differed_ = 0;
};

}  // namespace ikbench::experiments
