// What a solver is: start, step, best, and perhaps finished. No loop, clock, stop rule, log or counter inside; `solve`
// (solve.hpp) owns those.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "numerics/random.hpp"
#include "solvers/objective.hpp"

namespace ikbench::solvers {

// A solve ends at the first that is reached. 0 means: no such rule, except for iterations.
struct StopRule {
  int iterations = 200;
  double tolerance = 0;          // [m] of the position; for a pose reached where the angle's is too
  double angle_tolerance = 0;    // [rad] of the orientation of a pose
  std::int64_t evaluations = 0;  // checked after each iteration
  double seconds = 0;            // wall time, checked after each iteration
};

// How many iterations fit into a solve, where each evaluates a population: at least one, if it may take any.
inline int planned_iterations(const StopRule& stop, int population) {
  if (stop.evaluations <= 0) return stop.iterations;
  const std::int64_t fit = std::max<std::int64_t>(1, stop.evaluations / population);
  return static_cast<int>(std::min<std::int64_t>(stop.iterations, fit));
}

// Where the best error became smaller: the evaluations until then, and the best error [m].
struct Improvements {
  std::vector<std::int64_t> at;
  std::vector<double> to;

  void add(std::int64_t evaluations, double error) {
    at.push_back(evaluations);
    to.push_back(error);
  }
};

// What a solver is told of the task besides the objective.
struct Problem {
  robots::Configuration
      start;  // Theta_s: the configuration the arm is in [rad]; its size is the number of joints searched
  robots::Configuration lower;  // joint limits [rad], Eq. 4; infinite where a joint turns without end
  robots::Configuration upper;
  int population = 50;   // candidates an iteration
  int iterations = 200;  // planned_iterations, told by `solve`; for schedules that end with the solve
  // `solve` applies it to every solver. It is for those that hand it to a library, one call of which is one step.
  StopRule stop = {};
  Improvements* improvements = nullptr;  // likewise: gets what becomes better within a step; null: not asked for

  int joints() const { return static_cast<int>(start.size()); }
};

struct Best {
  robots::Configuration q;                                 // [rad]
  double error = std::numeric_limits<double>::infinity();  // [m], as the objective gave it

  // Keeps the candidate if it is better; says whether it did.
  template <class Candidate>
  bool improve(const Candidate& candidate, double candidate_error) {
    if (!(candidate_error < error)) return false;
    q = candidate;
    error = candidate_error;
    return true;
  }
};

class Solver {
 public:
  virtual ~Solver() = default;

  // Draws and evaluates the first candidates. All memory is taken here; a second start for a problem of the same size
  // needs none.
  virtual void start(const Problem& problem, Objective& objective, numerics::Random& random) = 0;
  // One iteration.
  virtual void step(Objective& objective, numerics::Random& random) = 0;
  // The best so far; its error never grows and is exactly what the objective says of its q.
  virtual const Best& best() const = 0;
  // Whether a further step changes nothing: for solvers that end by themselves.
  virtual bool finished() const { return false; }
};

}  // namespace ikbench::solvers
