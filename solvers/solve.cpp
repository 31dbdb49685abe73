#include "solvers/solve.hpp"

#include <algorithm>
#include <limits>

#include "numerics/instruction_set.hpp"
#include "solvers/kernels.hpp"

namespace ikbench::solvers {

using namespace numerics;

IKBENCH_DEFINE_KERNELS

namespace {

// Adds the error at the start as evaluation 1, or the first candidates' best error if it is larger or the only one.
void add_start(Improvements& improved, const Problem& problem, const Objective& objective, double first_best) {
  const std::int64_t evaluations = objective.evaluations();
  if (evaluations == 0) return;
  Objective uncounted(objective.arm(), objective.goal());
  const double at_start = evaluations == 1 ? first_best : uncounted.error(problem.start);
  improved.add(1, std::max(at_start, first_best));
  if (first_best < at_start) improved.add(evaluations, first_best);
}

}  // namespace

std::optional<StopReason> spent(const StopRule& stop, std::int64_t iterations, std::int64_t evaluations,
                                std::chrono::steady_clock::time_point started) {
  if (iterations >= stop.iterations) return StopReason::iterations;
  if (stop.evaluations > 0 && evaluations >= stop.evaluations) return StopReason::evaluations;
  const std::chrono::duration<double> given(stop.seconds);
  if (stop.seconds > 0 && std::chrono::steady_clock::now() - started >= given) return StopReason::time;
  return std::nullopt;
}

Solution solve(Solver& solver, const Problem& problem, Objective& objective, Random& random, const StopRule& stop,
               Trace trace) {
  const auto started = std::chrono::steady_clock::now();
  Solution solution;
  if (trace == Trace::best_error) solution.trace.reserve(static_cast<std::size_t>(std::min(stop.iterations, 100'000)));
  Tolerance tolerance(stop, objective);
  Problem told = problem;
  told.stop = stop;
  told.iterations = planned_iterations(stop, problem.population);
  Improvements& improved = solution.improved;
  if (trace == Trace::best_error) told.improvements = &improved;
  solver.start(told, objective, random);
  if (trace == Trace::best_error) add_start(improved, problem, objective, solver.best().error);
  const auto end = [&]() -> std::optional<StopReason> {
    if (!std::isfinite(solver.best().error) || solver.best().q.size() != problem.joints())
      return StopReason::not_finite;
    if (tolerance.is_reached(solver.best())) return StopReason::tolerance;
    if (solver.finished()) return solver.gave_up() ? StopReason::gave_up : StopReason::finished;
    return spent(stop, solution.iterations, objective.evaluations(), started);
  };
  std::optional<StopReason> stopped;
  for (; !(stopped = end()); ++solution.iterations) {
    solver.step(objective, random);
    if (trace == Trace::none) continue;
    solution.trace.push_back(solver.best().error);
    const bool is_counted = !improved.to.empty();
    if (is_counted && solver.best().error < improved.to.back())
      improved.add(objective.evaluations(), solver.best().error);
  }
  solution.stopped = *stopped;
  solution.best = solver.best();
  if (solution.best.q.size() != problem.joints())
    solution.best.q = Configuration::Constant(problem.joints(), std::numeric_limits<double>::quiet_NaN());
  if (!solution.best.q.allFinite()) solution.stopped = StopReason::not_finite;
  const bool is_directed = objective.goal().has_direction() && solution.stopped != StopReason::not_finite;
  solution.position_error = is_directed ? objective.deviation(solution.best.q).position : solution.best.error;
  solution.evaluations = objective.evaluations();
  solution.restarts = solver.restarts();
  if (!improved.at.empty() && improved.at.back() < solution.evaluations)
    improved.add(solution.evaluations, solution.best.error);
  return solution;
}

}  // namespace ikbench::solvers
