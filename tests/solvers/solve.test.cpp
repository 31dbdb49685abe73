// The loop of all solvers: its ends, its counts and its traces.
#include "tests/solvers/objectives.hpp"

namespace {

Solution solved(const StopRule& stop, Trace trace = Trace::none) {
  const Task task = iiwa_task();
  Objective objective(task.chain, task.target);
  Random random{Key(1)};
  const auto solve_by = trace == Trace::none ? &solve : &solve_traced;
  return solve_by(*solver("ik_bat").make({}), task.problem, objective, random, stop);
}

}  // namespace

TEST_CASE("a solve stops by its iterations, tolerance, evaluations or time, whichever is first", "[solve]") {
  Solution solution = solved({.iterations = 12});
  CHECK(solution.stopped == StopReason::iterations);
  CHECK(solution.iterations == 12);
  CHECK(solution.evaluations == 10 + 12 * 10);              // the first population and one an iteration
  solution = solved({.iterations = 0}, Trace::best_error);  // its start alone
  CHECK(solution.stopped == StopReason::iterations);
  CHECK(solution.evaluations == 10);
  CHECK(solution.trace.empty());
  solution = solved({.iterations = 1000, .tolerance = 0.01}, Trace::best_error);
  CHECK(solution.stopped == StopReason::tolerance);
  CHECK(solution.best.error <= 0.01);
  CHECK(solution.trace.at(solution.trace.size() - 2) > 0.01);
  solution = solved({.iterations = 1000, .evaluations = 55});
  CHECK(solution.stopped == StopReason::evaluations);
  CHECK(solution.evaluations == 60);
  solution = solved({.iterations = 1000000000, .seconds = 0.01});
  CHECK(solution.stopped == StopReason::time);
  CHECK(solution.iterations > 0);
}

TEST_CASE("a solve stops where its solver has finished, unless it is within the tolerance", "[solve]") {
  // It evaluates the start, and again in each step, and finishes after three.
  struct Finishing final : Solver {
    void start(const Problem& problem, Objective& objective, Random&) override {
      best_ = {problem.start, objective.error(problem.start)};
    }
    void step(Objective& objective, Random&) override {
      objective.error(best_.q);
      ++steps_;
    }
    const Best& best() const override { return best_; }
    bool finished() const override { return steps_ == 3; }
    int steps_ = 0;
    Best best_;
  };
  const Task task = iiwa_task();
  const auto solved = [&](const StopRule& stop) {
    Objective objective(task.chain, task.target);
    Random random{Key(1)};
    Finishing solver;
    return solve_traced(solver, task.problem, objective, random, stop);
  };
  const Solution solution = solved({.iterations = 10});
  CHECK(solution.stopped == StopReason::finished);
  CHECK(solution.iterations == 3);
  CHECK(solution.evaluations == 4);
  CHECK(solution.trace.size() == 3);
  CHECK(solution.improved.at == std::vector<std::int64_t>{1, 4});  // it evaluates the start alone first
  CHECK(solution.improved.to == std::vector<double>(2, solution.best.error));
  CHECK(solved({.iterations = 3}).stopped == StopReason::finished);
  CHECK(solved({.iterations = 2}).stopped == StopReason::iterations);
  CHECK(solved({.iterations = 10, .tolerance = 10}).stopped == StopReason::tolerance);
}

TEST_CASE("improvements go from evaluation 1 to the last, and are those of the trace", "[solve]") {
  const Solution solution = solved({.iterations = 40}, Trace::best_error);
  const std::vector<std::int64_t>& at = solution.improved.at;
  const std::vector<double>& to = solution.improved.to;
  REQUIRE(at.size() == to.size());
  REQUIRE(at.size() > 3);
  const Task task = iiwa_task();
  Objective objective(task.chain, task.target);
  CHECK(at[0] == 1);
  CHECK(to[0] == objective.error(task.problem.start));
  CHECK(at[1] == 10);  // the first population
  for (std::size_t i = 2; i < at.size(); ++i) {
    CHECK(at[i] % 10 == 0);
    CHECK(to[i] == solution.trace.at(static_cast<std::size_t>(at[i] / 10 - 2)));
    if (i + 1 < at.size()) CHECK(to[i] < to[i - 1]);
  }
  CHECK(std::is_sorted(at.begin(), at.end()));
  CHECK(at.back() == solution.evaluations);
  CHECK(solved({.iterations = 40}).improved.at.empty());
  // The last improvement is that of the last evaluation, and stands there once.
  const Solution reached = solved({.iterations = 1000, .tolerance = 0.01}, Trace::best_error);
  CHECK(reached.improved.at.back() == reached.evaluations);
  CHECK(std::ranges::adjacent_find(reached.improved.at, std::ranges::greater_equal()) == reached.improved.at.end());
}

TEST_CASE("planned are the iterations that the evaluations allow, if each has a whole population", "[solve]") {
  CHECK(planned_iterations({.iterations = 300}, 50) == 300);
  CHECK(planned_iterations({.iterations = 100'000, .evaluations = 10'000}, 50) == 200);
  CHECK(planned_iterations({.iterations = 100, .evaluations = 10'000}, 50) == 100);
  CHECK(planned_iterations({.iterations = 100, .evaluations = 20}, 50) == 1);
  CHECK(planned_iterations({.iterations = 0, .evaluations = 20}, 50) == 0);
}

TEST_CASE("MO-PSO's mutation ends with the budget, whichever rule ends it", "[solve][mo_pso]") {
  const auto answer = [](const StopRule& stop) {
    const Task task = iiwa_task(50);
    Objective objective(task.chain, task.target);
    return solve_by("multi_objective_swarm", {}, task.problem, objective, stop).best;
  };
  // The first population counts too: it and 39 iterations are 2000 evaluations; 40 are planned.
  const Best least = answer({.iterations = 40, .evaluations = 2000}),
             most = answer({.iterations = 100'000, .evaluations = 2000});
  CHECK(least.q == most.q);
}
