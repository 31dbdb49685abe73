#include "solvers/solve.hpp"

#include <algorithm>
#include <limits>

#include "numerics/instruction_set.hpp"
#include "solvers/kernels.hpp"

namespace ikbench::solvers {

using namespace numerics;

IKBENCH_DEFINE_KERNELS

namespace {

// The parts of one solve. Refers to the caller's objects.
struct Solve {
  Solver& solver;
  const Problem& problem;
  Objective& objective;
  Random& random;
  const StopRule& stop;
  Trace trace;
};

// Adds the error at the start as evaluation 1, or the first candidates' best error if that is larger or the only one.
void add_start(Improvements& improved, const Problem& problem, const Objective& objective, double first_best) {
  const std::int64_t evaluations = objective.evaluations();
  if (evaluations == 0) return;
  Objective uncounted(objective.arm(), objective.goal());
  const double at_start = evaluations == 1 ? first_best : uncounted.error(problem.start);
  improved.add(1, std::max(at_start, first_best));
  if (first_best < at_start) improved.add(evaluations, first_best);
}

// Returns why a solve ends now; nullopt: it goes on.
std::optional<StopReason> stop_reason(const Solve& task, Tolerance& tolerance, std::int64_t iterations,
                                      std::chrono::steady_clock::time_point started) {
  const Solver& solver = task.solver;
  if (!std::isfinite(solver.best().error) || solver.best().q.size() != task.problem.joints())
    return StopReason::not_finite;
  if (tolerance.is_reached(solver.best())) return StopReason::tolerance;
  if (solver.finished()) return solver.gave_up() ? StopReason::gave_up : StopReason::finished;
  return spent(task.stop, iterations, task.objective.evaluations(), started);
}

// Records the best error after an iteration, and an improvement if there was one that the solver did not record.
void record(Solution& solution, double best_error, std::int64_t evaluations) {
  solution.trace.push_back(best_error);
  const bool is_counted = !solution.improved.to.empty();
  if (is_counted && best_error < solution.improved.to.back()) solution.improved.add(evaluations, best_error);
}

// Copies the solver's answer and its counts.
void finish(Solution& solution, const Solve& task) {
  const int joints = task.problem.joints();
  solution.best = task.solver.best();
  if (solution.best.q.size() != joints)
    solution.best.q = Configuration::Constant(joints, std::numeric_limits<double>::quiet_NaN());
  if (!solution.best.q.allFinite()) solution.stopped = StopReason::not_finite;
  const bool is_directed = task.objective.goal().has_direction() && solution.stopped != StopReason::not_finite;
  solution.position_error = is_directed ? task.objective.deviation(solution.best.q).position : solution.best.error;
  solution.evaluations = task.objective.evaluations();
  solution.restarts = task.solver.restarts();
  if (!solution.improved.at.empty() && solution.improved.at.back() < solution.evaluations)
    solution.improved.add(solution.evaluations, solution.best.error);
}

Solution run(const Solve& task) {
  const auto started = std::chrono::steady_clock::now();
  const bool is_traced = task.trace == Trace::best_error;
  Solution solution;
  if (is_traced) solution.trace.reserve(static_cast<std::size_t>(std::min(task.stop.iterations, 100'000)));
  Tolerance tolerance(task.stop, task.objective);
  Problem problem = task.problem;
  problem.stop = task.stop;
  problem.iterations = planned_iterations(task.stop, problem.population);
  if (is_traced) problem.improvements = &solution.improved;
  task.solver.start(problem, task.objective, task.random);
  if (is_traced) add_start(solution.improved, task.problem, task.objective, task.solver.best().error);
  std::optional<StopReason> stopped = stop_reason(task, tolerance, 0, started);
  while (!stopped) {
    task.solver.step(task.objective, task.random);
    if (is_traced) record(solution, task.solver.best().error, task.objective.evaluations());
    ++solution.iterations;
    stopped = stop_reason(task, tolerance, solution.iterations, started);
  }
  solution.stopped = *stopped;
  finish(solution, task);
  return solution;
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

Solution solve(Solver& solver, const Problem& problem, Objective& objective, Random& random, const StopRule& stop) {
  return run({solver, problem, objective, random, stop, Trace::none});
}

Solution solve_traced(Solver& solver, const Problem& problem, Objective& objective, Random& random,
                      const StopRule& stop) {
  return run({solver, problem, objective, random, stop, Trace::best_error});
}

}  // namespace ikbench::solvers
