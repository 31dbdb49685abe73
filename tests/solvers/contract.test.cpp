// The contract of every registered solver, for each value of its options.
#include "tests/solvers/objectives.hpp"

namespace ikbench::solvers {
SolverInfo hill_climb();
}

namespace {

// Includes the peers that were built, and docs/examples/hill_climb.cpp.
std::vector<SolverInfo> solvers_of_positions() {
  std::vector<SolverInfo> solvers = solvers_for(iiwa_task().chain, GoalKind::position);
  solvers.push_back(hill_climb());
  return solvers;
}

// Leaves out peers: their libraries allocate as they like, and some draw nothing.
std::vector<SolverInfo> own_solvers_of_positions() {
  std::vector<SolverInfo> own = solvers_of_positions();
  std::erase_if(own, [](const SolverInfo& info) { return !info.library.empty(); });
  return own;
}

// The defaults; each choice; each number alone at both of its ends; all numbers at their low and their high ends.
std::vector<Settings> corners(const SolverInfo& info) {
  std::vector<Settings> corners{{}};
  Settings low, high;
  info.describe([&](const OptionList& list) {
    for (const Option& option : list.options()) {
      for (const Setting& value : option.extremes) corners.push_back({{option.name, value}});
      if (!std::holds_alternative<double>(option.get())) continue;
      low[option.name] = option.extremes.front();
      high[option.name] = option.extremes.back();
    }
  });
  corners.push_back(low);
  corners.push_back(high);
  return corners;
}

std::string text(const Settings& settings) {
  std::string text;
  for (const auto& [name, value] : settings) text += name + " = " + text_of(value) + "; ";
  return text;
}

void at_corners(const std::vector<SolverInfo>& solvers,
                const std::function<void(const SolverInfo&, const Settings&)>& check) {
  for (const SolverInfo& info : solvers) {
    for (const Settings& settings : corners(info)) {
      CAPTURE(info.name, text(settings));
      check(info, settings);
    }
  }
}

bool has_choice(const SolverInfo& info, std::string_view name, std::string_view choice) {
  bool found = false;
  info.describe([&](const OptionList& list) {
    for (const Option& option : list.options()) {
      if (option.name != name) continue;
      for (const Setting& each : option.extremes) found = found || text_of(each) == choice;
    }
  });
  return found;
}

Solution solved(Solver& solver, const Task& task, Objective& objective, std::uint64_t seed = 1) {
  Random random{Key(seed)};
  return solve_traced(solver, task.problem, objective, random, {.iterations = 30});
}

// Checks that best() never worsens and that its error is exactly the objective's.
void check_best(Solver& solver, const Task& task, Objective& objective) {
  Random random{Key(7)};
  Objective judge(task.chain, task.target);
  solver.start(task.problem, objective, random);
  double before = infinity;
  for (int iteration = 0; iteration < 30; ++iteration) {
    const Best& best = solver.best();
    REQUIRE(best.q.size() == task.problem.joints());
    REQUIRE_FALSE(std::isnan(best.error));
    REQUIRE(best.error <= before);
    if (std::isfinite(best.error)) REQUIRE(std::abs(best.error - judge.error(best.q)) < 1e-14);
    before = best.error;
    solver.step(objective, random);
  }
}

}  // namespace

TEST_CASE("every solver says what it is and where it comes from", "[contract]") {
  for (const SolverInfo& info : all_solvers()) {
    CAPTURE(info.name);
    CHECK(solver(info.name).name == info.name);
    CHECK_FALSE(info.summary.empty());
    CHECK_FALSE(info.source.empty());
    info.describe([](const OptionList& list) {
      for (const Option& option : list.options()) {
        CAPTURE(option.name);
        CHECK_FALSE(option.meaning.empty());
        CHECK_FALSE(option.expected.empty());
      }
    });
  }
}

TEST_CASE("best never worsens and is as good as it says, in every corner of the options, though some errors be odd",
          "[contract]") {
  at_corners(solvers_of_positions(), [](const SolverInfo& info, const Settings& settings) {
    const Task task = iiwa_task();
    Objective all_good(task.chain, task.target);
    check_best(*info.make(settings), task, all_good);
    for (const double value : {not_a_number, infinity}) {
      CAPTURE(value);
      SpoiltObjective objective(task.chain, task.target, value, 3);
      check_best(*info.make(settings), task, objective);
    }
  });
}

TEST_CASE("a solve in which no error is a number ends as not finite", "[contract]") {
  at_corners(solvers_of_positions(), [](const SolverInfo& info, const Settings& settings) {
    const Task task = iiwa_task();
    SpoiltObjective objective(task.chain, task.target, not_a_number, 1);
    const auto solver = info.make(settings);
    CHECK(solved(*solver, task, objective).stopped == StopReason::not_finite);
    check_best(*solver, task, objective);  // and nothing breaks if somebody continues
  });
}

TEST_CASE("the same key gives the same answer, also from a solver used before", "[contract]") {
  at_corners(solvers_of_positions(), [](const SolverInfo& info, const Settings& settings) {
    const Task task = iiwa_task(), other = snake_task(3, std::max(6, info.min_population));
    const auto solver = info.make(settings), used = info.make(settings);
    Objective first(task.chain, task.target), between(other.chain, other.target), second(task.chain, task.target);
    const Solution a = solved(*solver, task, first);
    solved(*used, other, between);
    const Solution b = solved(*used, task, second);
    CHECK(a.best.q == b.best.q);
    CHECK(a.trace == b.trace);
    CHECK(a.evaluations == b.evaluations);
  });
}

TEST_CASE("looking ahead changes no bit, in every corner of the options", "[contract]") {
  at_corners(solvers_of_positions(), [](const SolverInfo& info, const Settings& settings) {
    for (const int population : {10, 37}) {
      CAPTURE(population);
      const Task task = iiwa_task(population);
      Objective ahead(task.chain, task.target);
      OneAheadObjective one(task.chain, task.target);
      const auto solver = info.make(settings);
      const Solution a = solved(*solver, task, ahead), b = solved(*solver, task, one);
      CHECK(a.best.q == b.best.q);
      CHECK(a.trace == b.trace);
      CHECK(a.evaluations == b.evaluations);
    }
  });
}

TEST_CASE("different keys give different draws", "[contract]") {
  for (const SolverInfo& info : own_solvers_of_positions()) {
    CAPTURE(info.name);
    Task task = iiwa_task();
    task.target = {0, 0, 5};  // beyond the stretched arm: solvers that draw only when they are stuck are stuck
    RecordingObjective first(task.chain, task.target), second(task.chain, task.target);
    const auto solver = info.make({});
    Random one{Key(1)}, other{Key(2)};
    solve(*solver, task.problem, first, one, {.iterations = 100});
    solve(*solver, task.problem, second, other, {.iterations = 100});
    CHECK(first.candidates != second.candidates);
  }
}

TEST_CASE("every candidate goes through the objective, which counts it", "[contract]") {
  at_corners(solvers_of_positions(), [](const SolverInfo& info, const Settings& settings) {
    if (!info.is_counted) return;
    const Task task = iiwa_task();
    RecordingObjective objective(task.chain, task.target);
    const Solution solution = solved(*info.make(settings), task, objective);
    CHECK(solution.evaluations == objective.evaluations());
    CHECK(static_cast<std::size_t>(solution.evaluations) == objective.candidates.size());
    double smallest = infinity;
    for (const double error : objective.given) smallest = std::min(smallest, error);
    CHECK(smallest <= solution.best.error);
  });
}

TEST_CASE("with bounds = clamp or resample, or without a choice, no candidate is outside the limits", "[contract]") {
  const std::string bounds = GENERATE("clamp", "resample");
  at_corners(solvers_of_positions(), [&](const SolverInfo& info, Settings settings) {
    if (info.options({}).contains("bounds")) {
      if (!has_choice(info, "bounds", bounds)) return;
      settings["bounds"] = bounds;
    }
    Task task = iiwa_task();
    const JointLimits limits{task.problem.lower / 4, task.problem.upper / 4};
    task.problem.lower = limits.lower;
    task.problem.upper = limits.upper;
    RecordingObjective objective(task.chain, task.target);
    solved(*info.make(settings), task, objective);
    for (const auto& q : objective.candidates) REQUIRE(limits.violation(q) == 0);
  });
}

TEST_CASE("a small population works or is refused in a sentence", "[contract]") {
  at_corners(solvers_of_positions(), [](const SolverInfo& info, const Settings& settings) {
    for (int population = 1; population <= 7; ++population) {
      CAPTURE(population);
      const Task task = iiwa_task(population);
      Objective objective(task.chain, task.target);
      try {
        const Solution solution = solved(*info.make(settings), task, objective);
        CHECK(std::isfinite(solution.best.error));
      } catch (const std::invalid_argument& refused) {
        CHECK(std::string(refused.what()).find(info.name) == 0);
        CHECK(std::string(refused.what()).find(std::to_string(population)) != std::string::npos);
      }
    }
  });
}

TEST_CASE("a population of 100000 is started and takes a step", "[contract][large]") {
  for (const SolverInfo& info : own_solvers_of_positions()) {
    CAPTURE(info.name);
    const Task task = iiwa_task(100'000);
    Objective objective(task.chain, task.target);
    Random random{Key(1)};
    const Solution solution = solve(*info.make({}), task.problem, objective, random, {.iterations = 1});
    CHECK(solution.iterations == 1);
    CHECK(std::isfinite(solution.best.error));
  }
}

TEST_CASE("a solve may start at the limits, or where a joint is locked", "[contract]") {
  for (const SolverInfo& info : solvers_of_positions()) {
    CAPTURE(info.name);
    Task task = iiwa_task();
    task.problem.start = task.problem.upper;
    Objective objective(task.chain, task.target);
    check_best(*info.make({}), task, objective);
    task.problem.lower[2] = task.problem.upper[2] = task.problem.start[2] = 0.3;
    check_best(*info.make({}), task, objective);
  }
}

TEST_CASE("a second solve of the same size takes no memory from the heap", "[contract]") {
  at_corners(own_solvers_of_positions(), [](const SolverInfo& info, const Settings& settings) {
    for (const int joints : {1, 4, max_joints}) {
      CAPTURE(joints);
      Task task = snake_task(joints, 50);
      task.target *= 10;  // out of reach: restarts and scouts take part
      const auto solver = info.make(settings);
      const auto solved_again = [&] {
        Objective objective(task.chain, task.target);
        Random random{Key(1)};
        const long before = allocations();
        solver->start(task.problem, objective, random);
        const long started = allocations() - before;
        const Solution solution = solve(*solver, task.problem, objective, random, {.iterations = 12});
        return std::array<long, 2>{started, allocations() - before - started};
      };
      const auto [first_start, first_solve] = solved_again();
      CHECK(first_start > 0);  // or the count sees nothing
      CHECK(first_solve == 0);
      task.problem.start *= 0.5;
      task.target *= -1;
      const auto [start, solve] = solved_again();
      CHECK(start == 0);
      CHECK(solve == 0);
    }
  });
}

TEST_CASE("every solver but the floor beats random search on the iiwa", "[contract]") {
  const Task task = iiwa_task(50);
  const auto mean_error = [&](const SolverInfo& info) {
    double sum = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      Objective objective(task.chain, task.target);
      Random random{Key(seed)};
      sum += solve(*info.make({}), task.problem, objective, random, {.iterations = 200}).best.error;
    }
    return sum / 10;
  };
  const double floor = mean_error(solver("random_search"));
  for (const SolverInfo& info : solvers_of_positions()) {
    CAPTURE(info.name);
    if (info.name != "random_search") CHECK(mean_error(info) < floor);
  }
}
