// The interface of a solver: start, step, best, and perhaps finished. A solver has no loop, clock, stop rule, log or
// counter; `solve` (solve.hpp) has them. docs/extending.md shows how to add a solver.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "numerics/random.hpp"
#include "numerics/stop_rule.hpp"
#include "solvers/objective.hpp"

namespace ikbench::solvers {

using numerics::Random, numerics::StopRule, robots::Candidates, robots::Configuration;

// Returns the number of iterations that fit into a solve if each evaluates a population; at least one, unless
// `iterations` is 0.
inline int planned_iterations(const StopRule& stop, int population) {
  if (stop.evaluations <= 0) return stop.iterations;
  const std::int64_t fit = std::max<std::int64_t>(1, stop.evaluations / population);
  return static_cast<int>(std::min<std::int64_t>(stop.iterations, fit));
}

// The course of the best error: the number of evaluations at each improvement, and the new best error [m].
struct Improvements {
  std::vector<std::int64_t> at;
  std::vector<double> to;

  void add(std::int64_t evaluations, double error) {
    at.push_back(evaluations);
    to.push_back(error);
  }
};

// The task of a solver, apart from the objective.
struct Problem {
  Configuration start;  // Theta_s [rad]: the arm's configuration, searched joints only
  Configuration lower;  // joint limits [rad], Eq. 4; infinite of continuous joints
  Configuration upper;
  int population = 50;   // candidates per iteration
  int iterations = 200;  // planned_iterations, set by `solve`, for schedules that end with the solve
  // The stop rule, which `solve` applies to every solver. A solver that makes one library call per step hands the rule
  // to the library.
  StopRule stop = {};
  Improvements* improvements = nullptr;  // gets improvements within a step; may be null

  int joints() const { return static_cast<int>(start.size()); }
};

// The best candidate so far.
struct Best {
  Configuration q;                                         // [rad]
  double error = std::numeric_limits<double>::infinity();  // [m], as the objective gave it

  // Keeps the candidate and returns true if it is better. A candidate whose error is NaN is never better.
  template <class Candidate>
  bool improve(const Candidate& candidate, double candidate_error) {
    if (!(candidate_error < error)) return false;
    q = candidate;
    error = candidate_error;
    return true;
  }
};

// A solver. `solve` calls `start` once and then `step` until the solve ends.
class Solver {
 public:
  virtual ~Solver() = default;

  // Draws and evaluates the first candidates, and allocates all memory. A second start for a problem of the same size
  // must allocate none.
  virtual void start(const Problem& problem, Objective& objective, Random& random) = 0;
  // Makes one iteration.
  virtual void step(Objective& objective, Random& random) = 0;
  // Returns the best candidate so far. Its error never grows, and is exactly that of the objective.
  virtual const Best& best() const = 0;
  // Returns true if a further step changes nothing: for solvers that end by themselves.
  virtual bool finished() const { return false; }
  // Returns true if the solver has finished, and says that it found no solution.
  virtual bool gave_up() const { return false; }
  // Returns how often the solver began its search again in this solve.
  virtual int restarts() const { return 0; }
};

// A base class for solvers that keep their problem and the best of their candidates.
class Searcher : public Solver {
 public:
  const Best& best() const final { return best_; }

 protected:
  void take(const Problem& problem) {
    problem_ = problem;
    best_ = {problem.start};
  }
  void evaluate_all(Objective& objective, const Candidates& q, Eigen::VectorXd& errors) {
    objective.errors(q, errors);
    for (Eigen::Index i = 0; i < q.cols(); ++i) best_.improve(q.col(i), errors[i]);
  }

  Problem problem_;
  Best best_;
};

}  // namespace ikbench::solvers
