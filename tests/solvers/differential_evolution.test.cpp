// DE, rand/1/bin: four candidates, two joints.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>
#include <stdexcept>
#include <vector>

#include "tests/catch.hpp"
#include "tests/solvers/objectives.hpp"

using namespace ikbench;
using namespace ikbench::numerics;
using namespace ikbench::solvers;

namespace {

struct Started {
  Task task = planar_task(4);
  RecordingObjective objective;
  Random random{Key(1)};
  std::unique_ptr<Solver> solver;
  std::vector<Eigen::VectorXd> x;  // the population

  Started(const Settings& settings, std::vector<double> script)
      : objective(task.chain, std::move(script)), solver(solvers::solver("differential_evolution").make(settings)) {
    solver->start(task.problem, objective, random);
    x = objective.candidates;
  }
  const Eigen::VectorXd& seen(int turn) const { return objective.candidates.at(static_cast<std::size_t>(turn)); }
};

// The indices a, b, c, in order, for which x_a + F (x_b - x_c) is the candidate; empty if there are none.
std::vector<std::size_t> mutant_of(const Eigen::VectorXd& candidate, const std::vector<Eigen::VectorXd>& x,
                                   std::size_t i, double F) {
  std::vector<std::size_t> others;
  for (std::size_t k = 0; k < 4; ++k) {
    if (k != i) others.push_back(k);
  }
  do {
    if (same(candidate, x[others[0]] + F * (x[others[1]] - x[others[2]]))) return others;
  } while (std::next_permutation(others.begin(), others.end()));
  return {};
}

}  // namespace

TEST_CASE("DE's mutants are made of the three others, in every order", "[differential_evolution]") {
  Started de({{"crossover", "1"}, {"bounds", "initial"}}, {1, 1, 1, 1});  // nothing later improves on it
  std::set<std::vector<std::size_t>> orders;
  for (int iteration = 0; iteration < 40; ++iteration) {
    de.solver->step(de.objective, de.random);
    for (int i = 0; i < 4; ++i) {
      const auto order = mutant_of(de.seen(4 + 4 * iteration + i), de.x, static_cast<std::size_t>(i), 0.6);
      REQUIRE_FALSE(order.empty());
      orders.insert(order);
    }
  }
  CHECK(orders.size() == 24);  // six for each of the four
}

TEST_CASE("DE takes exactly one joint from the mutant where C is 0", "[differential_evolution]") {
  Started de({{"crossover", "0"}, {"bounds", "initial"}}, {1, 1, 1, 1});
  std::array<int, 2> changed{};
  for (int iteration = 0; iteration < 20; ++iteration) {
    de.solver->step(de.objective, de.random);
    for (int i = 0; i < 4; ++i) {
      const Eigen::VectorXd moved = de.seen(4 + 4 * iteration + i) - de.x[static_cast<std::size_t>(i)];
      REQUIRE((moved[0] == 0) != (moved[1] == 0));
      ++changed[moved[0] == 0 ? 1 : 0];
    }
  }
  CHECK(changed[0] > 0);
  CHECK(changed[1] > 0);
}

TEST_CASE("DE lets a joint come from the mutant with chance C, beside the forced one", "[differential_evolution]") {
  Started de({{"crossover", "0.5"}, {"bounds", "initial"}}, {1, 1, 1, 1});
  int both = 0;
  for (int iteration = 0; iteration < 250; ++iteration) {
    de.solver->step(de.objective, de.random);
    for (int i = 0; i < 4; ++i) {
      const Eigen::VectorXd moved = de.seen(4 + 4 * iteration + i) - de.x[static_cast<std::size_t>(i)];
      both += moved[0] != 0 && moved[1] != 0 ? 1 : 0;
    }
  }
  CHECK(std::abs(both - 500) < 64);  // binomial, n = 1000, p = 1/2: four standard deviations
}

TEST_CASE("DE replaces a candidate at once, and by a strictly better one only", "[differential_evolution]") {
  // The first trial is better, the second ties, the third and the fourth are worse.
  Started de({{"crossover", "1"}, {"bounds", "initial"}, {"replacement", "at_once"}}, {5, 5, 5, 5, 4, 5, 6, 6});
  de.solver->step(de.objective, de.random);
  CHECK_FALSE(mutant_of(de.seen(4), de.x, 0, 0.6).empty());
  de.x[0] = de.seen(4);
  for (int i = 1; i < 4; ++i) CHECK_FALSE(mutant_of(de.seen(4 + i), de.x, static_cast<std::size_t>(i), 0.6).empty());
  CHECK(de.solver->best().error == 4);
  de.solver->step(de.objective, de.random);
  for (int i = 0; i < 4; ++i) CHECK_FALSE(mutant_of(de.seen(8 + i), de.x, static_cast<std::size_t>(i), 0.6).empty());
}

TEST_CASE("DE combines the generation before, whatever has become better meanwhile", "[differential_evolution]") {
  Started de({{"crossover", "1"}, {"bounds", "initial"}}, {5, 5, 5, 5, 4, 4, 6, 6});  // Storn and Price 1997
  de.solver->step(de.objective, de.random);
  for (int i = 0; i < 4; ++i) CHECK_FALSE(mutant_of(de.seen(4 + i), de.x, static_cast<std::size_t>(i), 0.6).empty());
  de.x[0] = de.seen(4);
  de.x[1] = de.seen(5);
  de.solver->step(de.objective, de.random);
  for (int i = 0; i < 4; ++i) CHECK_FALSE(mutant_of(de.seen(8 + i), de.x, static_cast<std::size_t>(i), 0.6).empty());
}

TEST_CASE("DE brings a joint outside back to the limit, mirrors it there, or draws it anew",
          "[differential_evolution]") {
  const Settings wide{{"crossover", "1"}, {"weight", "2"}};
  const std::vector<double> flat{1, 1, 1, 1};
  const auto with = [&](const std::string& bounds) {
    Settings settings = wide;
    settings["bounds"] = bounds;
    return settings;
  };
  Started free(with("initial"), flat), clamp(with("clamp"), flat), reflect(with("reflect"), flat);
  Started resample(with("resample"), flat);
  int outside = 0;
  for (Started* de : {&free, &clamp, &reflect, &resample}) {
    for (int iteration = 0; iteration < 5; ++iteration) de->solver->step(de->objective, de->random);
  }
  for (int turn = 4; turn < 24; ++turn) {
    for (int j = 0; j < 2; ++j) {
      const double q = free.seen(turn)[j], limit = q < 0 ? -1 : 1;
      if (std::abs(q) <= 1) {
        CHECK(clamp.seen(turn)[j] == q);
        CHECK(reflect.seen(turn)[j] == q);
        continue;
      }
      ++outside;
      CHECK(clamp.seen(turn)[j] == limit);
      CHECK(reflect.seen(turn)[j] == Approx(std::clamp(2 * limit - q, -1.0, 1.0)));
      CHECK(std::abs(resample.seen(turn)[j]) < 1);
    }
  }
  CHECK(outside > 0);
}

TEST_CASE("DE needs three others", "[differential_evolution]") {
  const Task task = planar_task(3);
  Objective objective(task.chain, task.target);
  Random random{Key(1)};
  CHECK_THROWS_AS(solver("differential_evolution").make({})->start(task.problem, objective, random),
                  std::invalid_argument);
  CHECK_THROWS_WITH(
      solver("differential_evolution").make({})->start(task.problem, objective, random),
      "differential_evolution has a population of 3; expected at least 4, because it combines three others");
}
