// All answers: what is known of a target's answers, and what solvers that give several are found to give.
#include "experiments/known_answers.hpp"

#include <boost/algorithm/string/replace.hpp>

#include "tests/experiments/samples.hpp"

namespace ikbench::known {

namespace {

using results::AnswerCount, results::CountedAnswers, results::Store;
using Rows = std::vector<Configuration>;

Configuration degrees(std::initializer_list<double> angles) {
  Configuration q(std::ssize(angles));
  std::ranges::copy(angles, q.begin());
  return q * base::degree;
}

// Returns a study of these configurations' poses, with an entry for each file of answers.
std::string study_text(const std::string& robot_name, const std::vector<Configuration>& reached,
                       const std::vector<std::string>& files) {
  const Robot arm = robot(robot_name);
  std::string poses, entries;
  for (const Configuration& q : reached) {
    const Pose pose = arm.chain.forward(q);
    std::vector<double> rotation;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) rotation.push_back(pose.linear()(row, column));
    poses += fmt::format("{{ position_m = [{}], rotation = [{}] }},\n",
                         fmt::join(std::vector<double>(pose.translation().begin(), pose.translation().end()), ", "),
                         fmt::join(rotation, ", "));
  }
  for (const std::string& file : files)
    entries += fmt::format("[[solvers]]\nlabel = \"{0}\"\nanswers = \"{0}.csv\"\n", file);
  return fmt::format(
      "robot = \"{}\"\nname = \"my\"\nsearch = \"pose\"\nlimits = \"enforced\"\nruns = 1\nstart = \"middle\"\n[stop]\n"
      "tolerance_cm = 0.001\ntolerance_deg = 0.001\nevaluations = 1000\n[path]\nkind = \"poses\"\nposes = [\n{}]\n{}",
      robot_name, poses, entries);
}

// Writes answers to point 1, 2, ... into a file.
void write_answers_file(const std::filesystem::path& file, const std::vector<Rows>& by_point) {
  std::string text = "run,point,q1,q2,q3,q4,q5,q6\n";
  for (std::size_t point = 0; point < by_point.size(); ++point)
    for (const Configuration& q : by_point[point])
      text += fmt::format("1,{},{}\n", point + 1, fmt::join(std::vector<double>(q.begin(), q.end()), ","));
  write_text(file, text);
}

// Solves the study in the folder, and returns what was counted.
CountedAnswers counted_in(const std::filesystem::path& folder, const std::string& study_text, Store& store) {
  write_text(folder / "my.toml", study_text);
  const Study study = load_study((folder / "my.toml").string());
  run(study, store, {});
  return store.counted_answers("my");
}

AnswerCount count_of(const CountedAnswers& counted, const results::StoredStudy& study, const std::string& label,
                     int point = 1) {
  const auto series = std::ranges::find(study.series, label, &results::Series::label);
  return *std::ranges::find_if(
      counted.counts, [&](const AnswerCount& count) { return count.series == series->key && count.point == point; });
}

}  // namespace

TEST_CASE("a round pose of a UR5e has eight known answers, another a continuum", "[known]") {
  const ScratchFolder folder;
  Store store(folder.path / "a.sqlite", Store::Mode::write);
  const std::vector reached{degrees({45, 0, 90, 90, 90, 180}), degrees({180, 90, 45, 45, 180, 45})};
  write_answers_file(folder.path / "two.csv", {{reached[0], reached[0]}, {reached[1]}});
  const std::string text = study_text("ur5e", reached, {"two"});
  const CountedAnswers counted = counted_in(folder.path, text, store);
  REQUIRE(counted.targets.size() == 2);
  CHECK(counted.targets[0].known == 8);
  CHECK_FALSE(counted.targets[0].is_continuum);
  CHECK(counted.targets[1].is_continuum);
  CHECK(counted.targets[1].known == 0);
  const AnswerCount two = count_of(counted, store.study("my"), "two");
  CHECK(two.given == 2);
  CHECK(two.found == 1);
  CHECK(two.doubled == 1);
}

TEST_CASE("a closed form that lacks a branch, has a wrong one or doubles one is found out", "[known]") {
  const ScratchFolder folder;
  Store store(folder.path / "a.sqlite", Store::Mode::write);
  const std::vector reached{degrees({45, 0, 90, 90, 90, 180})};
  write_answers_file(folder.path / "all.csv", {{reached[0], reached[0]}});
  const CountedAnswers first = counted_in(folder.path, study_text("ur5e", reached, {"all"}), store);
  const Study study = load_study((folder.path / "my.toml").string());
  const Robot arm = robot("ur5e");
  const Pose target = targets_of_run(study, 1).front();
  AnswerFinder finder(study, arm, target);
  const std::vector<double>& restarts = first.targets[0].restarts_rad;
  for (std::size_t i = 0; i < restarts.size(); i += 6)
    finder.add(Eigen::Map<const Eigen::VectorXd>(restarts.data() + i, 6));
  REQUIRE(finder.known().size() == 8);
  const Rows all = finder.known();
  Rows lacking(all.begin() + 1, all.end()), wrong = all, doubled = all;
  wrong[3][0] += 0.3;
  doubled.push_back(all[5]);
  doubled.back()[5] += all[5][5] > 0 ? -whole_turn : whole_turn;  // a whole turn makes no other answer
  for (const auto& [name, rows] : {std::pair{"all", all}, {"lacking", lacking}, {"wrong", wrong}, {"doubled", doubled}})
    write_answers_file(folder.path / fmt::format("{}.csv", name), {rows});
  const CountedAnswers counted =
      counted_in(folder.path, study_text("ur5e", reached, {"all", "lacking", "wrong", "doubled"}), store);
  CHECK(counted.targets[0].restarts_rad == restarts);  // not made again
  const results::StoredStudy stored = store.study("my");
  const auto is = [&](const std::string& label, const std::array<int, 4>& numbers) {
    const AnswerCount count = count_of(counted, stored, label);
    CHECK(std::array{count.given, count.found, count.wrong, count.doubled} == numbers);
  };
  is("all", {8, 8, 0, 0});
  is("lacking", {7, 7, 0, 0});
  is("wrong", {8, 7, 1, 0});
  is("doubled", {9, 8, 0, 1});
}

TEST_CASE("an exact answer beyond a rounded limit is not known, whoever gives a neighbour inside", "[known]") {
  const ScratchFolder folder;
  Store store(folder.path / "a.sqlite", Store::Mode::write);
  const Configuration exact = degrees({180, -60, 80, 40, 50, 60});
  Configuration beside = exact;
  beside[0] = 3.14159;  // 2.7 um from the target, within the tolerance of 10 um
  write_text(folder.path / "arm.toml", R"(
    summary = "a UR5e whose first joint has limits of 3.14159 rad"
    source = "robots/arms/ur5e.toml"
    links = [
      { d_m = 0.1625, alpha_deg = -90, limits_deg = [-179.999848, 179.999848] },
      { a_m = 0.425, limits_deg = [-360, 360] },
      { a_m = 0.3922, limits_deg = [-180, 180] },
      { d_m = 0.1333, alpha_deg = -90, limits_deg = [-360, 360] },
      { d_m = 0.0997, alpha_deg = 90, limits_deg = [-360, 360] },
      { limits_deg = [-360, 360] },
    ]
    tool = { position_m = [0, 0, 0.0996], rpy_deg = [0, 0, -180] }
  )");
  write_answers_file(folder.path / "exact.csv", {{exact, exact}});
  write_answers_file(folder.path / "beside.csv", {{beside, beside}});
  std::string text = study_text("ur5e", {exact}, {"exact", "beside"});
  boost::replace_all(text, "\"ur5e\"", "\"arm.toml\"");
  const CountedAnswers counted = counted_in(folder.path, text, store);
  const results::StoredStudy stored = store.study("my");
  const AnswerCount of_exact = count_of(counted, stored, "exact"), of_beside = count_of(counted, stored, "beside");
  CHECK((of_exact.found == 0 && of_exact.wrong == 0));
  CHECK((of_beside.found == 0 && of_beside.wrong == 0));
  CHECK(counted.targets[0].known > 0);  // other branches, which neither gives
}

TEST_CASE("the counts of all answers follow again from the solves, whatever the jobs", "[known]") {
  const ScratchFolder folder;
  Store store(folder.path / "a.sqlite", Store::Mode::write);
  const Configuration wrong = degrees({10, 20, 30, 40, 50, 60});
  write_answers_file(folder.path / "mine.csv", {{wrong, wrong}, {wrong}});
  std::string text = study_text("ur5e", {}, {"mine"});
  boost::replace_all(text, "kind = \"poses\"\nposes = [\n]", "kind = \"random\"\npoints = 2");
  const CountedAnswers counted = counted_in(folder.path, text, store);
  const results::StoredStudy stored = store.study("my");
  const std::optional<CountedAnswers> again = recounted_answers(stored, store);
  REQUIRE(again);
  CHECK(again->restarts_key == counted.restarts_key);
  CHECK(again->targets == counted.targets);
  CHECK(again->counts == counted.counts);
  CountedAnswers changed = counted;
  changed.restarts_key = "of another source";
  store.save_counted_answers("my", changed);
  CHECK_FALSE(recounted_answers(stored, store));
}

TEST_CASE("restarts that were tried are not made again, even if none reached the target", "[known]") {
  const ScratchFolder folder;
  Store store(folder.path / "a.sqlite", Store::Mode::write);
  const std::vector reached{degrees({45, 0, 90, 90, 90, 180})};
  write_answers_file(folder.path / "mine.csv", {{reached[0], reached[0]}});
  const std::string text = study_text("ur5e", reached, {"mine"});
  CountedAnswers tried = counted_in(folder.path, text, store);
  REQUIRE(!tried.targets[0].restarts_rad.empty());
  tried.targets[0].restarts_rad.clear();
  store.save_counted_answers("my", tried);
  const CountedAnswers again = counted_in(folder.path, text, store);
  CHECK(again.targets[0].restarts_rad.empty());
  CHECK(again.targets[0].known == 1);
}

TEST_CASE("the answers to a grid are not counted, because a map shows no counts", "[known]") {
  const ScratchFolder folder;
  Store store(folder.path / "a.sqlite", Store::Mode::write);
  const Configuration any = degrees({10, 20, 30, 40, 50, 60});
  write_answers_file(folder.path / "mine.csv", {{any, any}});
  std::string text = study_text("ur5e", {}, {"mine"});
  boost::replace_all(text, "kind = \"poses\"\nposes = [\n]", "kind = \"grid\"\nstep_cm = 20");
  CHECK(counted_in(folder.path, text, store).targets.empty());
}

TEST_CASE("answers of an arm with more joints than the goal fixes are not counted", "[known]") {
  const Study of_seven =
      read("search = \"pose\"\n[[solvers]]\nsolver = \"newton\"\n[stop]\ntolerance_cm = 1\ntolerance_deg = 1\n");
  CHECK(why_not_countable(of_seven, robot("kuka_iiwa14")) == "7 joints for 6 freedoms: infinitely many answers");
  CHECK(why_not_countable(of_seven, robot("ur5e")).empty());
  CHECK(contains(why_not_countable(of_seven, robot("planar_3")), "most targets have no answer"));
}

TEST_CASE("round targets have joints of 0, 45, 90 and 180 degrees inside the limits", "[known]") {
  const Study study = read(
      "robot = \"ur5e\"\nsearch = \"pose\"\n[[solvers]]\nsolver = \"newton\"\n[stop]\n[path]\nkind = \"random\"\nset = \"round\"\npoints = 50\n");
  const Robot arm = robot_of(study);
  Random random(numerics::Key(1));
  for (const Configuration& q : study.path->source_configurations(arm, random))
    for (const double angle : q) {
      const double eighths = angle / (whole_turn / 8);
      CHECK((eighths == 0 || eighths == 1 || eighths == 2 || eighths == 4));
    }
}

}  // namespace ikbench::known
