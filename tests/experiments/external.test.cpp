#include <sched.h>

#include "tests/experiments/samples.hpp"

namespace {

// Keeps this thread, and processes that it starts, on one processor.
void stay_on_one_processor() {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(::sched_getcpu(), &one);
  ::sched_setaffinity(0, sizeof(one), &one);
}

// Lets every other process have the processor of this thread, also processes that this thread starts.
void give_way() {
  const sched_param none{};
  ::sched_setscheduler(0, SCHED_IDLE | SCHED_RESET_ON_FORK, &none);
}

}  // namespace

TEST_CASE("the clock of a program's solve runs before the program does", "[external]") {
  const Study study = load_study("tests/data/busy/busy.toml");
  std::vector<results::SolveRecord> solves;
  // As soon as the program can read its message, it has the processor, and we do not.
  std::thread([&] {
    stay_on_one_processor();
    give_way();
    for (int i = 0; i < 5; ++i) solves.push_back(solve_once(study, study.solvers.front(), robots::Pose::Identity()));
  }).join();
  for (const results::SolveRecord& solve : solves) {
    CHECK(solve.status == results::Status::ok);
    CHECK(solve.cpu_seconds > 1e-4);
    CHECK(solve.seconds == solve.wall_seconds);  // no clock tells 0
    CHECK(solve.seconds >= solve.cpu_seconds);
  }
}

TEST_CASE("a program's own time is believed if its processor time leaves room for it", "[external]") {
  const auto believed = [](double reported, double cpu) {
    return credible_report({.cpu_seconds = cpu, .reported_seconds = reported});
  };
  CHECK(believed(0.01, 0.0105) == 0.01);
  CHECK(believed(0.01, 0.022) == 0.01);  // two threads
  CHECK(!believed(0.01, 0.05));          // more threads, or too short a report
  CHECK(!believed(0.01, 0));             // its processor time is not known
  CHECK(!believed(0, 0.001));            // a share of a batch that is too small for a double
  CHECK(!believed(std::nan(""), 0.01));  // it reports nothing
}

TEST_CASE("a program can report a tenth and 20 ms more than passed, and no more", "[external]") {
  CHECK(largest_possible_seconds(1) > 1.11);
  CHECK(largest_possible_seconds(1) < 1.13);  // so that 1.3 of a second is refused
  CHECK(largest_possible_seconds(0.001) > 0.02);
  CHECK(largest_possible_seconds(0.001) < 0.022);
}

TEST_CASE("an answer over the budget is that, whether it is within the tolerance or just beyond it", "[external]") {
  const ScratchFolder folder;
  const auto status = [&](const char* fault, double tolerance_cm) {
    write_text(
        folder.path / "study.toml",
        fmt::format("robot = \"kuka_iiwa14\"\nsearch = \"all_joints\"\nstart = \"middle\"\npath.kind = \"helix\"\n"
                    "stop = {{ iterations = 50, evaluations = 100, tolerance_cm = {} }}\n"
                    "[[solvers]]\nprocess = [\"python3\", \"{}\", \"{}\"]\n",
                    tolerance_cm, std::filesystem::absolute("tests/cli/programs/faulty.py").string(), fault));
    const Study study = load_study((folder.path / "study.toml").string());
    return solve_once(study, study.solvers.front(), targets_of_run(study, 1).front()).status;
  };
  CHECK(status("fine", 1000) == Status::ok);
  CHECK(status("fine", 1e-12) == Status::tolerance_missed);
  CHECK(status("spends", 1000) == Status::over_budget);  // it says that it made 1000 evaluations
  CHECK(status("spends", 1e-12) == Status::over_budget);
}

TEST_CASE("a repetition that fails gives up no program, since the solve before it has an answer", "[external]") {
  const ScratchFolder folder;
  write_text(folder.path / "study.toml",
             fmt::format("robot = \"kuka_iiwa14\"\nsearch = \"all_joints\"\nstart = \"middle\"\npath.kind = \"helix\"\n"
                         "[[solvers]]\nprocess = [\"python3\", \"{}\", \"falls again\"]\n",
                         std::filesystem::absolute("tests/cli/programs/faulty.py").string()));
  const Study study = load_study((folder.path / "study.toml").string());
  const Robot arm = robot(study.robot);
  const SolveRunner runner(study, study.solvers.front(), "key", arm, 1);
  const auto solver = runner.make_solver();
  const Pose target = targets_of_run(study, 1).front();
  std::vector<Status> statuses;
  for (int point = 7; point <= 10; ++point) {  // the ninth of the first run is repeated
    statuses.push_back(
        runner
            .solve(*solver, {.target = target, .start = starts_of_run(study, arm, 1).front(), .run = 1, .point = point})
            .status);
    runner.count_failure(*solver);
  }
  CHECK(statuses[0] == Status::crashed);
  CHECK(statuses[1] == Status::crashed);
  CHECK(is_sound(statuses[2]));
  CHECK(is_sound(statuses[3]));
}

TEST_CASE("one solve of an entry with batches is a batch of one, with the same answer", "[external]") {
  const ScratchFolder folder;
  const auto solved = [&](const std::string& batch) {
    write_text(
        folder.path / "study.toml",
        fmt::format("robot = \"kuka_iiwa14\"\nsearch = \"all_joints\"\nstart = \"middle\"\npath.kind = \"helix\"\n"
                    "[[solvers]]\nprocess = [\"python3\", \"{}\"]\n{}",
                    std::filesystem::absolute("tests/cli/programs/faulty.py").string(), batch));
    const Study study = load_study((folder.path / "study.toml").string());
    return solve_once(study, study.solvers.front(), targets_of_run(study, 1).front());
  };
  const SolveRecord alone = solved(""), of_batch = solved("batch = 5");
  CHECK(is_sound(alone.status));
  CHECK(of_batch.status == alone.status);
  CHECK(same(of_batch.answer_rad, alone.answer_rad));
  CHECK(of_batch.timing == Timing::batch);
  CHECK(of_batch.batch_size == 1);
}

TEST_CASE("a warm study says so to a program, and only one answer says that it is of a second solve", "[external]") {
  const Robot arm = robot("kuka_iiwa14");
  const Configuration start = Configuration::Constant(7, 0.2);
  const Problem problem{.start = start, .lower = arm.limits.lower, .upper = arm.limits.upper, .population = 20};
  const Eigen::Vector3d target(0, 0, 0.5);
  const nlohmann::json warm = nlohmann::json::parse(solve_message(problem, target, {}, 1, results::CacheState::warm));
  CHECK(warm["state"] == "warm");
  const auto answer = [](const std::string& rest) { return Message(R"({"message":"solved")" + rest + "}"); };
  CHECK(answer(R"(,"timed":"second")").is_of_second_solve());
  for (const char* rest : {"", R"(,"timed":"first")", R"(,"timed":2)", R"(,"timed":null)", R"(,"same":true)"})
    CHECK_FALSE(answer(rest).is_of_second_solve());
  CHECK(answer(R"(,"same":false)").differs_from_first());
  CHECK_FALSE(answer("").differs_from_first());
}

TEST_CASE("candidates are numbers as JSON writes them", "[external]") {
  const auto is_read = [](const std::string& number) {
    try {
      return Message(R"({"message":"evaluate","candidates":[[1,2],[3,)" + number + "]]}").candidates(2).size() == 4;
    } catch (const ProcessFailure& trouble) {
      return trouble.kind != ProcessFailure::Kind::protocol_error;
    }
  };
  for (const char* number : {"0", "-0.5", "1e-3", "1E5", "12345678901234567890", "0.1000000000000000055", "1e-400"})
    CHECK(is_read(number));
  for (const char* number : {"-", "1.", "1.e5", "01", "-01", ".5", "nan", "inf", "1e999", "+1", "0x1", "", "1 2", "1,2",
                             "1],[2", "[1]", "\"1\""})
    CHECK_FALSE(is_read(number));
}

TEST_CASE("an extra's name is no refused answer's, and not blank", "[external]") {
  const auto read = [](const std::string& name) {
    return Message(R"({"message":"solved","extras":{")" + name + "\":3}}").extras();
  };
  CHECK(read("refused").at("refused") == 3);
  for (const char* name : {"", " ", "refused_1", "a\\u001b"}) CHECK_THROWS_AS(read(name), ProcessFailure);
}

TEST_CASE("every arm follows from its robot message alone, by the formulas of protocol.md", "[external][protocol]") {
  std::vector<Robot> arms = all_robots();
  arms.push_back(load_robot("tests/data/urdf/ur5_calibrated.urdf"));  // whose axes are almost parallel
  for (const Robot& arm : arms) {
    CAPTURE(arm.name);
    const auto message =
        nlohmann::json::parse(robot_message({.arm = arm, .searched = arm.chain, .goal = Eigen::Vector3d(0, 0, 0)}));
    const auto matrix = [&](const char* key) {
      const std::vector<double> numbers = message[key];
      return Eigen::Affine3d(
          Eigen::Matrix4d(Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data())));
    };
    const Configuration q = Configuration::LinSpaced(arm.joints(), 0.4, -0.9);
    Eigen::Affine3d pose = matrix("base");
    const auto turn = [&](double angle, const Eigen::Vector3d& axis) { pose = pose * Eigen::AngleAxisd(angle, axis); };
    for (Eigen::Index j = 0; j < arm.joints(); ++j) {
      const auto& joint = message["joints"][static_cast<std::size_t>(j)];
      const bool slides = joint["type"] == "prismatic", is_coupled = joint["type"] == "coupled";
      const double theta = joint["theta"].get<double>() + (slides ? 0 : q[j]);
      const Eigen::Vector3d axis = is_coupled ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
      turn(theta, axis);
      pose = pose * Eigen::Translation3d(joint["a"], 0, joint["d"].get<double>() + (slides ? q[j] : 0));
      if (is_coupled) turn(-theta, axis);
      turn(joint["alpha"], Eigen::Vector3d::UnitX());
      turn(joint["beta"], Eigen::Vector3d::UnitY());
    }
    CHECK(((pose * matrix("tool")).matrix() - arm.chain.forward(q).matrix()).cwiseAbs().maxCoeff() < 1e-14);
  }
}
