// The one loop that drives every solver: stopped, counted, traced and timed alike.
#pragma once

#include <cstdint>
#include <vector>

#include "solvers/solver.hpp"

namespace ikbench::solvers {

// finished: by the solver itself.
enum class Stopped { iterations, tolerance, evaluations, time, not_finite, finished };

enum class Trace { none, best_error };

struct Solution {
  Best best;
  std::int64_t iterations = 0;
  std::int64_t evaluations = 0;
  Stopped stopped = Stopped::iterations;
  double position_error = 0;  // [m] of the best; where a position is searched, its error
  std::vector<double> trace;  // best error [m] after each iteration, where asked for
  // Likewise. From evaluation 1, with the error at the start or, where it is larger, that of the first candidates, to
  // the last evaluation.
  Improvements improved;
};

// `not_finite` where the best error or the answer is not a finite number.
Solution solve(Solver& solver, const Problem& problem, Objective& objective, numerics::Random& random,
               const StopRule& stop, Trace trace = Trace::none);

}  // namespace ikbench::solvers
