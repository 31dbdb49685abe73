// Recheck finds every change of a store that does not follow from its answers.
#include "experiments/recheck.hpp"

#include <functional>
#include <limits>
#include <memory>

#include "experiments/study_writer.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/samples.hpp"

using namespace ikbench;
using namespace ikbench::results;
using namespace ikbench::experiments;

namespace {

StudyEntry entry_of(const Study& study) {
  StudyEntry entry{.name = study.name, .definition = to_json(study), .series = {}};
  for (const SolverEntry& solver : study.solvers)
    entry.series.push_back({.key = series_key(study, solver), .label = solver.label, .algorithm = solver.solver});
  return entry;
}

Study study_with(const std::string& robot) {
  Study study = small_study();
  study.robot = robot;
  study.path = path_of({"kind=random", "points=3"});
  study.search = Search::all_joints;
  study.initial = Eigen::VectorXd::Zero(arm_of(study).joints());
  return study;
}

std::vector<std::string> damages(const StudyEntry& entry, const std::vector<SolveRecord>& solves) {
  Recheck recheck(entry);
  for (const SolveRecord& solve : solves) recheck.look_at(solve);
  return recheck.damages();
}

}  // namespace

TEST_CASE("the solves of a study as they are made follow from their answers", "[recheck]") {
  for (const char* robot : {"kuka_iiwa14", "dobot_magician", "stanford", "kinova_gen3", "abb_irb120"}) {
    INFO(robot);
    const Study study = study_with(robot);
    CHECK(damages(entry_of(study), solves_of(study)).empty());
  }
}

TEST_CASE("an arm from a URDF file, verified by its origins and axes, is checked by its table", "[recheck]") {
  for (const char* file : {"tests/data/urdf/ur5_calibrated.urdf", "tests/data/urdf/ur5e.urdf"}) {
    Study study = study_with("ur5");
    study.robot_of_file = std::make_shared<const robots::Robot>(robots::load_robot(file));
    study.robot = file;
    for (const std::string& damage : damages(entry_of(study), solves_of(study))) FAIL_CHECK(damage);
  }
}

TEST_CASE("a changed number of a solve is damage, named by its column and the first solve", "[recheck]") {
  const Study study = study_with("stanford");
  const std::vector<SolveRecord> good = solves_of(study);
  const std::vector<std::pair<std::string, std::function<void(SolveRecord&)>>> changes{
      {"position_error_cm", [](SolveRecord& solve) { solve.position_error_cm = -1; }},
      {"position_error_cm", [](SolveRecord& solve) { solve.position_error_cm = 1.0001 * solve.position_error_cm; }},
      {"position_error_cm",
       [](SolveRecord& solve) { solve.position_error_cm = std::numeric_limits<double>::quiet_NaN(); }},
      {"position_error_cm", [](SolveRecord& solve) { solve.target_position_m[2] += 1e-6; }},
      {"orientation_error", [](SolveRecord& solve) { solve.orientation_error = 0; }},
      {"orientation_error", [](SolveRecord& solve) { solve.target_rotation[4] += 1e-6; }},
      {"variation_deg", [](SolveRecord& solve) { solve.start_rad[0] += 1e-6; }},
      {"variation_m", [](SolveRecord& solve) { solve.answer_rad[2] += 1e-6; }},
      {"largest_move_deg", [](SolveRecord& solve) { solve.largest_move_deg = 0; }},
      {"limit_violation_deg", [](SolveRecord& solve) { solve.limit_violation_deg = -3; }},
      {"limit_violation_m", [](SolveRecord& solve) { solve.limit_violation_m += 0.1; }},
      {"status", [](SolveRecord& solve) { solve.status = solve.status == Status::ok ? Status::refused : Status::ok; }},
      {"status", [](SolveRecord& solve) { solve.status = Status::over_budget; }},
      {"reached_position_m", [](SolveRecord& solve) { solve.reached_position_m[1] += 1; }},
      {"smallest_seconds", [](SolveRecord& solve) { solve.smallest_seconds = 99; }},
      {"repeats", [](SolveRecord& solve) { solve.repeats = -1; }},
      {"evaluations", [](SolveRecord& solve) { solve.evaluations = -1; }},
      {"iterations", [](SolveRecord& solve) { solve.iterations = -7; }},
      {"improved_at",
       [](SolveRecord& solve) {
         solve.improved_at = {1, 7}, solve.improved_to_cm = {5};
       }},
      {"improved_at",
       [](SolveRecord& solve) {
         solve.improved_at = {7, 1}, solve.improved_to_cm = {5, 4};
       }},
      {"improved_at", [](SolveRecord& solve) { solve.improved_at = {-1}, solve.improved_to_cm = {5}; }},
      {"seconds", [](SolveRecord& solve) { solve.seconds = -1; }},
      {"cpu_seconds", [](SolveRecord& solve) { solve.cpu_seconds = std::numeric_limits<double>::infinity(); }},
      {"largest_seconds", [](SolveRecord& solve) { solve.largest_seconds = solve.seconds / 2; }},
      {"answer_rad", [](SolveRecord& solve) { solve.answer_rad.pop_back(); }},
      {"answer_rad", [](SolveRecord& solve) { solve.target_rotation.clear(); }}};
  for (const auto& [column, change] : changes) {
    std::vector<SolveRecord> solves = good;
    change(solves[4]);
    std::string said;
    for (const std::string& sentence : damages(entry_of(study), solves)) said += sentence;
    CHECK_THAT(said, ContainsSubstring("Damaged: " + column + " of 1 solve (first: " + solves[4].solver + ", run " +
                                       std::to_string(solves[4].run) + ", point " + std::to_string(solves[4].point)));
  }
}

TEST_CASE("a solve that does not fit its digest is damage, whatever was changed in it", "[recheck]") {
  const Study study = study_with("stanford");
  std::vector<SolveRecord> solves = solves_of(study);
  solves[4].evaluations += 1;
  solves[7].seconds *= 1.5;
  solves[7].largest_seconds *= 2;
  const std::vector<std::string> said = damages(entry_of(study), solves);
  REQUIRE(said.size() == 1);
  CHECK_THAT(said[0], ContainsSubstring("Damaged: digest of 2 solves (first: " + solves[4].solver + ", run " +
                                        std::to_string(solves[4].run) + ", point ") &&
                          ContainsSubstring("the solve was changed since it was written"));
}

TEST_CASE("targets and starts are those that the definition gives", "[recheck]") {
  for (const char* path : {"kind=random", "kind=helix", "kind=circle"}) {
    for (const Start start : {Start::previous, Start::initial, Start::middle, Start::random, Start::near}) {
      CAPTURE(path, static_cast<int>(start));
      Study study = small_study();
      study.path = path_of({path, "points=3"});
      study.start = start;
      if (start == Start::near && !study.path->is_drawn()) continue;
      const std::vector<SolveRecord> good = solves_of(study);
      CHECK(damages(entry_of(study), good).empty());
      const auto said_of = [&](const std::function<void(SolveRecord&)>& change) {
        std::vector<SolveRecord> solves = good;
        change(solves[4]);
        std::string said;
        for (const std::string& sentence : damages(entry_of(study), solves)) said += sentence;
        return said;
      };
      CHECK_THAT(said_of([](SolveRecord& solve) { solve.target_position_m[0] += 1e-6; }),
                 ContainsSubstring("Damaged: target_position_m of 1 solve") &&
                     ContainsSubstring("it is not what the definition of the study gives"));
      CHECK_THAT(said_of([](SolveRecord& solve) { solve.start_rad[0] += 1e-6; }),
                 ContainsSubstring("Damaged: start_rad of 1 solve"));
      CHECK_THAT(said_of([](SolveRecord& solve) { solve.start_rad.assign(100, 1e300); }),
                 ContainsSubstring("Damaged: answer_rad of 1 solve"));
    }
  }
}

TEST_CASE("targets that another version of the source drew are not drawn again", "[recheck]") {
  const Study study = study_with("stanford");
  std::vector<SolveRecord> solves = solves_of(study);
  StudyEntry entry = entry_of(study);
  for (Series& series : entry.series) series.key.back() = series.key.back() == '0' ? '1' : '0';
  solves[4].digest = 0;
  solves[4].target_position_m[0] += 1e-6;
  for (const std::string& sentence : damages(entry, solves))
    CHECK_THAT(sentence, !ContainsSubstring("target_position_m"));
}

TEST_CASE("an arm that cannot be read is said, and nothing else is made of it", "[recheck]") {
  const Study study = study_with("stanford");
  const std::vector<SolveRecord> solves = solves_of(study);
  for (const char* definition :
       {"", "[]", "{\"robot\": \"none\"}", "{\"arm\": 3}", "{\"arm\": {\"links\": [[[[[[1]]]]]]}}", "{\"robot\": 4}",
        R"({"arm": {"links": [{"a = 1\n[links]\nb": 2}]}})"}) {
    INFO(definition);
    const StudyEntry entry{.name = "small", .definition = definition, .series = {}};
    CHECK_FALSE(stored_arm(definition).has_value());
    const std::vector<std::string> said = damages(entry, solves);
    REQUIRE(said.size() == 1);
    CHECK_THAT(said[0], ContainsSubstring("cannot be read"));
  }
}
