// K-ABC: employed bees, onlookers and scouts, source by source.
#include <algorithm>
#include <array>
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

struct Rules {
  bool best_neighbour = true;
  int limit = 2;
  double per_unit = 100;  // errors in cm
};

// Three sources against the rules, one at a time, with errors that fall and rise.
void check_colony(const Settings& settings, const Rules& rules, int population = 3) {
  const Task task = planar_task(population);
  std::vector<double> script;
  for (int i = 0; i < 400; ++i) script.push_back(0.02 + 0.01 * ((i * 7) % 13) - 0.00001 * i);
  RecordingObjective objective(task.chain, script);
  Random random{Key(8)}, replay{Key(8)};
  const auto bees = solver("k_artificial_bee_colony").make(settings);
  bees->start(task.problem, objective, random);

  Candidates x = drawn_uniforms(replay, 2, 3);
  x = (2 * x.array() - 1).matrix();
  std::vector<double> errors(script.begin(), script.begin() + 3);
  std::vector<int> failures(3, 0);
  double best_ever = *std::min_element(errors.begin(), errors.end());
  std::size_t turn = 3;
  int scouts = 0;
  std::array<int, 3> visits{};
  const auto best_source = [&] {
    return static_cast<int>(std::min_element(errors.begin(), errors.end()) - errors.begin());
  };
  const auto search = [&](int i, double joint, double phi, double neighbour) {
    const int j = joint < 0.5 ? 0 : 1;
    int k = best_source();
    if (!rules.best_neighbour) {
      const int others[3][2]{{1, 2}, {0, 2}, {0, 1}};
      k = others[i][neighbour < 0.5 ? 0 : 1];
    }
    Eigen::Vector2d candidate = x.col(i);
    candidate[j] += (2 * phi - 1) * (k == i ? x(j, i) : x(j, i) - x(j, k));
    candidate = candidate.cwiseMax(-1).cwiseMin(1);
    REQUIRE(same(objective.candidates[turn], candidate));
    const auto at = static_cast<std::size_t>(i);
    if (script[turn] < errors[at]) {
      x.col(i) = candidate;
      errors[at] = script[turn];
      failures[at] = 0;
    } else {
      ++failures[at];
    }
    best_ever = std::min(best_ever, script[turn]);
    ++turn;
  };
  for (int iteration = 0; iteration < 20; ++iteration) {
    bees->step(objective, random);
    for (const bool onlookers : {false, true}) {
      const Eigen::VectorXd joint = drawn_vector(replay, 3), phi = drawn_vector(replay, 3);
      const Eigen::VectorXd neighbour = rules.best_neighbour ? Eigen::VectorXd::Zero(3) : drawn_vector(replay, 3);
      const Eigen::VectorXd roulette = onlookers ? drawn_vector(replay, 3) : Eigen::VectorXd::Zero(3);
      const auto fitness = [&](std::size_t i) { return 1 / (1 + rules.per_unit * errors[i]); };
      const double f0 = fitness(0), f1 = fitness(1), f2 = fitness(2);
      for (int bee = 0; bee < 3; ++bee) {
        int i = bee;
        if (onlookers) {
          const double at = roulette[bee] * (f0 + f1 + f2);
          i = at < f0 ? 0 : at < f0 + f1 ? 1 : 2;
          ++visits[static_cast<std::size_t>(i)];
        }
        search(i, joint[bee], phi[bee], neighbour[bee]);
      }
    }
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (failures[at] <= rules.limit) continue;
      for (int j = 0; j < 2; ++j) x(j, i) = -1 + 2 * replay.uniform();
      REQUIRE(same(objective.candidates[turn], x.col(i)));
      errors[at] = script[turn];
      best_ever = std::min(best_ever, script[turn]);
      failures[at] = 0;
      ++turn;
      ++scouts;
    }
    REQUIRE(turn == objective.candidates.size());
    REQUIRE(bees->best().error == best_ever);
  }
  CHECK(scouts > 0);
  for (const int count : visits) CHECK(count > 0);
}

}  // namespace

TEST_CASE("K-ABC's bees move one joint along the difference to the best source, and give up after L", "[k_abc]") {
  check_colony({}, {});  // L = (3 + 2) / 2 = 2
}

TEST_CASE("K-ABC's limit can be set", "[k_abc]") { check_colony({{"limit", "5"}}, {.limit = 5}); }

TEST_CASE("a random neighbour makes K-ABC the plain bee colony", "[k_abc]") {
  check_colony({{"neighbour", "random"}}, {.best_neighbour = false});
}

TEST_CASE("K-ABC's roulette depends on the unit of the error", "[k_abc]") {
  check_colony({{"fitness_unit", "m"}}, {.per_unit = 1});
}

TEST_CASE("half a colony has half the sources and onlookers, and the limit of the whole", "[k_abc]") {
  check_colony({{"colony", "half"}}, {.limit = (6 + 2) / 2}, 6);
}

TEST_CASE("K-ABC spends 2 N evaluations an iteration, half a colony N", "[k_abc][paper]") {
  for (const std::string colony : {"full", "half"}) {
    const Task task = planar_task(50);
    RecordingObjective objective(task.chain, task.target);
    Random random{Key(8)};
    const auto bees = solver("k_artificial_bee_colony").make({{"colony", colony}, {"limit", "1000"}});
    bees->start(task.problem, objective, random);
    bees->step(objective, random);
    CHECK(objective.evaluations() == (colony == "full" ? 50 + 100 : 25 + 50));
  }
}
