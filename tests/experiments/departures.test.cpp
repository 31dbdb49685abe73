// Departures of a study that claims to be the paper's study, as the store's definition lists them.
#include "tests/experiments/samples.hpp"

namespace {

std::vector<std::string> departures(const Overrides& overrides, const std::string& name = "slim2023") {
  const auto definition = nlohmann::json::parse(to_json(load_study(name, overrides)));
  return definition["departures"].get<std::vector<std::string>>();
}

}  // namespace

TEST_CASE("the paper's study under another seed, name or title is the paper's study; one of no paper departs from none",
          "[study]") {
  CHECK(departures({}).empty());
  CHECK(departures({"seed=2", "name=again", "title=Once more", "trace=best_error", "rounds=2"}).empty());
  CHECK(departures({"analysis.significance=0.01", "analysis.control=IK-BA"}).empty());  // no number of a solve
  CHECK(departures({"published=", "runs=5"}).empty());
}

TEST_CASE("every other change of the paper's study is a departure, by its key, but for the other arms of a paper",
          "[study]") {
  CHECK(departures({"robot=kinova_gen3", "search=all_joints"}).front() == "robot");
  CHECK(departures({"name=beeson2015-pr2_right", "robot=pr2_right"}, "beeson2015").empty());
  CHECK(departures({"runs=5"}) == std::vector<std::string>{"runs"});
  CHECK(departures({"path.tool=eq27", "bounds=clamp"}) ==
        std::vector<std::string>{"bounds", "path.tool", "options of IK-BA"});
  CHECK(departures({"DE.weight=0.5"}) == std::vector<std::string>{"options of DE"});
}

TEST_CASE("the paper's other studies depart from none, and are held against themselves", "[study]") {
  CHECK(departures({}, "slim2023-time").empty());
  CHECK(departures({}, "slim2023-dobot").empty());
  CHECK(departures({"path.points=2000"}, "slim2023-time") == std::vector<std::string>{"path.points"});
  CHECK(departures({"12 bats.population=16"}, "slim2023-time") == std::vector<std::string>{"options of 12 bats"});
  CHECK(departures({"path.radius_cm=6"}, "slim2023-dobot") == std::vector<std::string>{"path.radius_cm"});
}

TEST_CASE("a reading of the paper with limits departs from it in what it enforces", "[study]") {
  CHECK(departures({}, "slim2023-limits") == std::vector<std::string>{"limits", "options of IK-BA"});
  CHECK(departures({"limits=enforced"}) == departures({}, "slim2023-limits"));
}

TEST_CASE("a solver of the paper that a study lacks is no departure", "[study]") {
  Study study = load_study("slim2023", {});
  std::erase_if(study.solvers, [](const SolverEntry& entry) { return entry.label == "DE"; });
  CHECK(nlohmann::json::parse(to_json(study))["departures"].empty());
}
