// The runner: the same numbers in all circumstances, and a judgement of every answer.
#include "tests/experiments/samples.hpp"

namespace {

// Runs a study until `solves` more are done, then stops as Ctrl-C does.
Progress run_for(const Study& study, Store& store, std::int64_t solves) {
  std::atomic<bool> cancelled{false};
  const auto look = [&](const Progress& now) { cancelled = now.done - now.reused >= solves; };
  return run(study, store, {.jobs = 1, .progress = look, .cancelled = &cancelled});
}

Study study_of_every_solver() {
  Study study = small_study();
  study.solvers.clear();
  for (const SolverInfo& info : solvers_for(robot_of(study).chain, GoalKind::position)) {
    study.solvers.push_back({info.name, info.name, {}, std::max(study.population, info.min_population)});
  }
  return study;
}

Study small_random_study() {
  Study study = small_study();
  study.path = path_of({"kind=random", "points=4"});
  return study;
}

Pose at(double x, double y, double z) {
  Pose pose = Pose::Identity();
  pose.linear() = tool_rotation(ToolOrientation::down);
  pose.translation() << x, y, z;
  return pose;
}

}  // namespace

// ---- the same numbers ---------------------------------------------------------------------------------------------

TEST_CASE("adding, removing and reordering solvers changes no other solver's numbers", "[runner]") {
  const std::vector<SolveRecord> three = solve_all(small_study());
  Study study = small_study();
  study.solvers = {{"DE", "differential_evolution", {}}, {"new", "ik_bat", {}}, {"IK-BA", "ik_bat", {}}};
  const std::vector<SolveRecord> others = solve_all(study);
  CHECK(same_numbers(only("DE", others), only("DE", three)));
  CHECK(same_numbers(only("IK-BA", others), only("IK-BA", three)));
  // Another label has other random numbers.
  CHECK(only("new", others).back().answer_rad != only("IK-BA", others).back().answer_rad);
}

TEST_CASE("a study from the store's point of view: name, series in order, options, numbers of runs and points",
          "[runner]") {
  ScratchStore scratch;
  Study study = small_study();
  study.solvers[1].options["alpha"] = 0.25;
  run(study, scratch, {});
  const StoredStudy entry = scratch.study("small");
  REQUIRE(entry.series.size() == 3);
  CHECK(entry.series[0].label == "IK-BA");
  CHECK(entry.series[1].algorithm == "bat");
  CHECK(nlohmann::json::parse(entry.series[1].options)["alpha"] == 0.25);
  CHECK(entry.series[2].key == series_key(study, study.solvers[2]));
  const nlohmann::json definition = nlohmann::json::parse(entry.definition.json);
  CHECK(definition["runs"] == 2);
  CHECK(definition["points"] == 4);
}

TEST_CASE("every session remembers how the study was to be judged when its solves were made", "[runner][analysis]") {
  ScratchStore scratch;
  Study study = small_study();
  run_for(study, scratch, 3);
  study.plan.significance = 0.01;
  run(study, scratch, {});
  const std::vector<results::Session> sessions = scratch.sessions();
  REQUIRE(sessions.size() >= 2);
  CHECK(nlohmann::json::parse(sessions.front().environment.at("analysis"))["significance"] == 0.05);
  CHECK(nlohmann::json::parse(sessions.back().environment.at("analysis"))["significance"] == 0.01);
  CHECK(nlohmann::json::parse(scratch.study("small").definition.json)["analysis"]["significance"] == 0.01);
  CHECK(solves_of(scratch, "small").size() == 24);  // the earlier ones are kept
}

// ---- only what is missing -----------------------------------------------------------------------------------------

TEST_CASE("running again does nothing", "[runner]") {
  ScratchStore scratch;
  const Progress first = run(small_study(), scratch, {});
  CHECK(first.done == 24);
  CHECK(first.reused == 0);
  const std::vector<SolveRecord> before = solves_of(scratch, "small");
  const Progress second = run(small_study(), scratch, {});
  CHECK(second.done == 24);
  CHECK(second.total == 24);
  CHECK(second.reused == 24);
  const std::vector<SolveRecord> after = solves_of(scratch, "small");
  CHECK(std::equal(before.begin(), before.end(), after.begin(), after.end(),
                   [](const auto& a, const auto& b) { return same(a, b); }));  // times too
  CHECK(scratch.sessions().size() == 2);                                       // of two runs
}

TEST_CASE("a run that is stopped anywhere and continued gives what an uninterrupted one gives", "[runner]") {
  const std::vector<SolveRecord> uninterrupted = solve_all(small_study());
  for (const std::int64_t solves : {1, 3, 5, 12, 23}) {
    INFO(solves);
    ScratchStore scratch;
    const Progress stopped = run_for(small_study(), scratch, solves);
    CHECK(stopped.done == solves);
    CHECK(stopped.total == 24);
    CHECK(solves_of(scratch, "small").size() == static_cast<std::size_t>(solves));
    const Progress rest = run(small_study(), scratch, {.jobs = 2});
    CHECK(rest.done == 24);
    CHECK(rest.reused == solves);
    CHECK(same_numbers(solves_of(scratch, "small"), uninterrupted));
  }
}

TEST_CASE("parallel jobs stop soon after they are asked to, and what they did stays", "[runner]") {
  ScratchStore scratch;
  Study study = small_study();
  study.runs = 10'000;  // takes longer than any transaction
  std::atomic<bool> cancelled{false};
  const auto look = [&](const Progress& now) { cancelled = now.done >= 5; };
  const Progress stopped = run(study, scratch, {.jobs = 4, .progress = look, .cancelled = &cancelled});
  CHECK(stopped.done >= 5);
  CHECK(stopped.done < stopped.total);
  CHECK(solves_of(scratch, "small").size() == static_cast<std::size_t>(stopped.done));
  run(small_study(), scratch, {});
  CHECK(same_numbers(solves_of(scratch, "small"), solve_all(small_study())));
}

TEST_CASE("what fails where solves are taken is told, ends the work, and what was taken before stays", "[runner]") {
  for (const int jobs : {1, 4}) {
    ScratchStore scratch;
    Study study = small_study();
    study.runs = 10'000;
    const auto fail = [](const Progress& now) {
      if (now.done == 5) throw std::runtime_error("no space");
    };
    CHECK(complaint<std::runtime_error>([&] { run(study, scratch, {.jobs = jobs, .progress = fail}); }) == "no space");
    const std::size_t kept = solves_of(scratch, "small").size();
    CHECK(kept >= 5);
    CHECK(kept < 120'000);
    CHECK(run(small_study(), scratch, {}).done == 24);
    CHECK(same_numbers(solves_of(scratch, "small"), solve_all(small_study())));

    int taken = 0;
    const auto refuse = [&](const SolveRecord&) {
      ++taken;
      throw std::runtime_error("no room");
    };
    CHECK(complaint<std::runtime_error>([&] { solve_without_store(study, jobs, refuse); }) == "no room");
    CHECK(taken == 1);
  }
}

TEST_CASE("a study is solved without a store to the same numbers, the points of a run in their order", "[runner]") {
  const Study study = study_of_every_solver();
  const std::vector<SolveRecord> stored = solve_all(study);
  for (const int jobs : {1, 2, 4}) {
    std::map<std::pair<std::string, int>, std::vector<SolveRecord>> taken;
    solve_without_store(study, jobs, [&](SolveRecord record) {
      std::vector<SolveRecord>& of_run = taken[{record.label, record.run}];
      CHECK(record.point == static_cast<int>(of_run.size()) + 1);
      of_run.push_back(std::move(record));
    });
    std::vector<SolveRecord> ordered;
    for (const SolveRecord& record : stored) {
      ordered.push_back(taken.at({record.label, record.run}).at(static_cast<std::size_t>(record.point - 1)));
    }
    CHECK(same_numbers(ordered, stored));
  }
}

TEST_CASE("solvers take turns at being first, run by run", "[runner]") {
  Study study = small_study();
  study.runs = 4;
  std::vector<std::string> order;
  solve_without_store(study, 1, [&](const SolveRecord& record) {
    if (record.point == 1) order.push_back(record.label);
  });
  CHECK(order ==
        std::vector<std::string>{"IK-BA", "BA", "DE", "BA", "DE", "IK-BA", "DE", "IK-BA", "BA", "IK-BA", "BA", "DE"});
}

TEST_CASE("of a changed study only what the store lacks is solved, and what it no longer asks for stays", "[runner]") {
  const auto check = [](std::int64_t total, std::int64_t reused, void (*change)(Study&)) {
    ScratchStore scratch;
    Study study = small_study();
    run(study, scratch, {});
    change(study);
    const Progress again = run(study, scratch, {});
    CHECK(again.total == total);
    CHECK(again.reused == reused);
    CHECK(same_numbers(solves_of(scratch, study.name), solve_all(study)));
    CHECK(scratch.studies().size() == (study.name == "small" ? 1 : 2));
    CHECK(run(small_study(), scratch, {}).reused == 24);
    CHECK(same_numbers(solves_of(scratch, "small"), solve_all(small_study())));
  };
  check(36, 24, [](Study& study) { study.runs = 3; });
  check(12, 12, [](Study& study) { study.runs = 1; });
  check(32, 24, [](Study& study) { study.solvers.push_back({"PSO", "particle_swarm", {}}); });
  check(24, 16, [](Study& study) { study.solvers[0].options["bounds"] = "clamp"; });
  check(24, 24, [](Study& study) { study.name = "renamed"; });
  check(24, 0, [](Study& study) {
    study.name = "other";
    study.seed = 7;
  });
}

TEST_CASE("solves of other source are left aside and solved anew", "[runner]") {
  const Study study = small_study();
  const auto of_other_source = [](std::string& key) {
    key = fmt::format("{}@0123456789abcdef", configuration_part(key));
  };
  ScratchStore scratch;
  StoredStudy entry = to_stored(study);
  std::vector<SolveRecord> records = solve_all(study);
  for (SolveRecord& record : records) of_other_source(record.series);
  for (Series& series : entry.series) of_other_source(series.key);
  scratch.save_study(entry);
  scratch.append(records);
  CHECK(solves_of(scratch, "small").size() == 24);  // reports read them
  CHECK(run(study, scratch, {}).reused == 0);
  CHECK(same_numbers(solves_of(scratch, "small"), solve_all(study)));
  CHECK(series_of(scratch, entry.series[0].key).size() == 8);  // they stay
}

TEST_CASE("a run whose study another process replaces is refused, keeps its solves, and is told what to do",
          "[runner]") {
  for (const int jobs : {1, 4}) {
    ScratchStore store;
    Study other = small_study();
    other.seed = 2;
    const auto meddle = [&](const Progress& now) {
      if (now.done != 5) return;
      Store rival(store.file, Store::Mode::write);
      run(other, rival, {});
    };
    const std::string said =
        complaint<std::invalid_argument>([&] { run(small_study(), store, {.jobs = jobs, .progress = meddle}); });
    CHECK_THAT(said, ContainsSubstring("saved a different study named 'small' in this store"));
    CHECK_THAT(said, ContainsSubstring("run this study again for its report"));
    CHECK(store.study("small").definition.json == to_json(other));
    CHECK(run(small_study(), store, {}).reused == 24);
    CHECK(same_numbers(solves_of(store, "small"), solve_all(small_study())));
  }
}

TEST_CASE("a store that was edited is refused and says where", "[runner]") {
  const auto complaint_after = [](const char* edit) {
    ScratchStore scratch;
    run(small_study(), scratch, {});
    SQLite::Database(scratch.file.string(), SQLite::OPEN_READWRITE).exec(edit);
    return complaint<std::invalid_argument>([&] { run(small_study(), scratch, {}); });
  };
  for (const auto& [edit, part] : std::vector<std::pair<const char*, const char*>>{
           {"DELETE FROM solves WHERE label = 'BA' AND run = 2 AND point = 3", "run 2, point 4 by BA is not the one"},
           {"UPDATE solves SET run = 0 WHERE label = 'BA' AND run = 2", "run 0, point 1 by BA is not the one"},
           {"UPDATE solves SET answer_rad = '[1]' WHERE label = 'BA' AND run = 2 AND point = 1",
            "run 2, point 1 by BA is not the one"}}) {
    const std::string message = complaint_after(edit);
    CAPTURE(edit, message);
    CHECK(contains(message, part));
  }
}

TEST_CASE("progress is told before the first solve and after every one, and never goes back", "[runner]") {
  for (const int jobs : {1, 3}) {
    ScratchStore scratch;
    std::vector<std::int64_t> reported;
    run(small_study(), scratch, {.jobs = jobs, .progress = [&](const Progress& now) {
                                   CHECK(now.total == 24);
                                   reported.push_back(now.done);
                                 }});
    REQUIRE(reported.size() == 25);
    for (std::size_t i = 0; i < reported.size(); ++i) CHECK(reported[i] == static_cast<std::int64_t>(i));
  }
}

// ---- chains of points, independent runs ---------------------------------------------------------------------------

TEST_CASE("the points of a run are chained: a solve starts where the one before it left the arm", "[runner]") {
  Study study = study_of_every_solver();
  study.initial << 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7;
  const std::vector<SolveRecord> records = solve_all(study);
  for (std::size_t i = 0; i < records.size(); ++i) {
    INFO(records[i].label << " run " << records[i].run << " point " << records[i].point);
    if (records[i].point == 1) {
      CHECK(same(records[i].start_rad, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7}));
    } else {
      CHECK(same(records[i].start_rad, records[i - 1].answer_rad));
    }
  }
}

TEST_CASE("random targets are those of the run: the same for all solvers, others in another run", "[runner]") {
  Study study = small_random_study();
  std::map<std::pair<int, int>, std::vector<double>> seen;
  const std::vector<SolveRecord> records = solve_all(study, 2);
  REQUIRE(records.size() == 24);
  for (const SolveRecord& record : records) {
    std::vector<double> target = record.target_position_m;
    target.insert(target.end(), record.target_rotation.begin(), record.target_rotation.end());
    CHECK(seen.try_emplace({record.run, record.point}, target).first->second == target);
    const Pose expected = targets_of_run(study, record.run)[static_cast<std::size_t>(record.point - 1)];
    CHECK(Eigen::Vector3d(record.target_position_m.data()) == expected.translation());
  }
  CHECK(seen.size() == 8);
  CHECK(seen.at({1, 1}) != seen.at({2, 1}));

  study.seed = 2;
  CHECK(targets_of_run(study, 2)[3].matrix() != targets_of_run(small_random_study(), 2)[3].matrix());
}

// ---- limits, enforced ---------------------------------------------------------------------------------------------

TEST_CASE("where limits are enforced no solver takes any joint of the arm outside them", "[runner][solvers]") {
  for (const WristBranch branch : {WristBranch::nearest, WristBranch::positive, WristBranch::negative}) {
    Study study = study_of_every_solver();
    study.limits = LimitPolicy::enforced;
    study.wrist_branch = branch;
    const JointLimits limits = robot(study.robot).limits;
    for (const SolveRecord& record : solve_all(study)) {
      INFO(record.label);
      CHECK(limits.violation(Eigen::VectorXd::Map(record.answer_rad.data(), 7)) < 1e-9);
      CHECK(record.limit_violation_deg == 0);
      CHECK((record.status == Status::ok || record.status == Status::refused));
    }
  }
}

TEST_CASE("a refused answer leaves the arm where it was, and the record tells of that", "[runner]") {
  Study study = load_study("slim2023-50");  // with the wrist's limits, some points are out of reach for some arms
  study.limits = LimitPolicy::enforced;
  study.solvers = {{"BA", "bat", {}}, {"DE", "differential_evolution", {}}};
  study.stop.iterations = 20;
  study.runs = 3;
  const Robot arm = robot(study.robot);
  const std::vector<Pose> poses = targets_of_run(study, 1);
  int refused = 0;
  const std::vector<SolveRecord> records = solve_all(study);
  for (std::size_t i = 0; i < records.size(); ++i) {
    const SolveRecord& record = records[i];
    if (record.point > 1) CHECK(same(record.start_rad, records[i - 1].answer_rad));
    if (record.status != Status::refused) continue;
    ++refused;
    CHECK(same(record.answer_rad, record.start_rad));
    CHECK(record.variation_deg == 0);
    const Eigen::Vector3d tool = arm.chain.position(Eigen::VectorXd::Map(record.start_rad.data(), 7));
    const double away = (tool - poses[static_cast<std::size_t>(record.point - 1)].translation()).norm();
    CHECK(record.position_error_cm == Approx(away * 100));
    CHECK(record.reported_error_cm < record.position_error_cm);  // the solver's error for the joints that it knows
  }
  CHECK(refused > 0);
  CHECK(refused < static_cast<int>(records.size()));

  ScratchStore scratch;  // after a stop, a chain continues behind a refusal
  for (int more = 1; more <= 5; ++more) run_for(study, scratch, 17);
  run(study, scratch, {});
  CHECK(same_numbers(solves_of(scratch, study.name), records));
}

TEST_CASE("where limits are enforced the wrist takes the branch inside, whichever was asked for", "[runner]") {
  Study study = small_study();
  study.solvers = {{"DLS", "damped_least_squares", {{"bounds", "clamp"}}}};
  study.stop = {.iterations = 200, .tolerance = 1e-6};
  const Robot arm = robot(study.robot);
  const auto status = [&](const Pose& target, LimitPolicy limits, WristBranch branch) {
    study.limits = limits;
    study.wrist_branch = branch;
    return solve_once(study, study.solvers[0], target).status;
  };
  int by_turning = 0, by_no_means = 0;
  study.path = path_of({"kind=random", "points=60"});
  for (const Pose& target : targets_of_run(study, 1)) {
    const Status positive = status(target, LimitPolicy::recorded, WristBranch::positive);
    const Status negative = status(target, LimitPolicy::recorded, WristBranch::negative);
    const bool one_is_inside = positive == Status::ok || negative == Status::ok;
    const Status expected = one_is_inside ? Status::ok : Status::refused;
    for (const WristBranch branch :
         {WristBranch::nearest, WristBranch::positive, WristBranch::negative, WristBranch::inside}) {
      CHECK(status(target, LimitPolicy::enforced, branch) == expected);
    }
    by_turning += one_is_inside && positive != negative ? 1 : 0;
    by_no_means += one_is_inside ? 0 : 1;
  }
  CHECK(by_turning > 0);
  CHECK(by_no_means > 0);
}

// ---- the Dobot's circle -------------------------------------------------------------------------------------------

TEST_CASE("IK-BA draws the Dobot's circle with the angles of Table 8, to errors of its size",
          "[runner][dobot][paper]") {
  const CsvTable printed = published::table("slim2023", "table-8");
  const std::vector<SolveRecord> records = solve_all(load_study("slim2023-dobot"));
  REQUIRE(records.size() == 20);
  CHECK(fingerprint(records) == reference_fingerprint("slim2023-dobot"));
  for (std::size_t i = 0; i < 20; ++i) {
    INFO("point " << i + 1);
    CHECK(records[i].status == Status::ok);
    CHECK(records[i].position_error_cm < 1e-13);  // printed: 1.1e-14 to 9.6e-14
    CHECK(records[i].trace_cm.size() == 1000);    // Figure 18
    for (std::size_t j = 0; j < 3; ++j) {
      const double angle = printed.number(i, "theta" + std::to_string(j + 1) + "_deg");
      CHECK(std::abs(records[i].answer_rad[j] / degree - angle) <= 0.05 + 1e-9);  // as printed, to 0.1 deg
    }
  }
}

// ---- answers, judged ----------------------------------------------------------------------------------------------

TEST_CASE("the verified error of every solver is the one it claims", "[runner][solvers]") {
  for (const Search search : {Search::wrist, Search::all_joints, Search::pose, Search::axis, Search::flange}) {
    Study study = study_of_every_solver();
    study.search = search;
    for (const SolveRecord& record : solve_all(study)) {
      INFO(record.label);
      CHECK(record.position_error_cm == Approx(record.reported_error_cm).margin(1e-10).epsilon(0));
      CHECK(record.status != Status::misreported);
      CHECK(record.status != Status::not_finite);
    }
  }
}

TEST_CASE("every solver searches poses of an arm without a spherical wrist, and damped least squares finds most",
          "[runner][solvers][pose]") {
  Study study = study_of_every_solver();
  study.robot = "ur5e";
  study.search = Search::pose;
  study.path = path_of({"kind=random", "points=10"});
  study.initial = Eigen::VectorXd::Zero(6);
  study.start = Start::initial;
  study.stop = {.iterations = 400, .tolerance = 1e-4, .angle_tolerance = 0.1 * degree, .evaluations = 4000};
  const Robot arm = robot("ur5e");
  std::map<std::string, int> within;
  for (const SolveRecord& record : solve_all(study)) {
    CAPTURE(record.label, record.run, record.point);
    CHECK((record.status == Status::ok || record.status == Status::tolerance_missed ||
           record.status == Status::limit_violated));
    CHECK(record.position_error_cm == Approx(record.reported_error_cm).margin(1e-10).epsilon(0));
    // ||R - Rd|| is sqrt(8) sin(angle / 2), and ||Rd|| sqrt(3).
    const double angle = 2 * std::asin(std::min(1.0, record.orientation_error * std::sqrt(3.0 / 8)));
    const bool is_within = record.position_error_cm <= 1e-2 + 1e-7 && angle <= 0.1 * degree + 1e-9;
    CHECK((record.stop_reason == StopReason::tolerance) == is_within);
    if (record.status != Status::limit_violated) CHECK((record.status == Status::ok) == is_within);
    within[record.label] += is_within ? 1 : 0;
  }
  CHECK(within["damped_least_squares"] >= 15);  // of 20
  CHECK(within["random_search"] == 0);
}

TEST_CASE("an arm of five joints finds the axes that it can reach", "[runner][axis]") {
  Study study;
  study.robot = "tests/data/urdf/jaw.urdf";
  study.robot_of_file = std::make_shared<const Robot>(load_robot(study.robot, {.tip = "tool"}));
  study.search = Search::axis;
  study.path = path_of({"kind=random", "points=25"});
  study.initial = Eigen::VectorXd::Zero(5);
  study.start = Start::initial;
  study.stop = {.iterations = 2000, .tolerance = 1e-5, .angle_tolerance = 0.01 * degree};
  study.runs = 2;
  study.solvers = {{"DLS", "damped_least_squares", {}}, {"LM", "levenberg_marquardt", {}}};
  std::map<std::string, int> ok;
  for (const SolverInfo& info : all_solvers()) {  // peers, where they are built
    if (info.name == "newton_slsqp") study.solvers.push_back({"TRAC-IK's rule", info.name, {}});
    if (info.name == "nlopt") study.solvers.push_back({"NLopt", info.name, {{"restarts", "random"}}});
  }
  for (const SolveRecord& record : solve_all(study)) ok[record.label] += record.status == Status::ok ? 1 : 0;
  for (const SolverEntry& entry : study.solvers) {
    CAPTURE(entry.label);
    CHECK(ok[entry.label] == 50);
  }
}

TEST_CASE("with the wrist in closed form the orientation is exact on either branch", "[runner]") {
  for (const WristBranch branch : {WristBranch::nearest, WristBranch::positive, WristBranch::negative}) {
    Study study = small_study();
    study.wrist_branch = branch;
    for (const SolveRecord& record : solve_all(study)) {
      CHECK(record.orientation_error < 1e-9);
      if (branch == WristBranch::positive) CHECK(record.answer_rad[5] >= 0);
      if (branch == WristBranch::negative) CHECK(record.answer_rad[5] <= 0);
    }
  }
}

TEST_CASE("a search for the flange leaves the last joint where it is, and finds the same as one of all joints",
          "[runner]") {
  Study study = small_study();
  study.solvers = {{"DLS", "damped_least_squares", {}}};
  study.initial[6] = 0.3;
  study.search = Search::flange;
  const std::vector<SolveRecord> flange = solve_all(study);
  study.search = Search::all_joints;
  const std::vector<SolveRecord> all = solve_all(study);
  REQUIRE(flange.size() == all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    CHECK(flange[i].answer_rad[6] == 0.3);
    for (std::size_t j = 0; j < 6; ++j) CHECK(flange[i].answer_rad[j] == Approx(all[i].answer_rad[j]).margin(1e-6));
  }
}

TEST_CASE("wrist_turns = nearest turns a wrist angle by whole turns, to at most half a turn from its start",
          "[runner]") {
  Study study = small_study();
  study.wrist_branch = WristBranch::positive;
  study.initial << 0.1, 0.5, 0.2, -0.9, 3.1, 0.8, -9.0;
  const Pose target = targets_of_run(study, 1)[0];
  const SolveRecord principal = solve_once(study, study.solvers[0], target);
  study.wrist_turns = WristTurns::nearest;
  const SolveRecord nearest = solve_once(study, study.solvers[0], target);
  for (std::size_t j = 0; j < 7; ++j) {
    const double turns = (nearest.answer_rad[j] - principal.answer_rad[j]) / (2 * std::numbers::pi);
    CHECK(turns == Approx(std::round(turns)).margin(1e-12));
    CHECK(std::abs(principal.answer_rad[j]) <= std::numbers::pi + 1e-12);
    if (j > 3)
      CHECK(std::abs(nearest.answer_rad[j] - study.initial[static_cast<Eigen::Index>(j)]) <= std::numbers::pi + 1e-12);
  }
  CHECK(std::abs(nearest.answer_rad[6]) > std::numbers::pi);
}

TEST_CASE("the nearest branch moves the wrist no further than either of the two", "[runner]") {
  Study study = small_study();
  study.initial << 0.1, 0.5, 0.2, -0.9, 0.3, -0.8, 0.4;
  const Pose target = targets_of_run(study, 1)[0];
  const auto wrist_move = [&](WristBranch branch) {
    study.wrist_branch = branch;
    const SolveRecord record = solve_once(study, study.solvers[0], target);
    return (Eigen::VectorXd::Map(record.answer_rad.data(), 7) - study.initial).tail<3>().norm();
  };
  // The joints before the wrist are the same: the branch is not part of the stream's key.
  CHECK(wrist_move(WristBranch::nearest) ==
        Approx(std::min(wrist_move(WristBranch::positive), wrist_move(WristBranch::negative))));
}

TEST_CASE("a target that is no number, or no place in the world, gives not_finite and moves no arm",
          "[runner][solvers]") {
  for (const double bad : {not_a_number, infinity, -infinity, 1e300}) {
    for (const Search search : {Search::wrist, Search::all_joints}) {
      Study study = study_of_every_solver();
      study.search = search;
      study.runs = 1;
      study.path = path_through({at(0.5, 0.1, 0.4), at(bad, 0.1, 0.4), at(0.5, 0.1, 0.4)});
      const std::vector<SolveRecord> records = solve_all(study);
      REQUIRE(records.size() == study.solvers.size() * 3);
      for (std::size_t i = 0; i < records.size(); i += 3) {
        INFO(records[i].label << " towards " << bad);
        CHECK(records[i].status != Status::not_finite);
        CHECK(records[i + 1].status == Status::not_finite);
        CHECK(records[i + 1].stop_reason == StopReason::not_finite);
        CHECK(same(records[i + 2].start_rad, records[i].answer_rad));
        CHECK(records[i + 2].status != Status::not_finite);
      }
    }
  }
}

TEST_CASE("a run is continued after a solve that was not finite as if it had not been stopped", "[runner]") {
  Study study = small_study();
  study.path = path_through({at(0.5, 0.1, 0.4), at(std::nan(""), 0, 0), at(0.5, 0.1, 0.5)});
  ScratchStore scratch;
  for (int i = 0; i < 18; ++i) run_for(study, scratch, 1);
  CHECK(same_numbers(solves_of(scratch, "small"), solve_all(study)));
}

// ---- stop rules, traces, times ------------------------------------------------------------------------------------

TEST_CASE("the trace has the best error after every iteration, and ends with the claim", "[runner]") {
  Study study = study_of_every_solver();  // whose iterations we count; a peer's library has its own
  std::erase_if(study.solvers, [](const SolverEntry& entry) { return !solver(entry.solver).library.empty(); });
  for (const SolveRecord& record : solve_all(study)) CHECK(record.trace_cm.empty());
  study.trace = Trace::best_error;
  for (const SolveRecord& record : solve_all(study)) {
    INFO(record.label);
    CHECK((record.iterations == 5 || record.stop_reason == StopReason::finished));
    REQUIRE(record.trace_cm.size() == static_cast<std::size_t>(record.iterations));
    CHECK(std::is_sorted(record.trace_cm.rbegin(), record.trace_cm.rend()));  // never worse
    CHECK(record.trace_cm.back() == record.reported_error_cm);
  }
}

TEST_CASE("every solve knows its session, and the session its machine and its jobs", "[runner]") {
  ScratchStore scratch;
  Study study = small_study();
  run_for(study, scratch, 4);
  study.rounds = 1;
  study.skipped = {{"theirs", "it was not built"}};
  run(study, scratch, {.jobs = 2});
  const std::vector<results::Session> sessions = scratch.sessions();
  REQUIRE(sessions.size() == 3);  // the rest of the first run, and the second
  CHECK(sessions[0].environment.at("jobs") == "1");
  CHECK(sessions[1].environment.at("jobs") == "2");
  CHECK(sessions[1].environment.at("left_out.theirs") == "it was not built");
  CHECK(sessions[1].environment.at("compiler") == environment().at("compiler"));
  CHECK(sessions[1].environment.at("source") == shared_source_digest());
  CHECK(sessions[1].environment.at("source.bat") == solver_source_digest("bat"));
  std::int64_t in_first = 0;
  for (const SolveRecord& record : solves_of(scratch, "small")) in_first += record.session == sessions[0].id ? 1 : 0;
  CHECK(in_first == 4);
}

TEST_CASE("an unknown robot, solver or option is refused before anything is written", "[runner]") {
  ScratchStore scratch;
  Study study = small_study();
  study.solvers[2].options["alpha"] = "much";
  CHECK_THROWS_AS(run(study, scratch, {}), std::invalid_argument);
  study = small_study();
  study.solvers[2].solver = "none";
  CHECK_THROWS_AS(run(study, scratch, {}), std::invalid_argument);
  study = small_study();
  study.robot = "none";
  CHECK_THROWS_AS(run(study, scratch, {}), std::invalid_argument);
  CHECK(scratch.studies().empty());
  CHECK(scratch.sessions().empty());
}
