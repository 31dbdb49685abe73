// The contract of solvers of libraries, besides the contract of all solvers.
#include <ctime>

#include "tests/solvers/objectives.hpp"

namespace {

constexpr StopRule until_solved{.iterations = 500, .tolerance = 1e-4, .angle_tolerance = 1e-3};

bool is_missing(std::string_view name) {
  const std::vector<MissingPeer> missing = missing_peers();
  return std::ranges::find(missing, name, &MissingPeer::name) != missing.end();
}

struct PeerTask {
  Robot arm;
  Goal goal;
  Problem problem;
};

// A pose near the middle of the limits, from where every descent finds it.
PeerTask near_pose(const std::string& name, int population = 50) {
  const Robot arm = robot(name);
  const JointLimits range = arm.limits.around(Eigen::VectorXd::Zero(arm.joints()));
  const Configuration start = 0.45 * range.lower + 0.55 * range.upper;
  Configuration q = start;
  for (Eigen::Index j = 0; j < q.size(); ++j) q[j] += 0.01 * (j % 2 == 0 ? 1 : -1);
  return {arm,
          {arm.chain.forward(q), 0.25},
          {.start = start, .lower = range.lower, .upper = range.upper, .population = population, .iterations = 500}};
}

Solution solved(const PeerTask& task, const std::string& name, const Settings& settings, StopRule stop,
                Trace trace = Trace::none) {
  Objective objective(task.arm.chain, task.goal);
  Random random{Key(1)};
  const auto solve_by = trace == Trace::none ? &solve : &solve_traced;
  return solve_by(*solver(name).make(settings), task.problem, objective, random, stop);
}

}  // namespace

TEST_CASE("the start of both searches takes no more than the budget", "[peers]") {
  if (is_missing("newton_slsqp")) return;
  for (const std::int64_t most : {1, 2, 3})
    CHECK(solved(near_pose("ur5e"), "newton_slsqp", {}, {.iterations = 500, .evaluations = most}).evaluations == most);
}

TEST_CASE("a peer says with which version of its library it was built", "[peers]") {
  for (const SolverInfo& info : all_solvers()) {
    if (info.library.empty()) continue;
    CAPTURE(info.name, info.library);
    CHECK(info.library.find_first_of("0123456789") != std::string::npos);
  }
}

TEST_CASE("a peer solves a pose that is near, of arms that turn and that slide, in one step", "[peers]") {
  for (const char* arm : {"franka_panda", "ur5e", "stanford"}) {
    for (const auto& [name, settings] :
         {std::pair<std::string, Settings>{"kdl_newton", {}}, {"nlopt", {}}, {"nlopt", {{"algorithm", "lbfgs"}}}}) {
      if (is_missing(name)) continue;
      CAPTURE(arm, name);
      const Solution solution = solved(near_pose(arm), name, settings, until_solved);
      CHECK(solution.stopped == StopReason::tolerance);
      CHECK(solution.iterations == 1);
    }
  }
}

TEST_CASE("a peer that misses its target ends by itself", "[peers]") {
  for (const SolverInfo& info : all_solvers()) {
    if (info.library.empty()) continue;
    CAPTURE(info.name);
    PeerTask task = near_pose("ur5e");
    task.goal.target.translation() *= 5;                    // out of reach
    task.problem.lower = task.problem.start.array() - 0.1;  // where Newton's method is stuck soon
    task.problem.upper = task.problem.start.array() + 0.1;
    const Solution solution = solved(task, info.name, {}, until_solved);
    CHECK(solution.stopped == StopReason::finished);
    CHECK((solution.iterations == 1 || info.name == "newton_slsqp"));  // which calls its library until it converges
    CHECK((solution.restarts >= solution.iterations) == (info.name == "newton_slsqp"));  // its Newton begins anew, too
  }
}

TEST_CASE("a library that evaluates our objective keeps the study's number of evaluations", "[peers]") {
  for (const SolverInfo& info : all_solvers()) {
    if (info.library.empty() || !info.is_counted) continue;
    info.describe([&](const OptionList& list) {
      std::vector<Settings> all(list.options().empty() ? 1 : 0);
      for (const Option& option : list.options()) {
        if (!all.empty()) break;  // the choices of the first
        if (std::holds_alternative<std::string>(option.get()))
          for (const Setting& choice : option.extremes) all.push_back({{option.name, choice}});
      }
      for (const Settings& settings : all) {
        CAPTURE(info.name);
        PeerTask task = near_pose("ur5e", 10);
        task.goal.target.translation() *= 5;
        for (const std::int64_t most : {200, 201}) {
          const Solution solution = solved(task, info.name, settings, {.iterations = 500, .evaluations = most});
          CHECK(solution.evaluations <= most);
        }
      }
    });
  }
}

TEST_CASE("a library that knows no clock keeps the study's seconds and evaluations", "[peers]") {
  if (is_missing("kdl_newton")) return;
  PeerTask task = near_pose("ur5e");
  task.goal.target.translation() *= 5;  // out of reach: Newton's method would take seconds
  for (const StopRule stop :
       {StopRule{.iterations = 1'000'000, .seconds = 0.005}, StopRule{.iterations = 1'000'000, .evaluations = 1000}}) {
    const std::clock_t began = std::clock();
    solved(task, "kdl_newton", {}, stop);
    CHECK(std::clock() - began < CLOCKS_PER_SEC / 10);
  }
}

TEST_CASE("where a library's best became smaller within its call is told", "[peers]") {
  for (const SolverInfo& info : all_solvers()) {
    if (info.library.empty() || !info.is_counted) continue;
    CAPTURE(info.name);
    const PeerTask task = near_pose("ur5e");
    const StopRule stop{.iterations = 500};
    const Solution solution = solved(task, info.name, {}, stop, Trace::best_error);
    const std::vector<std::int64_t>& at = solution.improved.at;
    const std::vector<double>& to = solution.improved.to;
    REQUIRE(at.size() > 3);
    REQUIRE(to.size() == at.size());
    CHECK(at.front() == 1);
    CHECK(at.back() == solution.evaluations);
    CHECK(to.back() == solution.best.error);
    CHECK(std::ranges::adjacent_find(at, std::greater_equal()) == at.end());
    CHECK(std::ranges::adjacent_find(to.begin(), to.end() - 1, std::less_equal()) == to.end() - 1);
    CHECK(solved(task, info.name, {}, stop).best.q == solution.best.q);
  }
}

TEST_CASE("NLopt with restarts goes on until it has found a pose", "[peers]") {
  if (is_missing("nlopt")) return;
  PeerTask task = near_pose("ur5e");
  task.problem.start = task.problem.lower;
  const Solution solution = solved(task, "nlopt", {{"restarts", "random"}}, until_solved);
  CHECK(solution.stopped == StopReason::tolerance);
  CHECK(solution.iterations > 1);
}

TEST_CASE("KDL's Newton refuses coupled joints", "[peers]") {
  if (is_missing("kdl_newton")) return;
  const Chain iiwa = robot("kuka_iiwa14").chain, dobot = robot("dobot_magician").chain;
  CHECK(solver("kdl_newton").why_not(iiwa, GoalKind::pose).empty());
  CHECK(solver("kdl_newton").why_not(dobot, GoalKind::pose).find("coupled") != std::string::npos);
}
