// Study files: written files are read again, and mistakes are reported with their places.

#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "experiments/orientation.hpp"
#include "solvers/registry.hpp"
#include "tests/contains.hpp"
#include "tests/experiments/samples.hpp"
#include "tests/sources.hpp"

namespace {

// The complaint about a file, or "" if it is a study.
std::string said_of(const std::string& toml, const Overrides& overrides = {}) {
  return complaint<std::invalid_argument>([&] { parse_study(toml, "my.toml", overrides); });
}

const std::string solver_entry = "[[solvers]]\nsolver = \"ik_bat\"\n";
const std::string planar = "robot = \"planar_2\"\nsearch = \"all_joints\"\n";

Study read(const std::string& toml, const Overrides& overrides = {}) { return parse_study(toml, "my.toml", overrides); }

std::vector<std::string> keys_of(const Study& study) {
  std::vector<std::string> keys;
  for (const SolverEntry& one : study.solvers) keys.push_back(series_key(study, one));
  return keys;
}

// A file, and the complaint that it must get.
struct Mistake {
  std::string toml;
  std::string starts;
  std::vector<std::string> has;
};

void check(const std::vector<Mistake>& mistakes) {
  for (const Mistake& mistake : mistakes) {
    const std::string message = said_of(mistake.toml);
    INFO(mistake.toml.substr(0, 200));
    INFO(message);
    CHECK(message.starts_with(mistake.starts));
    for (const std::string& part : mistake.has) {
      INFO(part);
      CHECK(contains(message, part));
    }
    CHECK_FALSE(contains(message, "\n"));
  }
}

std::vector<std::string> split(std::string text, const std::string& separator) {
  std::vector<std::string> parts;
  for (std::size_t end; (end = text.find(separator)) != std::string::npos; text.erase(0, end + separator.size()))
    parts.push_back(text.substr(0, end));
  parts.push_back(text);
  return parts;
}

// A mistake a line, "FILE => PLACE => WORDS => WORDS": in the file | ends a line, and @ is `solver_entry`.
void check(const std::string& table) {
  std::vector<Mistake> mistakes;
  for (const std::string& line : split(table, "\n")) {
    if (line.empty()) continue;
    const std::vector<std::string> parts = split(line, " => ");
    REQUIRE(parts.size() >= 2);
    std::string toml;
    for (const char c : parts[0]) toml += c == '|' ? "\n" : c == '@' ? solver_entry : std::string(1, c);
    mistakes.push_back({toml, "my.toml:" + parts[1], {parts.begin() + 2, parts.end()}});
  }
  check(mistakes);
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
  for (const Study& study : studies()) names.push_back(study.name);
  CHECK(names == files);
}

TEST_CASE("every built-in study comes back from its file with the same series", "[study]") {
  for (Study study : studies()) {
    INFO(study.name);
    study.solvers.back().colour = "#123456";
    Study again = read(to_toml(study));
    CHECK(again.left_out.empty());  // for peers that are not built, the file has only comments
    again.left_out = study.left_out;
    CHECK(keys_of(again) == keys_of(study));
    CHECK(again.name == study.name);
    CHECK(again.figures == study.figures);
    CHECK(again.solvers.back().colour == "#123456");
    CHECK(again.title == study.title);
    CHECK(again.published == study.published);
    CHECK(again.runs == study.runs);
    CHECK(to_toml(again) == to_toml(study));
    CHECK(to_json(again) == to_json(study));
  }
}

TEST_CASE("the study of the paper has its numbers: 50 bats, 200 iterations, 20 runs of 20 points", "[study][paper]") {
  const Study study = load_study("slim2023");  // Sec. 5.2
  CHECK(study.population == 50);
  CHECK(study.stop.iterations == 200);
  CHECK(study.runs == 20);
  CHECK(study.path->points() == 20);
  CHECK(study.robot == "kuka_iiwa14");
  CHECK(labels_of(study) == std::vector<std::string>{"IK-BA", "BA", "DE", "PSO", "K-ABC", "MO-PSO"});  // Table 3
}

TEST_CASE("a study in which nothing is as by default comes back the same", "[study]") {
  Study study;
  study.name = "every field";
  study.title = "\"quoted\" 'quoted' \\ # no comment, = no key, Ünïcödé 关节 $x_1$";
  study.published = "slim2023";
  study.robot = "planar_3";
  study.search = Search::all_joints;
  study.bounds = StudyBounds::clamp;
  study.wrist_branch = WristBranch::negative;
  study.limits = Limits::enforced;
  study.start = Start::initial;
  study.near = 0.25;
  study.initial = Eigen::Vector3d(10, -20.5, 1.0 / 3) * (std::numbers::pi / 180);
  study.population = 7;
  study.stop = {.iterations = 13, .tolerance = 0.001, .evaluations = 9'000'000'000'000, .seconds = 0.25};
  study.runs = 3;
  study.repeats = 2;
  study.seed = 9'223'372'036'854'775'807;  // the largest integer of TOML
  study.trace = Trace::best_error;
  study.path = path_of({"centre_cm=[50, -25, 1]", "radius_cm=30", "length_cm=-10", "turns=1.5", "start_deg=90",
                        "points=9", "phase=cos_sin", "spacing=k_over_n_minus_1", "tool=eq27"});
  study.solvers = {
      {"a \"label\" with 'quotes' = [x] . # \\", "ik_bat", {{"acceptance", "yang2020"}, {"alpha", "0.25"}}},
      {"плечо", "bat", {}, 12}};
  study.plan = {.test = Plan::Test::means,
                .metric = "seconds",
                .control = "плечо",
                .significance = 0.001,
                .margin = 1.0 / 3,
                .margin_cm = 0.25};
  study.figures = {.width_cm = 12.5,
                   .height_cm = 7,
                   .font = "DejaVu Sans",
                   .text_pt = 9.5,
                   .palette = {"#000000", "#ABCDEF"},
                   .solvers = {"плечо", study.solvers[0].label},
                   .formats = {Picture::pdf}};
  study.solvers[1].colour = "#123456";
  const Study again = read(to_toml(study));
  CHECK(to_toml(again) == to_toml(study));
  CHECK(to_json(again) == to_json(study));
  CHECK(keys_of(again) == keys_of(study));
  CHECK(again.plan == study.plan);
  CHECK(again.title == study.title);
  CHECK(again.seed == study.seed);
  CHECK(again.stop.evaluations == study.stop.evaluations);
  CHECK(again.solvers[0].label == study.solvers[0].label);
  CHECK(again.solvers[0].options == study.solvers[0].options);
  CHECK(again.solvers[0].population == 0);
  CHECK(again.solvers[1].population == 12);
}

TEST_CASE("a path of any kind comes back as it was", "[study]") {
  const std::vector<Path> all{path_of({"points=3"}), path_of({"kind=circle", "radius_cm=7.3", "points=9", "tool=eq27"}),
                              path_of({"kind=random", "points=7", "set=edge", "beyond_percent=20"}),
                              path_through({Pose::Identity()})};
  CHECK(all.size() + 1 == paths().size());  // poses of a CSV file: pose_csv.test.cpp
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
    CHECK(json["path"].value("targets", "") == (path->is_drawn() ? "drawn" : ""));
  }
}

TEST_CASE("the study of Table 7: 12 to 30 bats to 0.1 cm at 20 random targets, each from the start", "[study][paper]") {
  const Study study = load_study("slim2023-time");
  std::vector<int> bats;
  for (const SolverEntry& one : study.solvers) {
    CHECK(one.solver == "ik_bat");
    CHECK(one.label == std::to_string(one.population) + " bats");
    bats.push_back(effective_population(study, one));
  }
  CHECK(bats == std::vector<int>{12, 15, 20, 30});
  CHECK(study.stop.tolerance == 0.001);
  CHECK(study.stop.iterations == 1000);
  CHECK(study.start == Start::initial);
  CHECK(study.path->is_drawn());
  CHECK(study.path->points() == 20);
  CHECK(study.search == Search::wrist);
}

TEST_CASE("a study without a name has that of its file", "[study]") {
  const ScratchFolder folder;
  const std::string file = (folder.path / "second.toml").string();
  std::ofstream(file) << solver_entry;
  CHECK(load_study(file).name == "second");
  std::ofstream(file) << "name = \"mine\"\n" + solver_entry;
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
  const std::vector<Pose> again = targets(read(to_toml(study)), 1);
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
      targets(read("[path]\nkind = \"poses\"\nposes = [\n"
                   "  { position_cm = [60, 0, 35], rpy_deg = [180, 0, 180] },\n"
                   "  { position_cm = [1, 2, 3], rotation = [0, -1, 0, 1, 0, 0, 0, 0, 1] },\n"
                   "  { position_m = [0.01, 0.02, 0.03] }]\n" +
                   solver_entry),
              1);
  REQUIRE(poses.size() == 3);
  CHECK(poses[0].linear().isApprox(rotation(Tool::down), 1e-15));
  CHECK(poses[0].translation().isApprox(Eigen::Vector3d(0.60, 0, 0.35), 1e-15));
  CHECK(poses[1].linear().col(0) == Eigen::Vector3d(0, 1, 0));  // row by row: x becomes y
  CHECK(poses[2].linear() == Eigen::Matrix3d::Identity());
  CHECK(poses[2].translation() == Eigen::Vector3d(0.01, 0.02, 0.03));
}

TEST_CASE("a file that names only a solver is the paper's path and numbers with that solver", "[study]") {
  const Study study = read(solver_entry);
  CHECK(study.population == 50);
  CHECK(study.initial == Eigen::VectorXd::Zero(7));
  REQUIRE(study.solvers.size() == 1);
  CHECK(study.solvers[0].label == "ik_bat");
  Study paper = load_study("slim2023");
  paper.solvers = study.solvers;
  CHECK(keys_of(study) == keys_of(paper));
}

TEST_CASE("options are numbers, or words in quotes", "[study]") {
  const Study study = read(solver_entry + "options = { alpha = 0.5, loudness = 2, f_max = 1.5, bounds = \"clamp\" }\n");
  const Settings options = effective_options(study, study.solvers[0]);
  CHECK(options.at("alpha") == "0.5");
  CHECK(options.at("loudness") == "2");
  CHECK(options.at("f_max") == "1.5");
  CHECK(options.at("bounds") == "clamp");
  CHECK_THROWS_WITH(read(solver_entry + "options = { f_max = \"1.5\" }\n"),
                    ContainsSubstring("f_max is \"1.5\"; expected a number, without quotes: 1.5"));
}

TEST_CASE("as JSON a study says its fields and its number of points", "[study]") {
  const nlohmann::json json = nlohmann::json::parse(to_json(load_study("slim2023")));
  CHECK(json["points"] == 20);
  CHECK(json["runs"] == 20);
  CHECK(json["robot"] == "kuka_iiwa14");
  CHECK(json["path"]["radius_cm"] == 20);  // Sec. 5.2
  CHECK(json["path"]["tool"] == "down");
  CHECK(json["stop"]["iterations"] == 200);
}

TEST_CASE("as JSON a study says what its arm is made of", "[study]") {
  using Json = nlohmann::json;
  const Json still{{"position_m", {0.0, 0.0, 0.0}}, {"rpy_deg", {0.0, 0.0, 0.0}}};
  const Json iiwa = Json::parse(to_json(load_study("slim2023")))["arm"];
  REQUIRE(iiwa["links"].size() == 7);
  CHECK(iiwa["links"][2] == Json{{"joint", "turns"},
                                 {"offset_deg", 0.0},
                                 {"d_m", 0.42},
                                 {"a_m", 0.0},
                                 {"alpha_deg", 90.0},
                                 {"limits_deg", {-170.0, 170.0}}});  // Table 2
  CHECK(iiwa["base"] == still);
  CHECK(iiwa["tool"] == still);

  const Json dobot =
      Json::parse(to_json(read("robot = \"dobot_magician\"\nsearch = \"all_joints\"\n" + solver_entry)))["arm"];
  REQUIRE(dobot["links"].size() == 3);
  CHECK(dobot["links"][2] == Json{{"joint", "coupled"},
                                  {"offset_deg", 0.0},
                                  {"d_m", 0.0},
                                  {"a_m", 0.147},
                                  {"alpha_deg", 0.0},
                                  {"limits_deg", {-10.0, 95.0}}});
  CHECK(dobot["tool"]["position_m"] == Json{0.061, 0.0, 0.0});
}

TEST_CASE("a study's arm may be a file in the study's folder, and for --set in the current one", "[study][arm]") {
  const ScratchFolder folder;
  write_text(
      folder.path / "slider.toml",
      "links = [{ a_m = 0.5 }, { joint = \"slides\", limits_m = [0.125, 0.5] }]\ntool = { rpy_deg = [0, 90, 0] }\n");
  const std::string file = (folder.path / "study.toml").string();
  write_text(file, "robot = \"slider.toml\"\nsearch = \"all_joints\"\n" + solver_entry);
  const Study study = load_study(file);
  CHECK(study.robot == "slider.toml");
  CHECK(arm_of(study).name == "slider");
  CHECK(arm_of(study).joints() == 2);
  CHECK(study.initial == Eigen::Vector2d(0, 0.125));  // as near to zeros as the limits allow

  // Degrees, and metres for a slide, there and back.
  const std::string slide = (folder.path / "slider.toml").string();
  const Study placed =
      read("robot = '" + slide + "'\nsearch = \"all_joints\"\ninitial_deg = [45, 0.3]\n" + solver_entry);
  CHECK(placed.initial == Eigen::Vector2d(45 * (std::numbers::pi / 180), 0.3));
  CHECK(nlohmann::json::parse(to_json(placed))["initial_deg"] == std::vector<double>{45, 0.3});
  CHECK(contains(to_toml(placed), "initial_deg = [45, 0.3]"));
  CHECK(contains(said_of("robot = '" + slide +
                         "'\nsearch = \"all_joints\"\nlimits = \"enforced\"\ninitial_deg = [0, 0.6]\n" + solver_entry),
                 "initial_deg is 0.1 m outside the limits of joint 2"));
  const nlohmann::json arm = nlohmann::json::parse(to_json(study))["arm"];
  CHECK(arm["links"][1]["joint"] == "slides");
  CHECK(arm["links"][1]["limits_m"] == std::vector<double>{0.125, 0.5});
  CHECK(arm["tool"]["rpy_deg"] == std::vector<double>{0, 90, 0});

  const std::string other = (folder.path / "slider.toml").string();
  CHECK(keys_of(read(planar + solver_entry, {"robot=" + other})) == keys_of(study));
  CHECK(contains(said_of(planar + solver_entry, {"robot=slider.toml"}), "--set robot: there is no file slider.toml"));
  CHECK(said_of("robot = \"none.toml\"\n" + solver_entry)
            .starts_with("my.toml:1:9: there is no file none.toml; expected"));
  CHECK(said_of("robot = \"/\"\n" + solver_entry).starts_with("my.toml:1:9: \"/\" is no arm"));
  CHECK(said_of("search = \"wrist\"\n" + solver_entry, {"robot=" + other}).find("has no spherical wrist") !=
        std::string::npos);

  // The numbers of the arm decide the series, its name does not.
  write_text(folder.path / "same.toml",
             "# the same\nlinks = [{ a_m = 0.50 }, { joint = 'slides', limits_m = [0.125, 0.5] }]\n"
             "[tool]\nrpy_deg = [0, 90, 0]\n");
  CHECK(keys_of(load_study(file, {"robot=" + (folder.path / "same.toml").string()})) == keys_of(study));
  write_text(other, "links = [{ a_m = 0.5 }, { joint = \"slides\", limits_m = [0.125, 0.5] }]\n");
  CHECK(keys_of(load_study(file)) != keys_of(study));
  CHECK(arm_of(study).chain.tool().rpy.y() == std::numbers::pi / 2);  // read once

  write_text(other, "links = [\n  { a_m = 500 },\n]\n");
  CHECK(complaint<std::invalid_argument>([&] {
          load_study(file);
        }).starts_with(other + ":2:11: links.a_m is 500; expected a number from -100 to 100"));
}

TEST_CASE("a study's arm may be a URDF file, read as its table urdf says", "[study][arm]") {
  const std::string robot = "robot=" + std::filesystem::absolute("tests/data/urdf/iiwa14.urdf").string();
  const Study hard = read(solver_entry, {robot});
  const Study soft = read(solver_entry, {robot, "urdf.limits=soft", "urdf.base=link_1", "urdf.tip=tool"});
  CHECK(arm_of(hard).joints() == 7);
  CHECK(arm_of(soft).joints() == 6);
  CHECK(soft.urdf.limits == UrdfChoice::Limits::soft);
  CHECK(keys_of(hard) != keys_of(soft));
  const nlohmann::json json = nlohmann::json::parse(to_json(soft));
  CHECK(json["arm"]["links"][0]["name"] == "A2");
  CHECK(json["urdf"]["base"] == "link_1");
  CHECK_FALSE(nlohmann::json::parse(to_json(read(solver_entry))).contains("urdf"));
  CHECK(keys_of(parse_study(to_toml(soft), "again")) == keys_of(soft));
  CHECK(said_of("[urdf]\ntip = \"tool0\"\n" + solver_entry) ==
        "my.toml:1:1: [urdf] is about a URDF file, but robot is \"kuka_iiwa14\"; expected one such as \"my_arm.urdf\"");
  CHECK(contains(said_of(solver_entry, {robot, "urdf.tip=tol"}),
                 "tip is \"tol\", which is no link; did you mean \"tool\"?"));
  CHECK(
      contains(said_of(solver_entry, {robot, "urdf.snap_deg=2"}), "urdf.snap_deg is 2; expected a number from 0 to 1"));
}

TEST_CASE("a study says how it will be judged, by default by ranks at 5 %, the paper's studies by means",
          "[study][analysis]") {
  const Study study = read(solver_entry);
  CHECK(study.plan == Plan());
  CHECK(nlohmann::json::parse(to_json(study))["analysis"] == nlohmann::json{{"test", "ranks"},
                                                                            {"metric", ""},
                                                                            {"control", ""},
                                                                            {"significance", 0.05},
                                                                            {"margin_percent", 5.0},
                                                                            {"margin_cm", 0.0}});
  for (const Study& built_in : studies()) {
    INFO(built_in.name);
    CHECK(built_in.plan == Plan{.test = built_in.name.starts_with("slim2023") ? Plan::Test::means : Plan::Test::ranks});
    CHECK(contains(to_toml(built_in), "\n[analysis]"));
  }
}

TEST_CASE("the table of the analysis is read, and --set changes it as it does other fields", "[study][analysis]") {
  const Study study =
      read("[analysis]\ntest = \"means\"\nmetric = \"error\"\nmargin_percent = 20\nmargin_cm = 0.015\n" + solver_entry +
               "label = \"A\"\n",
           {"analysis.significance=0.01", "analysis.control=A"});
  CHECK(study.plan == Plan{.test = Plan::Test::means,
                           .metric = "error",
                           .control = "A",
                           .significance = 0.01,
                           .margin = 0.2,  // 20 percent
                           .margin_cm = 0.015});
  CHECK(said_of(solver_entry, {"analysis.significance=7"}) ==
        "--set analysis.significance: analysis.significance is 7; expected a number from 0.0001 to 0.2");
}

// ---- mistakes -----------------------------------------------------------------------------------------------------

TEST_CASE("an unknown key is named with its place and the nearest known, at every level", "[study][mistakes]") {
  check(R"(
nmae = "x"|@ => 1:1: => unknown key "nmae" => did you mean "name"?
[stop]|iteratons = 3|@ => 2:1: => "iteratons" => did you mean "iterations"?
[path]|  radius = 3|@ => 2:3: => "radius" => did you mean "radius_cm"?
[path]|kind = "circle"|turns = 3|@ => 3:1: => "turns" => radius_cm
@labell = "x"| => 3:1: => did you mean "label"? => There are: solver, process, label, if_missing, colour, population, options
@options = { alhpa = 0.5 }| => 3: => unknown option "alhpa" => did you mean "alpha"?
[path]|kind = "poses"|poses = [{ position_cm = [1, 2, 3], rpy_dg = [0, 0, 0] }]|@ => 3:37: => did you mean "rpy_deg"?
[pth]|points = 3|@ => 1: => did you mean "path"?
)");
}

TEST_CASE("a value of another type is shown with its place and what was expected", "[study][mistakes]") {
  check(R"(
name = 3|@ => 1:8: => name is 3 => expected a quoted string
runs = "x"|@ => 1:8: => runs is "x" => a whole number from 1 to 1000000
runs = 2.5|@ => 1:8: => runs is 2.5 => a whole number
runs = true|@ => 1:8: => runs is true => a whole number
runs = [3]|@ => 1:8: => runs is [ 3 ] => a whole number
runs = 1979-05-27|@ => 1:8: => runs is 1979-05-27 => a whole number
search = 3|@ => 1:10: => search is 3 => one of "wrist", "all_joints", "pose"
search = "wirst"|@ => 1:10: => search is "wirst" => one of "wrist", "all_joints", "pose"
initial_deg = 3|@ => 1:15: => initial_deg is 3 => a list of numbers
initial_deg = [1, 2, "x"]|@ => 1:22: => initial_deg is "x" => a list of numbers
stop = 3|@ => 1:8: => stop is 3 => expected a table: [stop]
path = "helix"|@ => 1:8: => path is "helix" => expected a table: [path]
[stop]|seconds = "3"|@ => 2:11: => stop.seconds is "3" => a number from 0 to
[path]|centre_cm = [1, 2]|@ => 2:13: => path.centre_cm is [ 1, 2 ] => a list of 3 numbers
[path]|kind = "zigzag"|@ => 2:8: => path.kind is "zigzag" => "helix", "circle", "random", "poses"
@options = 3| => 3:11: => options is 3 => expected a table
@options = { alpha = true }| => 3:21: => ik_bat.alpha is true => a number or a quoted string
@label = 3| => 3:9: => label is 3 => a quoted string
[[solvers]]|solver = 3| => 2:10: => solver is 3 => a quoted string
)");
}

TEST_CASE("what an analysis cannot be is told with its place and what it can be", "[study][mistakes][analysis]") {
  check(R"(
analysis = 3|@ => 1:12: => analysis is 3 => expected a table: [analysis]
[analysis]|signficance = 0.01|@ => 2:1: => did you mean "significance"?
[analysis]|test = "t"|@ => 2:8: => analysis.test is "t" => "ranks", "means"
[analysis]|significance = 0|@ => 2:16: => significance is 0 => from 0.0001 to 0.2
[analysis]|significance = nan|@ => 2:16: => significance is nan
[analysis]|margin_percent = -1|@ => 2:18: => margin_percent is -1 => from 0 to 99
[analysis]|margin_cm = 1001|@ => 2:13: => margin_cm is 1001 => from 0 to 1000
[analysis]|control = "IK"|@@label = "B"| => 2:11: => unknown label "IK" => ik_bat, B
)");
}

TEST_CASE("what figures cannot be is told with its place and what they can be", "[study][mistakes]") {
  check(R"(
[figures]|font = "x'; !y"|@ => 2:8: figures.font => letters, digits
[figures]|text_pt = 300|@ => 2:11: figures.text_pt => from 4 to 24
[figures]|solvers = ["DE"]|@ => 2:11: => unknown label "DE"
[figures]|color = 1|@ => 2: => color
@colour = "blau"| => 3:10: solvers.colour => #1E8CF8
)");
  CHECK(read(solver_entry, {"figures.text_pt=10", "ik_bat.colour=#8D1804"}).figures.text_pt == 10);
  CHECK(read(solver_entry, {"ik_bat.colour=#8D1804"}).solvers[0].colour == "#8D1804");
}

TEST_CASE("a study that enforces the limits asks nothing that breaks them", "[study][mistakes]") {
  const std::string enforced = "limits = \"enforced\"\n";
  check(R"(
limits = "enforced"|bounds = "initial"|@ => 2:10: => limits is "enforced"
limits = "enforced"|@options = { bounds = "initial" }| => 4:22: => limits is "enforced"
limits = "enforced"|initial_deg = [0, 120.5, 0, 0, 0, 0, 0]|@ => 2:15: => 0.5 deg outside the limits of joint 2 => ikbench robot kuka_iiwa14
limits = "strict"|@ => 1:10: => "recorded", "enforced"
start = "zero"|@ => 1:9: => "previous", "initial"
)");
  CHECK(read(enforced + "initial_deg = [0, 120, 0, -120, 0, 0, 175]\n" + solver_entry).limits == Limits::enforced);
}

TEST_CASE("a number out of its range is shown with the range", "[study][mistakes]") {
  check(R"(
runs = 0|@ => 1:8: => runs is 0 => from 1 to 1000000
runs = 1000000|[path]|kind = "random"|points = 100000|@ => 1:8: => 100 000 000 solves
@population = 0| => 3:14: => ik_bat.population is 0 => from 1 to 100000
[[solvers]]|solver = "differential_evolution"|population = 3| => 3:14: => population is 3, but differential_evolution needs at least 4
population = 3|[[solvers]]|solver = "differential_evolution"| => 1:14: => population is 3, but differential_evolution needs at least 4
seed = -1|@ => 1:8: => seed is -1 => from 0 to 9223372036854775807
seed = 9223372036854775808|@ => 1: => 9223372036854775808
population = 100001|@ => 1:14: => population is 100001 => from 1 to 100000
[stop]|iterations = -1|@ => 2:14: => stop.iterations is -1 => from 0 to
[stop]|iterations = 0|@ => 2:14: => stop.iterations is 0 => at least 1
[path]|points = 0|@ => 2:10: => path.points is 0 => from 1 to 100000
[path]|radius_cm = -1|@ => 2:13: => path.radius_cm is -1 => from 0 to
[path]|centre_cm = [0, 0, 1e7]|@ => 2:20: => path.centre_cm is => within +-1e6
@options = { alpha = 1.5 }| => 3:21: => option alpha is "1.5" => a number from 0 to 1
)");
}

TEST_CASE("what is not a finite number is refused wherever a number stands", "[study][mistakes]") {
  for (const std::string bad : {"nan", "-nan", "inf", "-inf"}) {
    check({{"[stop]\ntolerance_cm = " + bad + "\n" + solver_entry,
            "my.toml:2:16: ",
            {"stop.tolerance_cm is", "a number from 0"}},
           {"[stop]\niterations = " + bad + "\n" + solver_entry, "my.toml:2:14: ", {"a whole number"}},
           {"[path]\nturns = " + bad + "\n" + solver_entry, "my.toml:2:9: ", {"a number from"}},
           {"[path]\ncentre_cm = [0, 0, " + bad + "]\n" + solver_entry, "my.toml:2:20: ", {"a list of 3 numbers"}},
           {"initial_deg = [0, 0, 0, 0, 0, 0, " + bad + "]\n" + solver_entry, "my.toml:1:34: ", {"a list of numbers"}},
           {solver_entry + "options = { alpha = " + bad + " }\n", "my.toml:3:21: ", {"a number from 0 to 1"}},
           {"[path]\nkind = \"poses\"\nposes = [{ position_cm = [0, 0, " + bad + "] }]\n" + solver_entry,
            "my.toml:3:33: ",
            {"a list of 3 numbers"}}});
  }
}

TEST_CASE("a study has solvers and an arm that there are, each label once", "[study][mistakes]") {
  check(R"(
 => 1:1: => solvers is missing => [[solvers]]
name = "x"| => 1:1: => solvers is missing
solvers = []| => 1:11: => solvers is [] => at least one [[solvers]]
solvers = 3| => 1:11: => solvers is 3
solvers = [3]| => 1:12: => solvers is 3
[[solvers]]|solver = "ik_bta"| => 2:10: => did you mean "ik_bat"?
robot = "planr_2"|@ => 1:9: => did you mean "planar_2"?
@@ => 3:1: => label "ik_bat" is used twice
[[solvers]]|label = "x"| => 1:1: => has no `solver` => ikbench list solvers
)");
}

TEST_CASE("what fields ask of each other is checked where one of them stands", "[study][mistakes]") {
  check(R"(
robot = "planar_2"|search = "wrist"|@ => 2:10: => search is "wrist" => planar_2 has no spherical wrist => expected "all_joints", "axis" or "pose"
robot = "planar_2"|@ => 1:1: => search is "wrist" => expected "all_joints"
robot = "planar_2"|search = "flange"|@ => 2:10: => search is "flange" => the last joint of planar_2 moves => expected "all_joints", "axis" or "pose"
initial_deg = [0, 0]|@ => 1:15: => has 2 values => expected 7, one for each joint of kuka_iiwa14
robot = "planar_2"|search = "all_joints"|initial_deg = [0, 0, 0]|@ => 3:15: => has 3 values => expected 2, one for each joint of planar_2
)");
}

TEST_CASE("what a search for poses asks for, and what only it has", "[study][mistakes]") {
  const std::string pose = "robot = \"ur5e\"\nsearch = \"pose\"\n";
  const auto stop = [](const std::string& fields) { return "[stop]\n" + fields + solver_entry; };
  check(R"(
robot = "ur5e"|search = "pose"|[stop]|tolerance_cm = 0.01|@ => 4:16: => stop.tolerance_cm is 0.01 and stop.tolerance_deg is 0 => expects both, or neither
robot = "ur5e"|search = "pose"|[stop]|tolerance_deg = 0.5|@ => 4:17: => stop.tolerance_cm is 0 and stop.tolerance_deg is 0.5 => expects both, or neither
robot = "ur5e"|search = "pose"|[stop]|tolerance_cm = 1|tolerance_deg = 181|@ => 5:17: => stop.tolerance_deg is 181
[stop]|tolerance_deg = 0.5|@ => 2:17: => about the orientation, which is not searched => expected search = "pose"
rotation_weight_m = 0.1|@ => 1:21: => weighs the orientation, which is not searched => expected search = "pose"
robot = "ur5e"|search = "pose"|rotation_weight_m = 0|@ => 3:21: => rotation_weight_m is 0
)");
  const Study study = read(pose + "rotation_weight_m = 0.1\n" + stop("tolerance_cm = 0.01\ntolerance_deg = 0.5\n"));
  CHECK(study.search == Search::pose);
  CHECK(study.rotation_weight == 0.1);
  CHECK(study.stop.angle_tolerance == Approx(0.5 * degree));
  CHECK(read(to_toml(study)).stop.angle_tolerance == study.stop.angle_tolerance);
  CHECK(read(pose + solver_entry).stop.angle_tolerance == 0);
}

TEST_CASE("a pose is a place and a rotation", "[study][mistakes]") {
  check(R"(
[path]|kind = "poses"|@ => 1:1: => path.poses is missing => position_cm
[path]|kind = "poses"|poses = []|@ => 3:9: => path.poses is [] => a list of 1 to 100000 poses
[path]|kind = "poses"|poses = [3]|@ => 3:10: => path.poses is 3
[path]|kind = "poses"|poses = [{ rpy_deg = [0, 0, 0] }]|@ => 3:10: => a pose with either a position_cm or a position_m
[path]|kind = "poses"|poses = [{ position_cm = [1, 2, 3], position_m = [1, 2, 3] }]|@ => 3:10: => either
[path]|kind = "poses"|poses = [{ position_cm = [1, 2] }]|@ => 3:26: => a list of 3 numbers
[path]|kind = "poses"|poses = [{ position_cm = [1, 2, 3], rotation = [1, 0, 0, 0, 1, 0, 0, 0] }]|@ => 3:48: => a list of 9 numbers
[path]|kind = "poses"|poses = [{ position_cm = [1, 2, 3], rotation = [1, 0, 0, 0, 1, 0, 0, 0, 2] }]|@ => 3:10: => a rotation matrix, row by row
[path]|kind = "poses"|poses = [{ position_cm = [1, 2, 3], rotation = [1, 0, 0, 0, 1, 0, 0, 0, -1] }]|@ => 3:10: => a rotation matrix
[path]|kind = "poses"|poses = [{ position_cm = [1, 2, 3], rotation = [0, 0, 0, 0, 0, 0, 0, 0, 0] }]|@ => 3:10: => a rotation matrix
)");
}

TEST_CASE("names and labels are short and without control characters", "[study][mistakes]") {
  const std::string expected = "a text of at most 200 bytes without control characters";
  check(R"(
name = "a\u001b[31m"|@ => 1:8: => name is "a\u001B[31m" => a text of at most 200 bytes without control characters
name = "a\nb"|@ => 1:8: => name is "a\nb" => a text of at most 200 bytes without control characters
name = """|a|b"""|@ => 1:8: => a text of at most 200 bytes without control characters
title = "a\u0000b"|@ => 1:9: => a text of at most 200 bytes without control characters
title = "\u007f"|@ => 1:9: => a text of at most 200 bytes without control characters
@label = "a\tb"| => 3:9: => a text of at most 200 bytes without control characters
@options = { bounds = "cl\namp" }| => 3:22: => a text of at most 200 bytes without control characters
name = ""|@ => 1:8: => a non-empty name
@label = ""| => 3:9: => a label that is not empty
@label = " a"| => 3:9: => without spaces at its ends
)");
  check({{"name = \"" + std::string(201, 'x') + "\"\n" + solver_entry, "my.toml:1:8: ", {"...", expected}}});
  CHECK(read("name = \"" + std::string(200, 'x') + "\"\n" + solver_entry).name.size() == 200);
  CHECK(said_of("name = \"" + std::string(100'000, 'x') + "\"\n" + solver_entry).size() < 300);
}

TEST_CASE("what is not TOML is refused with the place where it ceases to be", "[study][mistakes]") {
  check(R"(
a = = 3| => 1:5: not TOML:
runs = 3|runs = 4| => 2: => not TOML => runs
name = "open|@ => 1: => not TOML
[path|@ => 1: => not TOML
SQLite format 3 => 1: => not TOML
)");
  check({{"\xff\xfe\x00", "my.toml:1:", {}},
         {std::string("runs = 3\n\0\0\0", 12) + solver_entry, "my.toml:2:", {"not TOML"}},
         {"\x7f"
          "ELF\x02\x01\x01",
          "my.toml:1:",
          {"not TOML"}}});
}

TEST_CASE("nesting deeper than anyone means is refused, not followed to the end of the stack", "[study][mistakes]") {
  const auto repeated = [](const std::string& piece, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += piece;
    return text;
  };
  check({{"a = " + repeated("[", 100'000), "my.toml:1:", {"not TOML"}},
         {"a = " + repeated("{a = ", 100'000), "my.toml:1:", {"not TOML"}},
         {"a" + repeated(".a", 100'000) + " = 1\n", "my.toml:1:", {"expected less deeply nested keys"}},
         {"\n[a" + repeated(". a", 100'000) + "]\n", "my.toml:2:", {"expected less deeply nested keys"}},
         {repeated("a.", 400) + "a = 1\n" + solver_entry, "my.toml:1:1: ", {"unknown key \"a\""}}});
}

TEST_CASE("a file of more than 10 MB is not read", "[study][mistakes]") {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.path / "large.toml";
  write_text(file, solver_entry + "# " + std::string(10'000'000, 'x'));
  CHECK(contains(complaint<std::invalid_argument>([&] { load_study(file.string()); }), "at most 10 MB"));
  write_text(file, solver_entry + "# " + std::string(1'000'000, 'x'));
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
  says(file, "no such file: " + file + ";", names);
  says("/dev/zero", "/dev/zero is not a regular file", "");
  says(folder.path.string(), folder.path.string() + " is a folder; expected a TOML file", names);
  says("slim2032", "no such file", "did you mean \"slim2023\"?");
}

// ---- overrides ----------------------------------------------------------------------------------------------------

TEST_CASE("an override sets a field of the study, of its path or of its stop rule", "[study][set]") {
  const Study study = load_study("slim2023", {"runs=5", "path.tool=eq27", "path.points=7", "stop.tolerance_cm=0.1",
                                              "search=\"all_joints\"", "initial_deg=[1, 2, 3, 4, 5, 6, 7]"});
  CHECK(study.runs == 5);
  CHECK(targets(study, 1)[0].linear() == rotation(Tool::eq27));
  CHECK(study.path->points() == 7);
  CHECK(study.stop.tolerance == Approx(0.001));
  CHECK(study.search == Search::all_joints);
  CHECK(study.initial[6] == Approx(7 * std::numbers::pi / 180));
}

TEST_CASE("an override sets an option of the solvers with that label or that solver", "[study][set]") {
  const std::string two =
      solver_entry + "label = \"A\"\n" + solver_entry + "label = \"B v1.0\"\noptions = { gamma = 0.5 }\n";
  Study study = read(two, {"A.alpha=0.25"});
  CHECK(study.solvers[0].options == Settings{{"alpha", "0.25"}});
  CHECK(study.solvers[1].options == Settings{{"gamma", "0.5"}});
  study = read(two, {"ik_bat.alpha=0.25"});
  CHECK(study.solvers[0].options == Settings{{"alpha", "0.25"}});
  CHECK(study.solvers[1].options == Settings{{"alpha", "0.25"}, {"gamma", "0.5"}});
  study = read(two, {"B v1.0.gamma=0.75"});  // a label with a dot and a space
  CHECK(study.solvers[1].options == Settings{{"gamma", "0.75"}});
}

TEST_CASE("an override sets a solver's own population, by its label or its solver's name", "[study][set]") {
  const auto populations_of = [](const Overrides& overrides) {
    std::vector<int> found;
    for (const SolverEntry& one : load_study("slim2023-time", overrides).solvers) found.push_back(one.population);
    return found;
  };
  CHECK(populations_of({"12 bats.population=16"}) == std::vector<int>{16, 15, 20, 30});
  CHECK(populations_of({"ik_bat.population=16"}) == std::vector<int>{16, 16, 16, 16});
  CHECK(said_of(solver_entry, {"ik_bat.population=0"})
            .starts_with("--set ik_bat.population: ik_bat.population is 0; expected a whole number from 1 to 100000"));
  CHECK(said_of(solver_entry, {"ik_bat.population=1000000000"}).starts_with("--set ik_bat.population: "));
}

TEST_CASE("a kind of path in an override has that kind's keys", "[study][set]") {
  CHECK(read(solver_entry, {"path.kind=random", "path.points=3"}).path->points() == 3);
  CHECK(said_of(solver_entry, {"path.kind=random", "path.tool=down"})
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

TEST_CASE("an override adds one value and nothing else", "[study][set]") {
  CHECK(contains(said_of(solver_entry, {"runs=5\nseed=3"}), "runs is \"5\\nseed=3\""));
  CHECK(contains(said_of(solver_entry, {"title=a\nb"}), "without control characters"));
  CHECK(contains(said_of(solver_entry, {"runs=5\n[path]\npoints=3"}), "--set runs: "));
}

TEST_CASE("a mistake in an override is reported as that of --set, not of the file", "[study][set][mistakes]") {
  const std::vector<std::pair<std::string, std::string>> mistakes{
      {"runs=0", "--set runs: runs is 0; expected a whole number from 1"},
      {"runs=x", "--set runs: runs is \"x\"; expected a whole number from 1"},
      {"runs=", "--set runs: "},
      {"name=2023", "--set name: name is 2023; expected a quoted string"},
      {"runz=3", "--set runz: unknown key \"runz\"; did you mean \"runs\"?"},
      {"path.tool=sideways", "--set path.tool: path.tool is \"sideways\"; expected one of \"down\", \"eq27\""},
      {"path.tol=eq27", "--set path.tol: unknown key \"tol\"; did you mean \"tool\"?"},
      {"path.points=0", "--set path.points: "},
      {"path.centre_cm=[0, 0, nan]", "--set path.centre_cm: "},
      {"path={ tol = 1 }", "--set path.tol: unknown key"},
      {"stop.iterations=-3", "--set stop.iterations: stop.iterations is -3"},
      {"stop.iteration=3", "--set stop.iteration: unknown key"},
      {"path=3", "--set path: path is 3; expected a table"},
      {"ik_bat.alpha=7", "--set ik_bat.alpha: option alpha is \"7\"; expected a number from 0 to 1"},
      {"ik_bat.alhpa=0.7", "--set ik_bat.alhpa: unknown option \"alhpa\"; did you mean \"alpha\"?"},
      {"ik_bat.bounds=[1]", "--set ik_bat.bounds: "},
      {"ik_bta.alpha=0.7", "--set ik_bta.alpha: unknown solver \"ik_bta\"; did you mean \"ik_bat\"?"},
      {"initial_deg=[1, 2]", "--set initial_deg: initial_deg has 2 values; expected 7"},
      {"robot=none", "--set robot: unknown robot \"none\""},
      {"search=all", "--set search: "},
      {"solvers=[]", "--set solvers: solvers is []"},
      {"solvers=[{ solver = \"bta\" }]", "--set solvers.solver: unknown solver \"bta\""}};
  for (const auto& [override, expected] : mistakes) {
    INFO(override);
    const std::string message = said_of("\n\n\n" + solver_entry, {override});
    INFO(message);
    CHECK(message.starts_with(expected));
    CHECK_FALSE(contains(message, "my.toml"));
  }
}

TEST_CASE("an override is key=value", "[study][set][mistakes]") {
  for (const std::string malformed : {"", "=", "=3", "runs", "runs 5", ".alpha=0.5", "ik_bat.=0.5", "."}) {
    INFO(malformed);
    const std::string message = said_of(solver_entry, {malformed});
    INFO(message);
    CHECK(message.starts_with("--set"));
    CHECK(contains(message, "expected"));
  }
  CHECK(said_of(solver_entry, {std::string(100'000, 'a') + "=1"}).size() < 400);
  CHECK(said_of(solver_entry, {"a" + std::string(100'000, '.') + "b=1"}).size() < 400);
  CHECK(said_of(solver_entry, {"title=" + std::string(100'000, '[')}).size() < 400);
  CHECK(contains(said_of(solver_entry, {"path=3", "path.points=3"}), "--set path"));
}
