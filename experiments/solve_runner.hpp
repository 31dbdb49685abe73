// One entry of a study: its solves, each timed, verified and recorded.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "experiments/foreign/foreign_solver.hpp"
#include "experiments/study.hpp"
#include "experiments/verifier.hpp"
#include "results/store.hpp"
#include "robots/spherical_wrist.hpp"
#include "solvers/registry.hpp"

namespace ikbench::experiments {

// What is searched for one target: all joints, or those before the wrist.
class Task {
 public:
  Task(const Study& study, const robots::Robot& arm);

  const robots::Chain& arm() const { return wrist_ ? wrist_->arm() : arm_.chain; }
  solvers::Goal goal(const robots::Pose& target) const;
  solvers::Problem problem(const robots::Configuration& start, int population) const;
  // All joints of the answer: those searched, and the wrist's by the closed form; wrapped where the study says so.
  robots::Configuration completed(const robots::Configuration& found, const robots::Pose& target,
                                  const robots::Configuration& start) const;

 private:
  void wrap(robots::Configuration& answer) const;
  std::size_t chosen(const std::array<Eigen::Vector3d, 2>& branches, const Eigen::Vector3d& near) const;

  const Study& study_;
  const robots::Robot& arm_;
  std::optional<robots::SphericalWrist> wrist_;
};

// Study, entry and arm outlive it. It may be used by several threads at once, each with a solver of its own.
// The reason as the store has it.
results::StopReason recorded(solvers::Stopped stopped);
// To the bit.
bool same_answer(const solvers::Solution& a, const solvers::Solution& b);

class SolveRunner {
 public:
  // `repeats`: how often a problem is solved, to be timed; once where a solve ends by its wall time.
  SolveRunner(const Study& study, const SolverEntry& entry, const robots::Robot& arm, int repeats);

  const results::Series& series() const { return series_; }
  // Good for any number of solves, one after the other: a solver that is started anew remembers nothing.
  std::unique_ptr<solvers::Solver> make_solver() const;
  // What its program did besides solving, while no solver of it is left; none where it is built in.
  std::optional<ProgramNotes> notes() const;
  // Where repeats are timed: solves once, untimed, so that the first is no slower than the others.
  void warm_up(solvers::Solver& solver, const robots::Pose& target, const robots::Configuration& start) const;
  // std::runtime_error where a repeat has another answer, to the bit.
  results::SolveRecord solve(solvers::Solver& solver, const robots::Pose& target, const robots::Configuration& start,
                             int run, int point) const;

 private:
  struct Timed {
    solvers::Solution solution;
    robots::Configuration answer;  // all joints
    double seconds;
    double cpu_seconds;
    std::optional<Account> account = {};  // of a program
  };
  struct Posed {  // a problem, and the random numbers to solve it by
    const robots::Pose& target;
    const robots::Configuration& start;
    solvers::Problem problem;
    numerics::Key stream;
  };
  Posed posed(const robots::Pose& target, const robots::Configuration& start, int run, int point) const;
  Timed timed(solvers::Solver& solver, const Posed& given) const;
  std::vector<Timed> repeated(solvers::Solver& solver, const Posed& given) const;
  results::Status status_of(const Timed& timed, const Verification& verified, const robots::Pose& target) const;
  // A program's solve as its account tells it.
  void add_word(Timed& timed, const Account& account) const;
  // Of a program's solve, what only its account says.
  void add_account(results::SolveRecord& record, const Account& account) const;
  double beyond_reach(const robots::Pose& target) const;  // [m]; 0 within

  const Study& study_;
  const SolverEntry& entry_;
  const robots::Robot& arm_;
  Task task_;
  robots::Chain::Ball reach_;  // of the joints that are searched
  solvers::Settings options_;
  results::Series series_;
  int repeats_;
  bool is_counted_;                     // its evaluations, here; a program's own word is not
  int hosted_repeats_ = 0;              // of a shared object, made by its host
  std::unique_ptr<Sessions> sessions_;  // of a program
};

}  // namespace ikbench::experiments
