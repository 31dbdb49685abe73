// IK-BA and BA: two bats, two joints, equation by equation.
#include <cmath>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/solvers/objectives.hpp"

using namespace ikbench;
using namespace ikbench::numerics;
using namespace ikbench::robots;
using namespace ikbench::solvers;

namespace {

// The draws of an iteration of IK-BA, in its order.
struct IkBatDraws {
  explicit IkBatDraws(Random& random, int bats = 2)
      : beta(drawn_vector(random, bats)), epsilon(drawn_normals(random, 2, bats)), chance(drawn_vector(random, bats)) {}
  Eigen::VectorXd beta;
  Candidates epsilon;
  Eigen::VectorXd chance;
};

Solution solved(const std::string& name, const Settings& settings) {
  const Task task = iiwa_task();
  Objective objective(task.chain, task.target);
  Random random{Key(3)};
  return solve(*solver(name).make(settings), task.problem, objective, random, {.iterations = 60}, Trace::best_error);
}

}  // namespace

TEST_CASE("IK-BA's first bat starts where the arm is, the others within the limits", "[ik_bat]") {
  const Task task = planar_task(2);
  RecordingObjective objective(task.chain, std::vector<double>{2, 1});
  Random random{Key(1)}, replay{Key(1)};
  const auto bats = solver("ik_bat").make({});
  bats->start(task.problem, objective, random);
  const Candidates u = drawn_uniforms(replay, 2, 2);
  REQUIRE(objective.candidates.size() == 2);
  CHECK(same(objective.candidates[0], task.problem.start));
  CHECK(same(objective.candidates[1], -Eigen::Vector2d::Ones() + 2 * u.col(1)));
  CHECK(bats->best().error == 1);
  CHECK(same(bats->best().q, objective.candidates[1]));
}

TEST_CASE("IK-BA draws between the best and the start with a shrinking step, Eqs. 9, 10 and 14", "[ik_bat][paper]") {
  const Task task = planar_task(2);
  const Eigen::VectorXd theta_s = task.problem.start;
  RecordingObjective objective(task.chain, std::vector<double>{1, 2, 0.5, 0.7, 0.6, 0.4});
  Random random{Key(1)}, replay{Key(1)};
  const auto bats = solver("ik_bat").make({});
  bats->start(task.problem, objective, random);
  drawn_uniforms(replay, 2, 2);

  bats->step(objective, random);
  const IkBatDraws first(replay);
  const auto& seen = objective.candidates;  // A = 0.97 and r = 0 in the first iteration: around the start alone
  CHECK(same(seen[2], theta_s + 0.1 * 0.97 * first.epsilon.col(0)));
  CHECK(same(seen[3], theta_s + 0.1 * 0.97 * first.epsilon.col(1)));
  CHECK(same(bats->best().q, seen[2]));

  bats->step(objective, random);
  const IkBatDraws second(replay);
  const double r = 1 - std::exp(-0.1), A = 0.97 * 0.97;
  CHECK(same(seen[4], r * seen[2] + (1 - r) * theta_s + 0.1 * A * second.epsilon.col(0)));
  CHECK(same(seen[5], r * seen[2] + (1 - r) * theta_s + 0.1 * A * second.epsilon.col(1)));
  CHECK(same(bats->best().q, seen[5]));
}

TEST_CASE("IK-BA's second bat already draws around what the first has found", "[ik_bat]") {
  const Task task = planar_task(2);
  RecordingObjective objective(task.chain, std::vector<double>{1, 2, 0.9, 0.8, 0.5});
  Random random{Key(1)}, replay{Key(1)};
  const auto bats = solver("ik_bat").make({{"step_factor", "0"}, {"gamma", "10"}});
  bats->start(task.problem, objective, random);
  for (int iteration = 0; iteration < 2; ++iteration) bats->step(objective, random);
  const double r = 1 - std::exp(-10.0);
  const auto& seen = objective.candidates;
  CHECK(same(seen[5], r * seen[4] + (1 - r) * task.problem.start));  // seen[4] was the improvement just before
}

TEST_CASE("IK-BA gives the same bits for f_max = 0 and 2: Eq. 14 overwrites Eq. 7", "[ik_bat][paper]") {
  const Solution none = solved("ik_bat", {{"f_max", "0"}}), two = solved("ik_bat", {{"f_max", "2"}});
  CHECK(none.best.q == two.best.q);
  CHECK(none.trace == two.trace);
}

TEST_CASE("IK-BA's acceptance keeps a better candidate always, if rand < A, or if rand > A", "[ik_bat][paper]") {
  for (const std::string rule : {"greedy", "loudness", "yang2020"}) {
    CAPTURE(rule);
    const Task task = planar_task(2);
    std::vector<double> falling;
    for (int i = 0; i < 42; ++i) falling.push_back(100 - i);
    RecordingObjective objective(task.chain, falling);
    Random random{Key(1)}, replay{Key(1)};
    const auto bats = solver("ik_bat").make({{"acceptance", rule}, {"loudness", "0.5"}, {"alpha", "1"}});
    bats->start(task.problem, objective, random);
    drawn_uniforms(replay, 2, 2);
    double expected = 99;
    for (int iteration = 0; iteration < 20; ++iteration) {
      bats->step(objective, random);
      const IkBatDraws draws(replay);
      for (int i = 0; i < 2; ++i) {
        const bool quiet = draws.chance[i] < 0.5;
        if (rule == "greedy" || (rule == "loudness" ? quiet : !quiet)) expected = 100 - (2 + 2 * iteration + i);
      }
      REQUIRE(bats->best().error == expected);
    }
  }
}

TEST_CASE("IK-BA's bats leave the limits unless they are clamped", "[ik_bat]") {
  Task task = planar_task(10);
  task.problem.start = Eigen::Vector2d(1, -1);
  const JointLimits limits{task.problem.lower, task.problem.upper};
  for (const std::string bounds : {"initial", "clamp"}) {
    RecordingObjective objective(task.chain, task.target);
    Random random{Key(1)};
    solve(*solver("ik_bat").make({{"bounds", bounds}}), task.problem, objective, random, {.iterations = 5});
    double worst = 0;
    for (std::size_t i = 0; i < objective.candidates.size(); ++i) {
      const double violation = limits.violation(objective.candidates[i]);
      if (i < 10) CHECK(violation == 0);
      worst = std::max(worst, violation);
    }
    CHECK((worst > 0) == (bounds == "initial"));
  }
}

TEST_CASE("BA moves, searches locally, accepts and grows quiet by Eqs. 5 to 10", "[bat][paper]") {
  const Task task = planar_task(2);
  const double alpha = 0.5, gamma = 0.5, r0 = 0.8;
  // Errors in the order of evaluation: some candidates improve, some tie and some fail.
  const std::vector<double> script{3, 2, 2.5, 2, 1.5, 2.5, 1.5, 1.2, 1.1, 1.3, 1, 0.9, 0.8, 0.9, 0.7, 0.6};
  int moves = 0, searches = 0, ties = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RecordingObjective objective(task.chain, script);
    Random random{Key(seed)}, replay{Key(seed)};
    const auto bats = solver("bat").make({{"pulse_rate", "0.8"}});
    bats->start(task.problem, objective, random);

    Candidates x = drawn_uniforms(replay, 2, 2), v = Candidates::Zero(2, 2);
    x = (2 * x.array() - 1).matrix();
    Eigen::Vector2d A = drawn_vector(replay, 2), r(r0, r0), errors(3, 2);  // Table 1: A_i random in [0, 1]
    Eigen::Vector2d best = x.col(1);
    double best_error = 2;
    for (int t = 1; t <= 7; ++t) {
      bats->step(objective, random);
      const Eigen::VectorXd beta = drawn_vector(replay, 2), local = drawn_vector(replay, 2);
      const Candidates epsilon = drawn_normals(replay, 2, 2);
      const Eigen::VectorXd chance = drawn_vector(replay, 2);
      for (int i = 0; i < 2; ++i) {
        const std::size_t turn = static_cast<std::size_t>(2 * t + i);
        const double f = 2 * beta[i];                     // Eq. 5 with f in [0, 2]
        v.col(i) += (x.col(i) - best) * f;                // Eq. 6
        Eigen::Vector2d candidate = x.col(i) + v.col(i);  // Eq. 7
        if (local[i] > r[i]) {
          candidate = best + 0.1 * A.mean() * epsilon.col(i);  // Eq. 8
          ++searches;
        } else {
          ++moves;
        }
        candidate = candidate.cwiseMax(-1).cwiseMin(1);
        REQUIRE(same(objective.candidates[turn], candidate));
        if (script[turn] <= errors[i] && chance[i] < A[i]) {
          ties += script[turn] == errors[i] ? 1 : 0;
          x.col(i) = candidate;
          errors[i] = script[turn];
          A[i] *= alpha;                           // Eq. 9
          r[i] = r0 * (1 - std::exp(-gamma * t));  // Eq. 10
          if (script[turn] < best_error) {
            best = candidate;
            best_error = script[turn];
          }
        }
      }
      REQUIRE(bats->best().error == best_error);
      REQUIRE(same(bats->best().q, best));
    }
  }
  CHECK(moves > 0);
  CHECK(searches > 0);
  CHECK(ties > 0);  // accepted as well
}

TEST_CASE("BA with best_of = evaluated keeps a best that no bat accepted", "[bat]") {
  std::vector<double> falling;
  for (int i = 0; i < 42; ++i) falling.push_back(100 - i);
  for (const std::string best_of : {"accepted", "evaluated"}) {
    const Task task = planar_task(2);
    RecordingObjective objective(task.chain, falling);
    Random random{Key(1)};
    const auto bats = solver("bat").make({{"best_of", best_of}, {"alpha", "0"}});  // a bat accepts once, then is silent
    bats->start(task.problem, objective, random);
    std::vector<double> bests{bats->best().error};
    for (int iteration = 0; iteration < 20; ++iteration) {
      bats->step(objective, random);
      if (bats->best().error < bests.back()) bests.push_back(bats->best().error);
    }
    CHECK(bests.size() <= (best_of == "accepted" ? 3 : 21));
    CHECK((bests.back() == falling.back()) == (best_of == "evaluated"));
  }
}
