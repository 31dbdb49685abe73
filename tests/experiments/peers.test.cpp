// Studies with solvers of libraries that this program may have been built without.
#include "tests/experiments/samples.hpp"

namespace {

const std::string own_entry = "[[solvers]]\nsolver = \"ik_bat\"\n";

}  // namespace

TEST_CASE("an entry says whether the study goes on where its solver was not built", "[study][peers]") {
  const Study study = read(own_entry + "if_missing = \"skip\"\n");
  CHECK(study.solvers.front().if_missing == IfMissing::skip);
  CHECK(study.skipped.empty());
  CHECK(read(to_toml(study)).solvers.front().if_missing == IfMissing::skip);
  CHECK(series_key(study, study.solvers.front()) == series_key(read(own_entry), read(own_entry).solvers.front()));
  CHECK_THROWS_WITH(read(own_entry + "if_missing = \"never\"\n"), ContainsSubstring("one of \"refuse\", \"skip\""));
}

TEST_CASE("a study that names a peer that was not built is refused, or goes on without it if it says so",
          "[study][peers]") {
  for (const MissingPeer& peer : missing_peers()) {
    CAPTURE(peer.name);
    const std::string entry = "[[solvers]]\nsolver = \"" + peer.name + "\"\nlabel = \"theirs\"\n";
    const std::string said = statements_of(entry + own_entry);
    CHECK(said.starts_with("my.toml:2"));
    CHECK(contains(said, peer.how));
    const Study without = read(entry + "if_missing = \"skip\"\n" + own_entry);
    REQUIRE(without.skipped.size() == 1);
    CHECK(without.skipped.front().label == "theirs");
    CHECK(without.skipped.front().reason == peer.how);
    CHECK(labels_of(without) == std::vector<std::string>{"ik_bat"});
    CHECK(to_toml(without).find("# left out: theirs is not built") != std::string::npos);
  }
}

TEST_CASE("a solver that cannot solve for the study's arm or search is refused with the reason", "[study][peers]") {
  if (std::ranges::count(missing_peers(), "kdl_newton", &MissingPeer::name) > 0) return;
  const std::string newton = "[[solvers]]\nsolver = \"kdl_newton\"\n";
  const std::string said = statements_of("search = \"all_joints\"\n" + newton);
  CHECK(said.starts_with("my.toml:3:10: "));
  CHECK(contains(said, "search = \"pose\""));
  CHECK(read("search = \"pose\"\n" + newton).solvers.size() == 1);
}

TEST_CASE("nobody counts the evaluations of a library with kinematics of its own", "[peers]") {
  Study study = load_study("baselines", {"path.points=2", "runs=1", "stop.iterations=20"});
  study.solvers.clear();
  for (const SolverInfo& info : solvers_for(robot_of(study).chain, GoalKind::pose)) {
    study.solvers.push_back({info.name, info.name, {}, 10});
  }
  for (const results::SolveRecord& record : solve_all(study)) {
    CAPTURE(record.label);
    const bool is_counted = solver(record.label).is_counted;
    CHECK(is_counted == (record.label != "kdl_newton"));
    CHECK((record.counted_by == results::CountedBy::ikbench) == is_counted);
    CHECK((record.evaluations > 0) == is_counted);
  }
}
