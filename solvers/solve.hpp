// The loop that drives every solver, and stops, counts, traces and times all of them alike.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "solvers/solver.hpp"

namespace ikbench::solvers {

using numerics::StopReason;

enum class Trace { none, best_error };

struct Solution {
  Best best;
  std::int64_t iterations = 0;
  std::int64_t evaluations = 0;
  int restarts = 0;
  StopReason stopped = StopReason::iterations;
  double position_error = 0;  // [m] of the best answer; equals its error if positions are searched
  std::vector<double> trace;  // best error [m] after each iteration, if asked for
  // Recorded if asked for: from evaluation 1, with the error at the start (or of the first candidates, if larger), to
  // the last evaluation.
  Improvements improved;
};

// The limit of the rule that is reached, but its tolerance; none while there is budget.
std::optional<StopReason> spent(const StopRule& stop, std::int64_t iterations, std::int64_t evaluations,
                                std::chrono::steady_clock::time_point started);

// Stops with `not_finite` if the best error or the answer is not finite.
Solution solve(Solver& solver, const Problem& problem, Objective& objective, numerics::Random& random,
               const StopRule& stop, Trace trace = Trace::none);

}  // namespace ikbench::solvers
