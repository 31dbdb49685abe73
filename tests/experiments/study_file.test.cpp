// Study files: written files are read again, and mistakes are reported with their places.
#include "experiments/study/written_fields.hpp"
#include "tests/experiments/samples.hpp"
#include "tests/mistakes.hpp"

namespace {

const std::string solver_entry = "[[solvers]]\nsolver = \"ik_bat\"\n";
// The keys before an entry: an arm and targets.
const std::string arm_and_path = "robot = \"ur5e\"\nsearch = \"pose\"\npath.kind = \"random\"\n";
const std::string planar = "robot = \"planar_2\"\nsearch = \"all_joints\"\n";

std::vector<std::string> keys_of(const Study& study) {
  std::vector<std::string> keys;
  for (const SolverEntry& one : study.solvers) keys.push_back(series_key(study, one));
  return keys;
}

}  // namespace

// ---- round trips --------------------------------------------------------------------------------------------------

TEST_CASE("a built-in study is a file in experiments/studies, which has the study's name", "[study]") {
  std::vector<std::string> files, names;
  for (const auto& entry : std::filesystem::directory_iterator("experiments/studies")) {
    files.push_back(entry.path().stem().string());
    CHECK(load_study(files.back()).name == files.back());
    CHECK(to_toml(load_study(entry.path().string())) == to_toml(load_study(files.back())));
  }
  std::ranges::sort(files);
  for (const Study& study : built_in_studies()) names.push_back(study.name);
  CHECK(names == files);
}

TEST_CASE("every built-in study comes back from its file with the same series", "[study]") {
  for (Study study : built_in_studies()) {
    INFO(study.name);
    study.solvers.back().colour = "#123456";
    Study again = read(to_toml(study));
    CHECK(again.skipped.empty());  // for peers that are not built, the file has only comments
    again.skipped = study.skipped;
    CHECK(keys_of(again) == keys_of(study));
    CHECK(to_toml(again) == to_toml(study));
    CHECK(to_json(again) == to_json(study));
  }
}

TEST_CASE("a stored study is what readers of the store make of its text", "[study]") {
  const auto texts_of = []<class Struct>(Struct fields) {
    std::vector<std::string> texts;
    for (const WrittenField& field : written_fields(fields)) texts.push_back(field.text);
    return texts;
  };
  std::vector<Study> studies = built_in_studies();
  studies.push_back(load_study("tests/data/every-field.toml"));
  for (const Study& study : studies) {
    INFO(study.name);
    const StudyDefinition stored = to_stored(study).definition, again = parse_definition(to_json(study));
    CHECK(stored.json == again.json);
    CHECK(stored.arm == again.arm);
    CHECK(stored.task == again.task);
    CHECK(stored.departures == again.departures);
    CHECK(stored.max_steps == again.max_steps);
    CHECK(stored.points == again.points);
    CHECK(stored.unreachable_targets == again.unreachable_targets);
    CHECK(stored.plan == again.plan);
    CHECK(texts_of(stored.stop) == texts_of(again.stop));
    CHECK(texts_of(static_cast<const StudySpec&>(stored)) == texts_of(static_cast<const StudySpec&>(again)));
  }
}

TEST_CASE("a study in which hardly anything is as by default comes back the same", "[study]") {
  using Json = nlohmann::json;
  const Study study = load_study("tests/data/every-field.toml"), again = read(to_toml(study));
  CHECK(to_toml(again) == to_toml(study));
  CHECK(to_json(again) == to_json(study));
  CHECK(keys_of(again) == keys_of(study));
  const Json read_json = Json::parse(to_json(study)), usual = Json::parse(to_json(read(solver_entry)));
  std::set<std::string> as_usual;
  for (const std::string part : {"", "/analysis", "/stop", "/path"}) {
    for (const auto& [key, value] : usual.at(Json::json_pointer(part)).items())
      if (read_json.at(Json::json_pointer(part)).value(key, Json()) == value) as_usual.insert(key);
  }
  CHECK(as_usual == std::set<std::string>{"kind", "rotation_weight_m", "tolerance_deg", "tolerances"});
  const FigureStyle& style = study.figures;
  CHECK((style.font == "DejaVu Sans" && style.text_pt == 9.5 && style.width_cm == 12.5 && style.height_cm == 7));
  CHECK((style.palette.size() == 2 && style.solvers.front() == "плечо" && style.formats.front() == "pdf"));
}

TEST_CASE("a path of any kind comes back as it was", "[study]") {
  const std::vector<Path> all{path_of({"points=3"}), path_of({"kind=circle", "radius_cm=7.3", "points=9", "tool=eq27"}),
                              path_of({"kind=random", "points=7", "set=edge", "beyond_percent=20"}),
                              path_through({Pose::Identity()})};
  CHECK(all.size() + 2 == target_sets().size());  // poses of a CSV file: pose_csv.test.cpp; a grid: grid.test.cpp
  for (const Path& path : all) {
    Study study = small_study();
    study.path = path;
    INFO(to_toml(study));
    const Study again = read(to_toml(study));
    CHECK(again.path->name() == path->name());
    CHECK(again.path->points() == path->points());
    CHECK(to_toml(again) == to_toml(study));
    CHECK(keys_of(again) == keys_of(study));
    const nlohmann::json json = nlohmann::json::parse(to_json(study));
    CHECK(json["points"] == path->points());
    CHECK(json["path"]["kind"] == path->name());
    CHECK(json["path"].value("targets", "") == (path->is_random() ? "drawn" : ""));
  }
}

TEST_CASE("the poses of Haviland and Corke are NumPy's, and so is their start", "[study][paper]") {
  const Study study = load_study("haviland2023");
  const Robot arm = robot_of(study);
  Random numpy = Random::of_numpy(0, 0), after = Random::of_numpy(0, 60'000);
  for (const int run : {1, 2, 3}) {
    Configuration q(6);
    for (double& angle : q) angle = numpy.uniform(-180 * degree, 180 * degree);
    CHECK(targets_of_run(study, run).front().isApprox(arm.chain.forward(q), 1e-12));
  }
  for (const double angle : study.initial) CHECK(angle == Approx(after.uniform(-180 * degree, 180 * degree)));
  CHECK_THROWS_WITH(load_study("haviland2023", {"path.set=edge"}), ContainsSubstring("anywhere"));
  CHECK_THROWS_WITH(load_study("haviland2023", {"seed=4294967296"}), ContainsSubstring("4294967295"));
  CHECK_THROWS_WITH(load_study("haviland2023", {"stop.tolerance_cm=0", "stop.tolerance_deg=0"}),
                    ContainsSubstring("both tolerances"));
}

TEST_CASE("a study without a name has that of its file", "[study]") {
  const ScratchFolder folder;
  const std::string file = (folder.path / "second.toml").string();
  std::ofstream(file) << arm_and_path + solver_entry;
  CHECK(load_study(file).name == "second");
  std::ofstream(file) << "name = \"mine\"\n" + arm_and_path + solver_entry;
  CHECK(load_study(file).name == "mine");
}

TEST_CASE("poses come back bit for bit, also minus zero and what no number of centimetres gives", "[study]") {
  std::mt19937_64 random(27);
  std::uniform_real_distribution<double> angle(-3.2, 3.2), metre(-2, 2);
  std::vector<Pose> poses;
  for (int i = 0; i < 500; ++i) {
    Pose pose = Pose::Identity();
    pose.linear() = rotation_from_rpy({angle(random), angle(random), angle(random)});
    pose.translation() << metre(random), metre(random), metre(random) * 1e-9;
    poses.push_back(pose);
  }
  Pose minus_zero = Pose::Identity();
  minus_zero.linear()(0, 1) = -0.0;
  minus_zero.translation() << -0.0, 0.1, 5e-324;
  poses.push_back(minus_zero);
  Study study = small_study();
  study.path = path_through(poses);
  const std::vector<Pose> again = targets_of_run(read(to_toml(study)), 1);
  REQUIRE(again.size() == poses.size());
  int different = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (Eigen::Index k = 0; k < 16; ++k) {
      different += same(again[i].matrix().reshaped()[k], poses[i].matrix().reshaped()[k]) ? 0 : 1;
    }
  }
  CHECK(different == 0);
  CHECK(keys_of(read(to_toml(study))) == keys_of(study));
}

TEST_CASE("a pose may say its turn as roll, pitch and yaw, as a matrix, or not at all", "[study]") {
  const std::vector<Pose> poses =
      targets_of_run(read("[path]\nkind = \"poses\"\nposes = [\n"
                          "  { position_cm = [60, 0, 35], rpy_deg = [180, 0, 180] },\n"
                          "  { position_cm = [1, 2, 3], rotation = [0, -1, 0, 1, 0, 0, 0, 0, 1] },\n"
                          "  { position_m = [0.01, 0.02, 0.03] }]\n" +
                          solver_entry),
                     1);
  REQUIRE(poses.size() == 3);
  CHECK(poses[0].linear().isApprox(tool_rotation(ToolOrientation::down), 1e-15));
  CHECK(poses[0].translation().isApprox(Eigen::Vector3d(0.60, 0, 0.35), 1e-15));
  CHECK(poses[1].linear().col(0) == Eigen::Vector3d(0, 1, 0));  // row by row: x becomes y
  CHECK(poses[2].linear() == Eigen::Matrix3d::Identity());
  CHECK(poses[2].translation() == Eigen::Vector3d(0.01, 0.02, 0.03));
}

TEST_CASE("a file that names only a solver is the path and the numbers of Sec. 5.2 with that solver", "[study]") {
  const Study study = read(solver_entry);
  CHECK(study.population == 50);
  CHECK(study.initial == Eigen::VectorXd::Zero(7));
  REQUIRE(study.solvers.size() == 1);
  CHECK(study.solvers[0].label == "ik_bat");
  Study paper = load_study("slim2023-50");
  paper.solvers = study.solvers;
  CHECK(keys_of(study) == keys_of(paper));
}

TEST_CASE("options are numbers, or words in quotes", "[study]") {
  const Study study = read(solver_entry + "options = { alpha = 0.5, loudness = 2, f_max = 1.5, bounds = \"clamp\" }\n");
  const Settings options = effective_options(study, study.solvers[0]);
  CHECK(text_of(options.at("alpha")) == "0.5");
  CHECK(text_of(options.at("loudness")) == "2");
  CHECK(text_of(options.at("f_max")) == "1.5");
  CHECK(text_of(options.at("bounds")) == "clamp");
  CHECK_THROWS_WITH(read(solver_entry + "options = { f_max = \"1.5\" }\n"),
                    ContainsSubstring("f_max is \"1.5\"; expected a number, without quotes: 1.5"));
}

TEST_CASE("as JSON a study says what its arm is made of", "[study]") {
  using Json = nlohmann::json;
  const Json still{{"position_m", {0.0, 0.0, 0.0}}, {"rpy_deg", {0.0, 0.0, 0.0}}};
  const Json iiwa = Json::parse(to_json(load_study("slim2023")))["arm"];
  REQUIRE(iiwa["links"].size() == 7);
  CHECK(iiwa["links"][2] == Json::parse(R"({"joint": "turns", "offset_deg": 0.0, "d_m": 0.42, "a_m": 0.0,
    "alpha_deg": 90.0, "limits_deg": [-170.0, 170.0]})"));  // Table 2
  CHECK(iiwa["base"] == still);
  CHECK(iiwa["tool"] == still);
}

TEST_CASE("a study's arm may be a file in the study's folder, and for --set in the current one", "[study][arm]") {
  const ScratchFolder folder;
  write_text(
      folder.path / "slider.toml",
      "links = [{ a_m = 0.5 }, { joint = \"slides\", limits_m = [0.125, 0.5] }]\ntool = { rpy_deg = [0, 90, 0] }\n");
  const std::string file = (folder.path / "study.toml").string();
  write_text(file, "robot = \"slider.toml\"\nsearch = \"all_joints\"\npath.kind = \"helix\"\n" + solver_entry);
  const Study study = load_study(file);
  CHECK(study.robot == "slider.toml");
  CHECK(robot_of(study).name == "slider");
  CHECK(robot_of(study).joints() == 2);
  CHECK(study.initial == Eigen::Vector2d(0, 0.125));  // as near to zeros as the limits allow

  // Degrees for a revolute joint, and metres for a prismatic one, are written and read again.
  const std::string slide = (folder.path / "slider.toml").string();
  const Study placed =
      read("robot = '" + slide + "'\nsearch = \"all_joints\"\ninitial_deg = [45, 0.3]\n" + solver_entry);
  CHECK(placed.initial == Eigen::Vector2d(45 * (std::numbers::pi / 180), 0.3));
  CHECK(nlohmann::json::parse(to_json(placed))["initial_deg"] == std::vector<double>{45, 0.3});
  CHECK(contains(to_toml(placed), "initial_deg = [45, 0.3]"));
  CHECK(contains(
      statements_of("robot = '" + slide + "'\nsearch = \"all_joints\"\ninitial_deg = [0, 0.6]\n" + solver_entry),
      "initial_deg is 0.1 m outside the limits of joint 2"));
  const nlohmann::json arm = nlohmann::json::parse(to_json(study))["arm"];
  CHECK(arm["links"][1]["joint"] == "slides");
  CHECK(arm["links"][1]["limits_m"] == std::vector<double>{0.125, 0.5});
  CHECK(arm["tool"]["rpy_deg"] == std::vector<double>{0, 90, 0});

  const std::string other = (folder.path / "slider.toml").string();
  CHECK(keys_of(read(planar + solver_entry, {"robot=" + other})) == keys_of(study));
  CHECK(contains(statements_of(planar + solver_entry, {"robot=slider.toml"}),
                 "--set robot: there is no file slider.toml"));
  CHECK(statements_of("search = \"wrist\"\n" + solver_entry, {"robot=" + other}).find("has no spherical wrist") !=
        std::string::npos);

  // The numbers of an arm decide the series, not the name of the arm.
  write_text(folder.path / "same.toml",
             "# the same\nlinks = [{ a_m = 0.50 }, { joint = 'slides', limits_m = [0.125, 0.5] }]\n"
             "[tool]\nrpy_deg = [0, 90, 0]\n");
  CHECK(keys_of(load_study(file, {"robot=" + (folder.path / "same.toml").string()})) == keys_of(study));
  write_text(other, "links = [{ a_m = 0.5 }, { joint = \"slides\", limits_m = [0.125, 0.5] }]\n");
  CHECK(keys_of(load_study(file)) != keys_of(study));
  CHECK(robot_of(study).chain.tool().rpy.y() == std::numbers::pi / 2);  // read once

  write_text(other, "links = [\n  { a_m = 500 },\n]\n");
  CHECK(complaint<std::invalid_argument>([&] {
          load_study(file);
        }).starts_with(other + ":2:11: links.a_m is 500; expected a number from -100 to 100"));
}

TEST_CASE("a study's arm may be a URDF file, read as its table urdf says", "[study][arm]") {
  const std::string robot = "robot=" + std::filesystem::absolute("tests/data/urdf/iiwa14.urdf").string();
  const Study hard = read(solver_entry, {robot});
  const Study soft = read(solver_entry, {robot, "urdf.limits=soft", "urdf.base=link_1", "urdf.tip=tool"});
  CHECK(robot_of(hard).joints() == 7);
  CHECK(robot_of(soft).joints() == 6);
  CHECK(soft.urdf.limits == UrdfChoice::Limits::soft);
  CHECK(keys_of(hard) != keys_of(soft));
  const nlohmann::json json = nlohmann::json::parse(to_json(soft));
  CHECK(json["arm"]["links"][0]["name"] == "A2");
  CHECK(json["urdf"]["base"] == "link_1");
  CHECK_FALSE(nlohmann::json::parse(to_json(read(solver_entry))).contains("urdf"));
  CHECK(keys_of(parse_study(to_toml(soft), "again")) == keys_of(soft));
  CHECK(contains(statements_of(solver_entry, {robot, "urdf.tip=tol"}),
                 "tip is \"tol\", which is not a link; did you mean \"tool\"?"));
  CHECK(contains(statements_of(solver_entry, {robot, "urdf.snap_deg=0"}), "the arm is taken as the file has it"));
  const std::string rounded = std::filesystem::absolute("tests/data/urdf/gen3.urdf").string();
  CHECK(contains(statements_of("search = \"wrist\"\n" + solver_entry, {"robot=" + rounded}),
                 "0.35 mm from a common point and 0.00021 deg from right angles; expected \"all_joints\""));
  // The angles of axes that are almost parallel are stored only if there are some.
  const Study calibrated = read("search = \"pose\"\n" + solver_entry,
                                {"robot=" + std::filesystem::absolute("tests/data/urdf/ur5_calibrated.urdf").string()});
  const nlohmann::json stored = nlohmann::json::parse(to_json(calibrated))["arm"];
  CHECK(stored["links"][1].contains("beta_deg"));
  CHECK_FALSE(json["arm"]["links"][1].contains("beta_deg"));
  CHECK(robots::stored_arm(stored.dump())->chain.definition() == robot_of(calibrated).chain.definition());
}

TEST_CASE("a study says how it will be judged, by default by ranks at 5 %, the paper's studies by means",
          "[study][analysis]") {
  const Study study = read(solver_entry);
  CHECK(study.plan == AnalysisPlan());
  CHECK(nlohmann::json::parse(to_json(study))["analysis"] ==
        nlohmann::json::parse(R"({"test": "ranks", "values": "runs", "metric": "", "control": "", "significance": 0.05,
          "margin_percent": 5.0, "deadline_ms": 0.0, "tie_breakers": ["time", "evaluations"]})"));
  for (const Study& built_in : built_in_studies()) {
    INFO(built_in.name);
    CHECK(built_in.plan == (built_in.name.starts_with("slim2023")
                                ? AnalysisPlan{.test = AnalysisPlan::Test::means, .tie_breakers = {}}
                                : AnalysisPlan()));
    CHECK(contains(to_toml(built_in), "\n[analysis]"));
  }
}

TEST_CASE("--set changes the table of the analysis as it does other fields", "[study][analysis]") {
  const Study study = read(solver_entry + "label = \"A\"\n", {"analysis.significance=0.01", "analysis.control=A"});
  CHECK(study.plan == AnalysisPlan{.control = "A", .significance = 0.01});
}

// ---- mistakes -----------------------------------------------------------------------------------------------------

TEST_CASE("a mistake in a study file is told with its place, its value and what was expected", "[study][mistakes]") {
  check_mistakes(
      "study", "my.toml:", [](const std::string& text) { read(text); }, solver_entry);
  for (const std::string& bytes : {std::string("\xff\xfe\x00", 3),
                                   std::string("\x7f"
                                               "ELF\x02\x01\x01"),
                                   "runs = 3\n" + std::string(3, 0)})
    CHECK(statements_of(bytes + solver_entry).starts_with("my.toml:"));
}

TEST_CASE("what is as good as what a mistake nearly was is read", "[study]") {
  CHECK(read(solver_entry, {"figures.text_pt=10"}).figures.text_pt == 10);
  CHECK(read(solver_entry, {"ik_bat.colour=#8D1804"}).solvers[0].colour == "#8D1804");
  CHECK(read("limits = \"enforced\"\ninitial_deg = [0, 120, 0, -120, 0, 0, 175]\n" + solver_entry).limits ==
        LimitPolicy::enforced);
  CHECK(read("name = \"" + std::string(200, 'x') + "\"\n" + solver_entry).name.size() == 200);
  const std::string much = statements_of("name = \"" + std::string(100'000, 'x') + "\"\n" + solver_entry);
  CHECK(contains(much, "x\"; expected a text of at most 200 bytes without control characters"));
  CHECK(much.size() < 300);
  const std::string pose = "robot = \"ur5e\"\nsearch = \"pose\"\n";
  const Study study =
      read(pose + "rotation_weight_m = 0.1\n[stop]\ntolerance_cm = 0.01\ntolerance_deg = 0.5\n" + solver_entry);
  CHECK(study.search == Search::pose);
  CHECK(study.rotation_weight == 0.1);
  CHECK(study.stop.angle_tolerance == Approx(0.5 * degree));
  CHECK(read(to_toml(study)).stop.angle_tolerance == study.stop.angle_tolerance);
  CHECK(read(pose + solver_entry).stop.angle_tolerance == 0);
}

TEST_CASE("nesting deeper than anyone means is refused, not followed to the end of the stack", "[study][mistakes]") {
  const auto repeated = [](const std::string& piece, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += piece;
    return text;
  };
  for (const std::string& text : {"a = " + repeated("[", 100'000), "a = " + repeated("{a = ", 100'000)})
    CHECK(contains(statements_of(text), "not TOML"));
  for (const std::string& text : {"a" + repeated(".a", 100'000) + " = 1\n", "\n[a" + repeated(". a", 100'000) + "]\n"})
    CHECK(contains(statements_of(text), "expected less deeply nested keys"));
  CHECK(contains(statements_of(repeated("a.", 400) + "a = 1\n" + solver_entry), "unknown key \"a\""));
}

TEST_CASE("a study that lacks its arm or its path's kind is refused, and --set path.kind leaves the file's kind behind",
          "[study][mistakes]") {
  const auto said = [](const std::string& text) {
    return complaint<std::invalid_argument>([&] { parse_study(text, "my.toml"); });
  };
  CHECK(said("path.kind = \"random\"\n" + solver_entry).starts_with("my.toml:1:1: robot is missing; expected "));
  CHECK(said("robot = \"ur5e\"\n[path]\npoints = 3\n" + solver_entry).starts_with("my.toml:2:1: path.kind is missing"));
  const std::string helix = "robot = 'kuka_iiwa14'\n[path]\nkind = 'helix'\nturns = 3\npoints = 7\n" + solver_entry;
  CHECK(read(helix, {"path.kind=random"}).path->points() == 7);
  CHECK(contains(statements_of(helix, {"path.kind=random", "path.turns=2"}), "unknown key \"turns\""));
  if (missing_peers().empty())
    CHECK(contains(statements_of("[[solvers]]\nsolver = 'trac_ik'\n"),
                   "unknown solver \"trac_ik\"; did you mean \"newton_slsqp\""));
}

TEST_CASE("a file of more than 10 MB is not read", "[study][mistakes]") {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.path / "large.toml";
  write_text(file, solver_entry + "# " + std::string(10'000'000, 'x'));
  CHECK(contains(complaint<std::invalid_argument>([&] { load_study(file.string()); }), "at most 10 MB"));
  write_text(file, arm_and_path + solver_entry + "# " + std::string(1'000'000, 'x'));
  CHECK(load_study(file.string()).solvers.size() == 1);
}

TEST_CASE("a study is a built-in name or a file, and anything else is told the names, or where they are",
          "[study][mistakes]") {
  const ScratchFolder folder;
  const std::string file = (folder.path / "none.toml").string(), names = "ikbench list studies";
  const auto says = [](const std::string& none, const std::string& what, const std::string& where) {
    const std::string message = complaint<std::invalid_argument>([&] { load_study(none); });
    INFO(message);
    CHECK(contains(message, what));
    CHECK(contains(message, where));
  };
  for (const char* none : {"slim2032", ""}) says(none, "no such file", "slim2023-context");
  says(file, "there is no file " + file + ";", names);
  says("/dev/zero", "/dev/zero is not a regular file", "");
  says(folder.path.string(), folder.path.string() + " is a folder; expected a TOML file", names);
  says("slim2032", "no such file", "did you mean \"slim2023\"?");
}

TEST_CASE("a study without a path has the protocol of any arm, but for what it says", "[study]") {
  const std::string ours = "robot = \"ur10e\"\nruns = 7\nstop.evaluations = 500\n" + solver_entry;
  const Study any = load_study("any-arm"), study = parse_study(ours, "my.toml");
  CHECK(study.name == "my");
  CHECK(study.robot == "ur10e");
  CHECK(study.solvers.size() == 1);
  CHECK(study.runs == 7);
  CHECK(study.stop.evaluations == 500);
  CHECK(study.stop.tolerance == any.stop.tolerance);
  CHECK(study.path->name() == any.path->name());
  CHECK(study.search == any.search);
  CHECK(study.limits == any.limits);
  CHECK(study.notes.size() == 1);
  CHECK(parse_study(ours, "my.toml", {"path.points=3", "stop.evaluations=600"}).path->points() == 3);
  CHECK(parse_study(ours, "my.toml", {"path.kind=random", "search=all_joints"}).limits == Study{}.limits);
  const std::string chained = "robot = \"ur5e\"\nsearch = \"all_joints\"\n" + solver_entry;
  CHECK_NOTHROW(parse_study(chained, "my.toml"));  // without a tolerance of turns, which it has not
}

// ---- overrides ----------------------------------------------------------------------------------------------------

TEST_CASE("where evaluations limit a solve, iterations do not, unless the study says so", "[study]") {
  const auto iterations = [](const std::string& stop) {
    return read(arm_and_path + stop + solver_entry).stop.iterations;
  };
  CHECK(iterations("") == 200);
  CHECK(iterations("stop.evaluations = 0\n") == 200);
  CHECK(iterations("stop.evaluations = 4000\n") == 4000);
  CHECK(iterations("stop.evaluations = 4000\nstop.iterations = 30\n") == 30);
  CHECK(iterations("stop.evaluations = 9000000000000\n") == 1'000'000'000);
  const auto of_any_arm = [](const std::string& stop) {
    return parse_study("robot = \"ur5e\"\n" + stop + solver_entry, "my.toml").stop;
  };
  CHECK(of_any_arm("").iterations == 10000);
  CHECK(of_any_arm("stop.evaluations = 40000\n").iterations == 40000);
}

TEST_CASE("an override sets a field of the study, of its path or of its stop rule", "[study][set]") {
  const Study study = load_study("slim2023", {"runs=5", "path.tool=eq27", "path.points=7", "stop.tolerance_cm=0.1",
                                              "search=\"all_joints\"", "initial_deg=[1, 2, 3, 4, 5, 6, 7]"});
  CHECK(study.runs == 5);
  CHECK(targets_of_run(study, 1)[0].linear() == tool_rotation(ToolOrientation::eq27));
  CHECK(study.path->points() == 7);
  CHECK(study.stop.tolerance == Approx(0.001));
  CHECK(study.search == Search::all_joints);
  CHECK(study.initial[6] == Approx(7 * std::numbers::pi / 180));
}

TEST_CASE("an override sets an option of the solvers with that label or that solver", "[study][set]") {
  const std::string two =
      solver_entry + "label = \"A\"\n" + solver_entry + "label = \"B v1.0\"\noptions = { gamma = 0.5 }\n";
  Study study = read(two, {"A.alpha=0.25"});
  CHECK(study.solvers[0].options == Settings{{"alpha", 0.25}});
  CHECK(study.solvers[1].options == Settings{{"gamma", 0.5}});
  study = read(two, {"ik_bat.alpha=0.25"});
  CHECK(study.solvers[0].options == Settings{{"alpha", 0.25}});
  CHECK(study.solvers[1].options == Settings{{"alpha", 0.25}, {"gamma", 0.5}});
  study = read(two, {"B v1.0.gamma=0.75"});  // a label with a dot and a space
  CHECK(study.solvers[1].options == Settings{{"gamma", 0.75}});
}

TEST_CASE("an override sets a solver's own population, by its label or its solver's name", "[study][set]") {
  const auto populations_of = [](const Overrides& overrides) {
    std::vector<int> found;
    for (const SolverEntry& one : load_study("slim2023-time", overrides).solvers) found.push_back(one.population);
    return found;
  };
  CHECK(populations_of({"12 bats.population=16"}) == std::vector<int>{16, 15, 20, 30});
  CHECK(populations_of({"ik_bat.population=16"}) == std::vector<int>{16, 16, 16, 16});
}

TEST_CASE("a kind of path in an override has that kind's keys", "[study][set]") {
  CHECK(read(solver_entry, {"path.kind=random", "path.points=3"}).path->points() == 3);
  CHECK(statements_of(solver_entry, {"path.kind=random", "path.tool=down"})
            .starts_with("--set path.tool: unknown key \"tool\""));
}

TEST_CASE("the text of an override is taken as it is typed, quotes or not", "[study][set]") {
  CHECK(read(solver_entry, {"title=two words"}).title == "two words");
  CHECK(read(solver_entry, {"title=  spaces around "}).title == "  spaces around ");
  CHECK(read(solver_entry, {"title=\"in quotes\""}).title == "in quotes");
  CHECK(read(solver_entry, {"title='it\"s'"}).title == "it\"s");
  CHECK(read(solver_entry, {"title=it's"}).title == "it's");
  CHECK(read(solver_entry, {"title=a=b"}).title == "a=b");
  CHECK(read(solver_entry, {"title=$(touch pwned)`touch pwned`"}).title == "$(touch pwned)`touch pwned`");
  CHECK(read(solver_entry, {"title=#1"}).title == "#1");
  CHECK(read(solver_entry, {"title="}).title.empty());
}

TEST_CASE("a mistake in an override is reported as that of --set, not of the file", "[study][set][mistakes]") {
  check_mistakes("set", "--set ", [](const std::string& override) { read(solver_entry, {override}); });
}

TEST_CASE("a mistake in another option is reported as that option's", "[study][set][mistakes]") {
  CHECK(statements_of(solver_entry, {"--robot robot=ur5f"}).starts_with("--robot: unknown robot"));
  CHECK(statements_of(solver_entry, {"--tip urdf.tip=tool0"}).starts_with("--tip: [urdf] is only"));
  CHECK(statements_of(solver_entry, {"--sweep ik_bat.alpha=[7, ]"}).starts_with("--sweep: "));
}

TEST_CASE("an override is key=value", "[study][set][mistakes]") {
  for (const std::string malformed : {"", "=", "=3", "runs", "runs 5", ".alpha=0.5", "ik_bat.=0.5", "."}) {
    INFO(malformed);
    const std::string message = statements_of(solver_entry, {malformed});
    INFO(message);
    CHECK(message.starts_with("--set"));
    CHECK(contains(message, "expected"));
  }
  CHECK(statements_of(solver_entry, {std::string(100'000, 'a') + "=1"}).size() < 400);
  CHECK(statements_of(solver_entry, {"a" + std::string(100'000, '.') + "b=1"}).size() < 400);
  CHECK(statements_of(solver_entry, {"title=" + std::string(100'000, '[')}).size() < 400);
  CHECK(contains(statements_of(solver_entry, {"path=3", "path.points=3"}), "--set path"));
}
