// One entry of a study: its solves, each timed, verified and recorded.
#pragma once

#include <algorithm>
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

template <class Numbers>
bool same_bits(const Numbers& a, const Numbers& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

// Study, entry and arm outlive it. It may be used by several threads at once, each with a solver of its own.
class SolveRunner {
 public:
  // `key` is its series_key. `repeats` is the number of timed solves per problem, 1 if a solve ends by its
  // wall time; `jobs` of solves at once.
  SolveRunner(const Study& study, const SolverEntry& entry, std::string key, const Robot& arm, int repeats = 1,
              int jobs = 1);

  const std::string& label() const { return entry_.label; }
  const std::string& key() const { return key_; }  // of its series
  // Makes a solver for any number of solves, one after the other: starting it anew makes it forget all.
  std::unique_ptr<solvers::Solver> make_solver() const;
  // If it is a program that failed in its last solve, this becomes the last failure, and the third in a row gives it
  // up. Not for a solve that is not stored.
  void count_failure(solvers::Solver& solver) const;
  std::string odd() const;  // of its program: a failure, or answers that it does not repeat; empty: nothing
  // Both throw std::runtime_error, with label, run and point, if the solver throws (std::invalid_argument, if it throws
  // that).
  // Solves once, untimed, if repeats are timed, so that the first is no slower than the others.
  void warm_up(solvers::Solver& solver, const Pose& target, const Configuration& start, int run, int point) const;
  // Also throws if a repeat has another answer, to the bit. Where the solver ends the process by `exit`, that prints a
  // sentence, and its code is 2.
  results::SolveRecord solve(solvers::Solver& solver, const Pose& target, const Configuration& start, int run,
                             int point) const;

 private:
  struct Timed {
    solvers::Solution solution = {};
    Configuration answer = {};            // all joints
    double seconds = 0;                   // to solve, and to complete the answer
    std::optional<Account> account = {};  // if a program solved
    double cpu_seconds = 0;               // of the program, else of this thread
    std::map<std::string, double> extras = {};
  };
  Timed timed(solvers::Solver& solver, const Pose& target, const Configuration& start, int run, int point) const;
  results::StopReason stop_reason_of(const Timed& timed) const;
  results::Status status_of(const Timed& timed, const Verification& verified, const Pose& target) const;
  bool is_late(const Timed& timed) const;

  const Study& study_;
  const SolverEntry& entry_;
  const Robot& arm_;
  Task task_;
  solvers::Settings options_;
  std::string key_;
  int repeats_;
  results::Timing timing_;
  bool is_counted_;                               // we count its evaluations; false if the program does
  std::unique_ptr<Conversations> conversations_;  // null if no program solves
};

}  // namespace ikbench::experiments
