// Answers made elsewhere: files that are right, and files that are spoiled in the ways that users' files are.
#include "experiments/external/answers.hpp"

#include <random>

#include "experiments/diagnosis.hpp"
#include "experiments/targets.hpp"
#include "tests/experiments/samples.hpp"
#include "tests/mutator.hpp"

namespace ikbench::made_elsewhere {

namespace {

constexpr int targets = 20;

// A study of one arm with drawn poses, and the joints that reach them.
struct Sample {
  Study study;
  Robot arm;
  std::vector<Pose> poses;               // of run 1, 2, ...
  std::vector<Configuration> solutions;  // of the poses, by LM
};

std::string study_text(const std::string& solvers, const std::string& more = "start = \"random\"\n") {
  return "robot = \"ur5e\"\nsearch = \"pose\"\nlimits = \"enforced\"\nruns = 20\n" + more +
         "[stop]\ntolerance_cm = 0.001\ntolerance_deg = 0.001\nevaluations = 20000\n[path]\nkind = \"random\"\n"
         "points = 1\n" +
         solvers;
}
const std::string lm = "[[solvers]]\nsolver = \"levenberg_marquardt\"\n";

// Returns LM's answers to poses that `moved` makes of the study's.
std::vector<Configuration> solved(const Sample& sample, const std::function<Pose(const Pose&)>& moved) {
  std::vector<Configuration> answers;
  for (const Pose& pose : sample.poses) {
    const results::SolveRecord solve = solve_once(sample.study, sample.study.solvers.front(), moved(pose));
    answers.emplace_back();
    if (solve.status == results::Status::ok) answers.back() = to_eigen(solve.answer_rad);
  }
  return answers;
}

const Sample& sample() {
  static const Sample made = [] {
    Sample first{
        .study = parse_study(study_text(lm), "my.toml", {}), .arm = robot("ur5e"), .poses = {}, .solutions = {}};
    for (int run = 1; run <= targets; ++run) first.poses.push_back(targets_of_run(first.study, first.arm, run).front());
    first.solutions = solved(first, [](const Pose& pose) { return pose; });
    return first;
  }();
  return made;
}

// A row of a file.
struct Row {
  int run;
  std::vector<std::string> cells;  // of the joints
};

using Rows = std::vector<Row>;

// Returns the rows of answers. An empty configuration is no answer.
Rows rows_of(const std::vector<Configuration>& answers, const std::string& form = "{}") {
  Rows rows;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    if (answers[i].size() == 0) continue;
    Row row{.run = static_cast<int>(i) + 1, .cells = {}};
    for (const double value : answers[i]) row.cells.push_back(fmt::format(fmt::runtime(form), value));
    rows.push_back(row);
  }
  return rows;
}

// Returns the answers, each changed.
std::vector<Configuration> changed(const std::function<void(Configuration&)>& change) {
  std::vector<Configuration> answers = sample().solutions;
  for (Configuration& q : answers) change(q);
  return answers;
}

std::string csv_of(const Rows& rows, const std::string& header = "run,point,q1,q2,q3,q4,q5,q6") {
  std::string text = header + "\n";
  for (const Row& row : rows) text += fmt::format("{},1,{}\n", row.run, fmt::join(row.cells, ","));
  return text;
}

// What the study makes of a file.
struct Judged {
  AnswersReport report;
  int right = 0, unanswered = 0, not_finite = 0;
  std::vector<results::SolveRecord> solves = {};
};

Judged judged(const std::string& csv, const std::string& more = "start = \"random\"\n") {
  const ScratchFolder folder;
  write_text(folder.path / "a.csv", csv);
  write_text(folder.path / "my.toml", study_text("[[solvers]]\nanswers = \"a.csv\"\nlabel = \"MoveIt\"\n", more));
  const Study study = load_study((folder.path / "my.toml").string());
  if (!study.awaited.empty()) throw std::invalid_argument(study.awaited.front().reason);
  Judged all{.report = report_on(*study.solvers.front().answers, study, robot_of(study))};
  solve_without_store(study, 1, [&](results::SolveRecord solve) {
    all.right += solve.status == results::Status::ok;
    all.unanswered += solve.status == results::Status::declined && solve.stop_reason == results::StopReason::gave_up;
    all.not_finite += solve.status == results::Status::not_finite;
    all.solves.push_back(std::move(solve));
  });
  return all;
}

std::string refusal(const std::string& csv) {
  return complaint<std::invalid_argument>([&] { judged(csv); });
}

// Checks that a file of wrong answers has this cause.
void check_cause(const Rows& rows, const std::string& cause) {
  const Judged found = judged(csv_of(rows));
  CAPTURE(found.report.cause, found.report.facts);
  CHECK(found.right == 0);
  CHECK(contains(found.report.cause, cause));
}

// Checks that a file has answers, so many of them right, whose causes are not asked for.
void check_right(const Judged& found, int right, const std::string& facts = "") {
  CAPTURE(found.report.cause, found.report.facts);
  CHECK(found.right == right);
  CHECK(found.report.cause.empty());
  CHECK(contains(found.report.facts, facts));
}

Pose bent(const Pose& pose, const Eigen::Quaterniond& turned) {
  Pose moved = pose;
  moved.linear() = turned.toRotationMatrix();
  return moved;
}

}  // namespace

TEST_CASE("right answers from elsewhere are right, without a time", "[answers]") {
  const Judged good = judged(csv_of(rows_of(sample().solutions)));
  check_right(good, targets, "only the numbers of its rows");
  for (const results::SolveRecord& solve : good.solves) {
    CHECK(solve.timing == results::Timing::elsewhere);
    CHECK(solve.counted_by == results::CountedBy::none);
    CHECK(std::isnan(solve.seconds));
    CHECK(std::isnan(solve.wall_seconds));
    CHECK(solve.evaluations == 0);
  }
  Rows backwards = rows_of(sample().solutions);
  std::ranges::reverse(backwards);
  check_right(judged(csv_of(backwards)), targets);
  for (Row& row : backwards) row.cells.emplace_back("1.5");
  const Judged timed = judged(csv_of(backwards, "run,point,q1,q2,q3,q4,q5,q6,ms"));
  CHECK(timed.solves.front().seconds == 0.0015);
  CHECK(std::isnan(timed.solves.front().wall_seconds));
  const std::string named = "run,point,joint_1,joint_2,joint_3,joint_4,joint_5,joint_6";
  check_right(judged(csv_of(rows_of(sample().solutions), named)), targets);
}

TEST_CASE("answers with the digits of files and whole turns are right", "[answers]") {
  check_right(judged(csv_of(rows_of(sample().solutions, "{:.6f}"))), targets);
  check_right(judged(csv_of(rows_of(sample().solutions, "{:.7g}"))), targets);  // single precision
  check_right(judged(csv_of(rows_of(changed([](Configuration& q) { q[5] += whole_turn; })))), targets);
  check_right(judged(csv_of(rows_of(changed([](Configuration& q) { q[5] += whole_turn; }))),
                     "start = \"random\"\nwrap = \"no\"\n"),
              targets);
}

TEST_CASE("which of several answers counts does not depend on their whole turns", "[answers]") {
  const std::string middle = "start = \"middle\"\n";
  std::vector<Configuration> near = sample().solutions, turned, wrong;
  for (Configuration& q : near) {
    for (double& angle : q) angle = std::remainder(angle, whole_turn);
    turned.push_back(q);
    wrong.push_back(q);
    for (double& angle : turned.back()) angle += angle > 0 ? -whole_turn : whole_turn;  // still inside the limits
    for (double& angle : wrong.back()) angle += angle > 0 ? 0.05 : -0.05;               // a little farther away
  }
  for (const std::vector<Configuration>& right : {near, turned}) {
    Rows rows = rows_of(wrong);
    std::ranges::copy(rows_of(right), std::back_inserter(rows));
    const Judged chosen = judged(csv_of(rows), middle);
    check_right(chosen, targets);
    for (std::size_t i = 0; i < chosen.solves.size(); ++i)
      CHECK((to_eigen(chosen.solves[i].answer_rad) - near[i]).cwiseAbs().maxCoeff() < 1e-9);
  }
  // Without wraps the answers are measured as they are.
  Rows rows = rows_of(wrong);
  std::ranges::copy(rows_of(turned), std::back_inserter(rows));
  CHECK(judged(csv_of(rows), middle + "wrap = \"no\"\n").right == 0);
}

TEST_CASE("the cause of wrong answers is found from the answers", "[answers]") {
  check_cause(rows_of(changed([](Configuration& q) { q /= base::degree; })), "angles are in degrees");
  check_cause(rows_of(changed([](Configuration& q) { std::swap(q[0], q[2]); })), "stand as q3, q2, q1, q4, q5, q6");
  check_cause(rows_of(changed([](Configuration& q) { q[0] += half_turn; })),
              "frame of the base: (0, 0, 0) mm, 180 deg about z");
  check_cause(rows_of(sample().solutions, "{:.3f}"), "too few digits");
  Rows shifted = rows_of(sample().solutions);
  for (Row& row : shifted) row.run -= 1;
  shifted.erase(shifted.begin());
  check_cause(shifted, "the target 1 row further down");
}

TEST_CASE("a cause that holds for some answers is not said of all", "[answers]") {
  Rows shifted = rows_of(sample().solutions);
  for (Row& row : shifted) row.run -= 1;
  shifted.erase(shifted.begin());
  for (std::size_t i = 0; i < 6; ++i) std::ranges::fill(shifted[i].cells, "0.1");
  check_cause(shifted, "rows are shifted: 12 of 19 answers belong to the target 1 row further down");
}

TEST_CASE("only the columns of joints that turn are in degrees", "[answers]") {
  const Robot arm = robot("stanford");
  std::vector<AnsweredTarget> answers;
  for (int i = 0; i < 5; ++i) {
    Configuration q = Configuration::LinSpaced(arm.joints(), 0.1 * (i + 1), 0.4 + 0.05 * i);
    const Pose target = arm.chain.forward(q);
    for (Eigen::Index j = 0; j < q.size(); ++j)
      if (!arm.chain.slides(j)) q[j] /= base::degree;
    answers.push_back({target, q});
  }
  const auto found = diagnose(arm, answers, {});
  REQUIRE(found);
  CHECK(found->cause == Cause::degrees);
}

TEST_CASE("targets of one orientation do not tell a moved tool from a moved base", "[answers]") {
  const Robot arm = robot("ur5e");
  const auto cause_of = [&](const std::vector<Pose>& reached) {
    std::vector<AnsweredTarget> answers;
    for (const Pose& pose : reached) {
      Pose target = pose;
      target.translation() += 0.1 * pose.linear().col(2);  // a tool that is longer by 0.1 m
      const results::SolveRecord solve = solve_once(sample().study, sample().study.solvers.front(), pose);
      REQUIRE(solve.status == results::Status::ok);
      answers.push_back({target, to_eigen(solve.answer_rad)});
    }
    const auto found = diagnose(arm, answers, {.position = 1e-4, .angle = 1e-4});
    return found ? diagnosis_text(*found) : "";
  };
  std::vector<Pose> alike(5, sample().poses.front());
  for (std::size_t i = 0; i < alike.size(); ++i) alike[i].translation() *= 1 - 0.02 * static_cast<double>(i);
  const std::string both = cause_of(alike);
  CHECK(contains(both, "frame of the tool: (0, 0, 100) mm; or of the base: ("));
  const std::string tool = cause_of({sample().poses.begin(), sample().poses.begin() + 5});
  CHECK(tool.ends_with("frame of the tool: (0, 0, 100) mm"));
}

TEST_CASE("the cause of answers to bent targets is found", "[answers]") {
  check_cause(rows_of(solved(sample(),
                             [](const Pose& pose) {
                               const Eigen::Vector4d q = Eigen::Quaterniond(pose.linear()).coeffs();
                               return bent(pose, Eigen::Quaterniond(q[0], q[1], q[2], q[3]));
                             })),
              "the quaternion is in another order");
  check_cause(rows_of(solved(sample(),
                             [](const Pose& pose) { return bent(pose, Eigen::Quaterniond(pose.linear()).inverse()); })),
              "orientations are inverse");
  check_cause(rows_of(solved(sample(),
                             [](const Pose& pose) {
                               Pose flange = pose;
                               flange.translation() -= 0.1 * pose.linear().col(2);
                               return flange;
                             })),
              "frame of the tool: (0, 0, 100) mm");
}

TEST_CASE("faults of single rows are shown whatever is right", "[answers]") {
  const Rows good = rows_of(sample().solutions);
  Rows missing = good, doubled, second, without_number = good, empty = good;
  missing.resize(15);
  const Judged fewer = judged(csv_of(missing));
  check_right(fewer, 15);
  CHECK(fewer.unanswered == 5);
  const Rows wrong = rows_of(changed([](Configuration& q) { q[0] += 0.3; }));
  for (std::size_t i = 0; i < good.size(); ++i) {
    doubled.insert(doubled.end(), {good[i], good[i]});
    second.insert(second.end(), {good[i], wrong[i]});
  }
  const Judged twice = judged(csv_of(doubled));
  check_right(twice, targets, "20 doubled rows");
  CHECK(twice.solves.front().all_answers_rad.size() == 12);
  const Rows many(150, good.front());
  check_right(judged(csv_of(many)), 1, "149 doubled rows");
  const Judged beside = judged(csv_of(second));
  CHECK(beside.report.cause.empty());
  CHECK(contains(beside.report.facts, "20 wrong answers beside right ones"));
  CHECK(beside.right < targets);  // the answer nearest to the start counts
  for (const std::size_t row : {9U, 19U}) {
    without_number[row].cells[2] = "nan";
    empty[row].cells[2] = "";
  }
  for (const Rows& rows : {without_number, empty}) {
    const Judged found = judged(csv_of(rows));
    check_right(found, 18, "line 11: q3 is not a number (2 such rows)");
    CHECK(found.not_finite == 2);
  }
}

TEST_CASE("scattered errors have no cause", "[answers]") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  const Judged scattered = judged(csv_of(rows_of(changed([&](Configuration& q) {
    for (double& angle : q) angle += anywhere(random);
  }))));
  CHECK(scattered.right == 0);
  CHECK(scattered.report.cause.empty());
}

TEST_CASE("a file that is no table of answers for the study is refused", "[answers]") {
  const Rows good = rows_of(sample().solutions);
  CHECK(contains(refusal("run,point,q1,q2,q3,q4,q5\n1,1,0,0,0,0,0\n"), "no column 'q6'; the arm has 6 joints"));
  CHECK(contains(refusal("point,q1,q2,q3,q4,q5,q6\n1,0,0,0,0,0,0\n"), "no column 'run'"));
  CHECK(contains(refusal("run,point,q1,q2,q3,q4,q5,q6\n1,1,0,0,0,0,0,wrong\n"), "'wrong'"));
  CHECK(contains(refusal("run,point,q1,q2,q3,q4,q5,q6\n1,2,0,0,0,0,0,0\n"), "a.csv:2: run 1, point 2"));
  CHECK(contains(refusal("run,point,q1,q2,q3,q4,q5,q6\n1.5,1,0,0,0,0,0,0\n"), "is not the number of a run"));
  CHECK(contains(refusal("run,point,q1,q2,q3,q4,q5,q6,ms\n1,1,0,0,0,0,0,0,0\n"), "is not a time"));
  CHECK(contains(refusal("run,point,q1,q2,q3,q4,q5,q6\n1,1,0,0,inf,0,0,0\n"), "is infinite; expected the value"));
  CHECK(contains(refusal("run,point,q1,q2,q3,q4,q5,q6\n1,1,0,0,abc,0,0,0\n"),
                 "'abc' in column 'q3' is not a number; leave out the row of a target without an answer"));
  CHECK(contains(refusal("run,point,q1 [rad],q2,q3,q4,q5,q6\n1,1,0,0,0,0,0,0\n"),
                 "no column 'q1', but 'q1 [rad]'; expected the header 'q1' without a unit"));
  CHECK(contains(refusal("run,point,q1,q2,q3,q4,q5,q6,ms [ms]\n1,1,0,0,0,0,0,0,1\n"), "no column 'ms', but 'ms [ms]'"));
  const std::string hostile =
      refusal("run,point,q1,q2,q3,q4,q5,q6\n1,1,0,0,0,0,0,\x1b[2J" + std::string(100, 'a') + "\n");
  CHECK_FALSE(contains(hostile, "\x1b"));
  CHECK_FALSE(contains(hostile, std::string(61, 'a')));
  const auto complains = [](const std::string& entry, const std::string& more) {
    return complaint<std::invalid_argument>([&] { parse_study(study_text(entry, more), "my.toml", {}); });
  };
  const std::string entry = "[[solvers]]\nanswers = \"none.csv\"\n";
  CHECK(contains(complains(entry, "start = \"previous\"\n"), "start is \"previous\""));
  CHECK(contains(complains("[[solvers]]\nanswers = \"../none.csv\"\n", "start = \"middle\"\n"),
                 "outside the study's folder"));
  CHECK(contains(complains(entry + entry, "start = \"middle\"\n"), "is used twice"));
  CHECK(contains(complains(entry + "solver = \"bat\"\n", "start = \"middle\"\n"), "expected one of them"));
  const Study awaiting = parse_study(study_text(entry), "my.toml", {});
  CHECK(awaiting.solvers.empty());
  REQUIRE(awaiting.awaited.size() == 1);
  CHECK(awaiting.awaited.front().file == "none.csv");
}

TEST_CASE("arbitrary changes of a file of answers are read, or refused with the file's name", "[answers][fuzz]") {
  const Robot arm = robot("ur5e");
  const auto read = [&](const std::string& text) { answers_in(text, "a.csv", arm); };
  read_mutated(Mutator(7), "run,point,q1,q2,q3,q4,q5,q6,ms\n1,1,0.1,0.2,0.3,0.4,0.5,0.6,7\n2,1,0,1,2,3,4,5,6\n", 1000,
               "a.csv:", read, 0.1);
}

TEST_CASE("targets go out and come back", "[answers]") {
  std::string csv;
  write_targets(sample().study, [&](std::string_view part) { csv += part; });
  std::istringstream lines(csv);
  std::string header, line;
  std::getline(lines, header);
  CHECK(header.starts_with("run,point,target,x,y,z,qx,qy,qz,qw,start_joint_1,"));
  std::string answered = header + ",q1,q2,q3,q4,q5,q6\n", moved = answered;
  for (const Configuration& q : sample().solutions) {
    std::getline(lines, line);
    answered += fmt::format("{},{}\n", line, fmt::join(q, ","));
  }
  const Judged all = judged(answered);
  CHECK(all.right == targets);
  CHECK(all.report.facts.empty());
  const std::string of_another_seed =
      complaint<std::invalid_argument>([&] { judged(answered, "start = \"random\"\nseed = 2\n"); });
  CHECK(contains(of_another_seed, "a.csv:2: run 1, point 1: its target is '"));
}

TEST_CASE("a solver whose answers are to other targets is awaited, and the others stay", "[answers]") {
  const ScratchFolder folder;
  write_text(folder.path / "a.csv", "run,point,target,q1,q2,q3,q4,q5,q6\n1,1,0123456789abcdef,0,0,0,0,0,0\n");
  write_text(folder.path / "my.toml",
             study_text(lm + "label = \"LM\"\n[[solvers]]\nanswers = \"a.csv\"\nlabel = \"MoveIt\"\n",
                        "start = \"middle\"\n") +
                 "[analysis]\ncontrol = \"MoveIt\"\n[figures]\nsolvers = [\"LM\", \"MoveIt\"]\n");
  const Study study = load_study((folder.path / "my.toml").string());
  CHECK(labels_of(study) == std::vector<std::string>{"LM"});
  REQUIRE(study.awaited.size() == 1);
  CHECK(study.awaited.front().file == (folder.path / "a.csv").string());
  CHECK(contains(study.awaited.front().reason, "a.csv:2: run 1, point 1: its target is '0123456789abcdef'"));
  CHECK(study.plan.control.empty());
  CHECK(study.figures.solvers == std::vector<std::string>{"LM"});
}

TEST_CASE("an edited file of answers is another series", "[answers]") {
  const Robot arm = robot("ur5e");
  SolverEntry entry{.label = "a", .solver = "elsewhere"};
  const auto key_of = [&](const std::string& cells) {
    entry.answers =
        std::make_shared<GivenAnswers>(answers_in("run,point,q1,q2,q3,q4,q5,q6\n1,1," + cells + "\n", "a.csv", arm));
    return series_key(sample().study, entry);
  };
  CHECK(key_of("0,0,0,0,0,0") == key_of("0,0,0,0,0,0"));
  CHECK(key_of("0,0,0,0,0,0") != key_of("0,0,0,0,0,1"));
}

}  // namespace ikbench::made_elsewhere
