// Checks of stored solves: an error that does not follow from the answer is found.
#include "experiments/stored_checks.hpp"

#include "tests/experiments/samples.hpp"

namespace {

Study study_with(const std::string& robot) {
  Study study = small_study();
  study.robot = robot;
  study.path = path_of({"kind=random", "points=3"});
  study.search = Search::all_joints;
  study.initial = Eigen::VectorXd::Zero(robot_of(study).joints());
  return study;
}

// Returns the complaint about the solves; empty if there is none.
std::string refused_row(const StoredStudy& entry, const std::vector<SolveRecord>& solves) {
  return complaint<std::invalid_argument>([&] { std::ranges::for_each(solves, stored_solve_check(entry)); });
}

}  // namespace

TEST_CASE("the solves of a study as they are made follow from their answers", "[recheck]") {
  const Search search = GENERATE(Search::all_joints, Search::axis);
  for (const char* robot : {"kuka_iiwa14", "dobot_magician", "stanford", "kinova_gen3", "abb_irb120"}) {
    INFO(robot);
    Study study = study_with(robot);
    study.search = search;
    CHECK(refused_row(to_stored(study), solve_all(study)) == "");
  }
  CHECK(refused_row(to_stored(small_study()), solve_all(small_study())) == "");  // by the wrist
}

TEST_CASE("an arm from a URDF file, verified by its origins and axes, is checked by its table", "[recheck]") {
  for (const char* file : {"tests/data/urdf/ur5_calibrated.urdf", "tests/data/urdf/ur5e.urdf"}) {
    Study study = study_with("ur5");
    study.robot_of_file = std::make_shared<const robots::Robot>(robots::load_robot(file));
    study.robot = file;
    std::vector<SolveRecord> solves = solve_all(study);
    CHECK(refused_row(to_stored(study), solves) == "");
    solves.back().position_error_cm += 1e-3;
    CHECK_THAT(refused_row(to_stored(study), solves), ContainsSubstring("position_error_cm"));
  }
}

TEST_CASE("an answer far beyond a slide's way follows from itself", "[recheck]") {
  const robots::Robot arm = robots::load_robot("tests/data/arms/slides.urdf");
  Study study = study_with("planar_2");
  study.robot_of_file = std::make_shared<const robots::Robot>(arm);
  SolveRecord far = solve_all(study).front();
  far.answer_rad = {1e12, 1e12};
  far.status = Status::limit_violated;
  const auto vector = [](const std::vector<double>& of) { return Eigen::VectorXd::Map(of.data(), std::ssize(of)); };
  Pose target = Pose::Identity();
  target.translation() = vector(far.target_position_m);
  const Verification of =
      verify(arm, {.target = target, .start = vector(far.start_rad), .answer = vector(far.answer_rad)});
  far.reached_position_m.assign(of.reached.begin(), of.reached.end());
  far.position_error_cm = far.reported_error_cm = of.position_error / centimetre;
  far.variation_m = of.joint_motion_m;
  far.limit_violation_m = of.limit_violation_m;
  CHECK(refused_row(to_stored(study), {far}) == "");
}

TEST_CASE("a target missed by less than the rounding of a check is missed", "[recheck]") {
  Study study = study_with("kuka_iiwa14");
  study.stop.tolerance = 1e-9;
  SolveRecord near = solve_all(study).front();
  near.target_position_m = near.reached_position_m;
  near.target_position_m[0] += 5e-9;
  near.position_error_cm = near.reported_error_cm = 5e-7;
  for (const Status status : {Status::ok, Status::tolerance_missed}) {
    near.status = status;
    CHECK(refused_row(to_stored(study), {near}) == "");
  }
}

TEST_CASE("an error that does not follow from its answer is refused, with the place of the solve", "[recheck]") {
  const Study study = study_with("stanford");
  const std::vector<SolveRecord> good = solve_all(study);
  const std::vector<std::pair<std::string, std::function<void(SolveRecord&)>>> changes{
      {"position_error_cm is -1, which no solve has", [](SolveRecord& solve) { solve.position_error_cm = -1; }},
      {"position_error_cm", [](SolveRecord& solve) { solve.position_error_cm *= 1.0001; }},
      {"position_error_cm is nan, but ", [](SolveRecord& solve) { solve.position_error_cm = not_a_number; }},
      {"position_error_cm", [](SolveRecord& solve) { solve.target_position_m[2] += 1e-6; }},
      {"position_error_cm", [](SolveRecord& solve) { solve.answer_rad[2] += 1e-6; }},
      {"orientation_error is 0, but ", [](SolveRecord& solve) { solve.orientation_error = 0; }},
      {"orientation_error", [](SolveRecord& solve) { solve.target_rotation[4] += 1e-6; }},
      {"largest_move_deg", [](SolveRecord& solve) { solve.largest_move_deg = 0; }},
      {"reached_position_m", [](SolveRecord& solve) { solve.reached_position_m[1] += 1e-6; }},
      {"not start at the previous answer", [](SolveRecord& solve) { solve.start_rad = solve.answer_rad; }},
      {"the arm moved, but its status is crashed", [](SolveRecord& solve) { solve.status = Status::crashed; }},
      {": it has 0 evaluations (counted by ikbench) in ", [](SolveRecord& solve) { solve.evaluations = 0; }},
      {"(counted by none) in ", [](SolveRecord& solve) { solve.counted_by = CountedBy::none; }},
      {" iterations and stops by ", [&](SolveRecord& solve) { solve.iterations = study.stop.iterations + 1; }},
      {" and stops by iterations", [](SolveRecord& solve) { --solve.iterations; }},
      {" and stops by ",
       [&](SolveRecord& solve) {
         solve.stop_reason = StopReason::tolerance;
         solve.iterations = study.stop.iterations + 1;
       }},
      {"has no such solve", [](SolveRecord& solve) { solve.run = 0; }},
      {"has no such solve", [&](SolveRecord& solve) { solve.point = study.path->points() + 1; }},
      {"variation_deg", [](SolveRecord& solve) { solve.variation_deg *= 1.0001; }},
      {"variation_m", [](SolveRecord& solve) { solve.variation_m += 1e-6; }},
      {"limit_violation_deg", [](SolveRecord& solve) { solve.limit_violation_deg += 1; }},
      {"limit_violation_m", [](SolveRecord& solve) { solve.limit_violation_m += 1; }},
      {"study's check", [](SolveRecord& solve) { solve.status = Status::invalid; }},
      {": seconds is -1, which no solve has", [](SolveRecord& solve) { solve.seconds = -1; }},
      {": seconds is 0, which no solve has", [](SolveRecord& solve) { solve.seconds = 0; }},
      {"cpu_seconds is inf, which no solve has", [](SolveRecord& solve) { solve.cpu_seconds = INFINITY; }},
      {"wall_seconds is -1, which no solve has", [](SolveRecord& solve) { solve.wall_seconds = -1; }},
      {"seconds are not its wall_seconds", [](SolveRecord& solve) { solve.seconds /= 2; }},
      {"batch_size is 0; ", [](SolveRecord& solve) { solve.batch_size = 0; }},
      {"batch_size is 2; ", [](SolveRecord& solve) { solve.batch_size = 2; }},
      {"all_answers_rad do not", [](SolveRecord& solve) { solve.all_answers_rad = {1}; }},
      {"reported_error_cm", [](SolveRecord& solve) { solve.reported_error_cm += 1e-3; }},
      {"reported_error_cm is nan, but ", [](SolveRecord& solve) { solve.reported_error_cm = not_a_number; }},
      {"status is not_finite, but ", [](SolveRecord& solve) { solve.status = Status::not_finite; }},
      {"does not fit an arm with 6 joints", [](SolveRecord& solve) { solve.answer_rad.pop_back(); }},
      {"does not fit an arm with 6 joints", [](SolveRecord& solve) { solve.target_rotation.clear(); }}};
  for (const auto& [what, change] : changes) {
    std::vector<SolveRecord> solves = good;
    change(solves[4]);
    CHECK_THAT(refused_row(to_stored(study), solves),
               ContainsSubstring(fmt::format("study {}, {}, run {}, point {}: ", study.name, solves[4].label,
                                             solves[4].run, solves[4].point)) &&
                   ContainsSubstring(what));
  }
}

TEST_CASE("a solve of a program that kept its budget has not spent 1.5 times as much", "[recheck]") {
  Study study = study_with("stanford");
  study.stop.evaluations = 1000;
  StoredStudy entry = to_stored(study);
  SolveRecord solve = solve_all(study).front();
  REQUIRE(is_sound(solve.status));
  solve.counted_by = CountedBy::solver;
  solve.evaluations = 1500;
  for (Series& series : entry.series) series.options = R"({"kind":"process"})";
  CHECK_THAT(refused_row(entry, {solve}), ContainsSubstring("(counted by solver) in "));
  for (Series& series : entry.series) series.options = R"({"process":"./program"})";
  CHECK(refused_row(entry, {solve}) == "");
  solve.batch_size = 2;
  CHECK(refused_row(entry, {solve}) == "");
  solve.evaluations = 1501;
  CHECK_THAT(refused_row(entry, {solve}), ContainsSubstring(": it has 1501 evaluations (counted by solver) in "));
}

TEST_CASE("an answer that reached has the numbers of the study's check, and an invalid one a fault", "[recheck]") {
  const Study study = study_with("stanford");
  StoredStudy entry = to_stored(study);
  entry.definition.check.process = {"./check"};
  entry.definition.check.larger = {"free"};
  SolveRecord solve = solve_all(study).front();
  const std::string number = fmt::format("{}free", check_extra), fault = fmt::format("{}near", invalid_extra);
  const auto is_refused = [&](Status status, const std::map<std::string, double>& extras) {
    solve.status = status, solve.extras = extras;
    return contains(refused_row(entry, {solve}), "study's check");
  };
  CHECK_FALSE(is_refused(Status::ok, {{number, 1}}));
  CHECK_FALSE(is_refused(Status::invalid, {{number, 1}, {fault, 1}}));
  CHECK(is_refused(Status::ok, {}));
  CHECK(is_refused(Status::ok, {{number, NAN}}));
  CHECK(is_refused(Status::ok, {{number, 1}, {fault, 1}}));
  CHECK(is_refused(Status::invalid, {{number, 1}}));
}

TEST_CASE("an arm that cannot be read is refused", "[recheck]") {
  for (const char* definition : {"{\"robot\": \"none\"}", "{\"arm\": {\"links\": [[[[[[1]]]]]]}}",
                                 R"({"arm": {"links": [{"a = 1\n[links]\nb": 2}]}})"}) {
    INFO(definition);
    CHECK_THAT(refused_row({.name = "small", .definition = parse_definition(definition), .series = {}}, {}),
               ContainsSubstring("study small: its stored arm cannot be read"));
  }
}

TEST_CASE("solves are made again from the store alone, and another bit or count is told", "[recheck]") {
  const ScratchFolder folder;
  Study study = study_with("ur5");
  study.robot_of_file = std::make_shared<const robots::Robot>(robots::load_robot("tests/data/urdf/panda.urdf"));
  study.robot = "tests/data/urdf/panda.urdf";
  study.initial = robots::Configuration::Zero(7);
  StoredStudy entry = to_stored(study);
  const std::vector<SolveRecord> solves = solve_all(study);
  const auto found_in = [&](const char* name, const std::vector<SolveRecord>& rows) {
    Store store(folder.path / name, Store::Mode::write);
    store.save_study(entry);
    store.append(rows);
    return rerun_sample(store, entry, 1000);
  };
  const RerunReport found = found_in("as_made", solves);
  CHECK(found.eligible == std::ssize(solves));
  CHECK(found.solves == found.eligible);
  for (const std::string what : {"evaluations", "restarts", "another answer"}) {
    std::vector<SolveRecord> forged = solves;
    if (what == "evaluations") --forged.back().evaluations;
    if (what == "restarts") forged.back().restarts = 99;
    if (what == "another answer") forged.back().answer_rad[0] = std::nextafter(forged.back().answer_rad[0], 9);
    CHECK_THAT(complaint<std::invalid_argument>([&] { found_in(what.c_str(), forged); }),
               ContainsSubstring("repeated, it has " + what));
  }
  StoredStudy renamed = entry;
  renamed.series.front().algorithm = "newton";
  const ScratchStore empty;
  CHECK_THAT(complaint<std::invalid_argument>([&] { rerun_sample(empty, renamed, 1000); }),
             ContainsSubstring("its solves are by ik_bat, not by newton"));
  StoredStudy odd = entry;
  for (const char* population : {"\"x\"", "-5", "1e300", "2000000000"}) {
    odd.series.front().options = fmt::format("{{\"population\": {}}}", population);
    CHECK_THAT(complaint<std::invalid_argument>([&] { stored_solve_check(odd); }), ContainsSubstring("population"));
  }
  for (Series& series : entry.series) series.key.back() = series.key.back() == '0' ? '1' : '0';
  CHECK(found_in("of_other_source", {}).changed_source.size() == entry.series.size());
}
