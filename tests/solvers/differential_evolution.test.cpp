// DE's limits; one_by_one.test.cpp has its equations.
#include "tests/solvers/objectives.hpp"

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

}  // namespace

TEST_CASE("DE brings a joint outside back to the limit, mirrors it there, or draws it anew",
          "[differential_evolution]") {
  const Settings wide{{"crossover", 1.0}, {"weight", 2.0}};
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
}
