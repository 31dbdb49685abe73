// Grids of targets: the plane, the step and the goal that an arm gets, and what is left out, against known numbers.
#include "experiments/targets.hpp"
#include "tests/experiments/samples.hpp"

namespace {

// Returns a study of a grid, with the defaults of a grid.
std::string grid_file(const std::string& robot) {
  return "robot = \"" + robot +
         "\"\nlimits = \"enforced\"\n[path]\nkind = \"grid\"\n[stop]\nevaluations = 1000\ntolerance_cm = 0.001\n"
         "tolerance_deg = 0.001\n[[solvers]]\nsolver = \"levenberg_marquardt\"\n";
}

Study grid_of(const std::string& robot, const Overrides& overrides = {}) { return read(grid_file(robot), overrides); }

std::string refusal_of_grid(const std::string& robot, const Overrides& overrides) {
  return complaint<std::invalid_argument>([&] { grid_of(robot, overrides); });
}

int within_reach(const Study& study) { return study.path->points() + study.path->grid()->left_out; }

}  // namespace

TEST_CASE("a grid has known numbers of targets, and of those that the ball of the last axis proves out of reach",
          "[path][grid]") {
  const Study coarse = grid_of("ur5e");
  CHECK(within_reach(coarse) == 1185);
  CHECK(coarse.path->grid()->left_out == 133);
  const Study fine = grid_of("ur5e", {"path.step_cm=2"});
  CHECK(within_reach(fine) == 7385);
  CHECK(fine.path->grid()->left_out == 829);
  const Study panda = grid_of("franka_panda", {"path.step_cm=2"});
  CHECK(within_reach(panda) == 5761);
  CHECK(panda.path->grid()->left_out == 811);
  const Study directions = grid_of("ur5e", {"path.step_cm=4", "path.tool=directions"});
  CHECK(within_reach(directions) == 8 * 1861);
  CHECK(directions.path->grid()->left_out == 1724);
  const Study five = grid_of(std::filesystem::absolute("tests/data/urdf/five.urdf").string(), {"path.step_cm=1"});
  CHECK(five.search == Search::axis);
  CHECK(within_reach(five) == 6109);
  CHECK(five.path->grid()->left_out == 3632);
}

TEST_CASE("the plane of a grid goes through the shoulder, and the tool points down", "[path][grid]") {
  const Study study = grid_of("abb_yumi_left");  // its shoulder is beside the base's axis, and its first axis is tilted
  const results::TargetGrid& grid = *study.path->grid();
  CHECK(grid.across == std::vector{1.0, 0.0, 0.0});
  CHECK(grid.up == std::vector{0.0, 0.0, 1.0});
  CHECK(grid.shoulder[1] != 0);
  for (const Pose& pose : targets_of_run(study, 1)) {
    CHECK(pose.translation().y() == grid.shoulder[1]);
    CHECK(pose.linear().col(2) == Eigen::Vector3d(0, 0, -1));
  }
}

TEST_CASE("if all axes are parallel, the grid is normal to them", "[path][grid]") {
  const Study study = grid_of("planar_3");
  const results::TargetGrid& grid = *study.path->grid();
  CHECK(grid.up == std::vector{0.0, 1.0, 0.0});
  CHECK(grid.tool == results::TargetGrid::Tool::zero);
  CHECK(study.search == Search::all_joints);
  CHECK(study.stop.angle_tolerance == 0);
  CHECK(grid.left_out == 0);
  // By pose the last joint is 0.5 m behind the tool, within 1 m of the shoulder: half of it is on the other side.
  const Study by_pose = grid_of("planar_3", {"search=pose"});
  CHECK(by_pose.path->grid()->left_out > 0);
  for (const Pose& pose : targets_of_run(by_pose, 1)) CHECK((pose * Eigen::Vector3d(-0.5, 0, 0)).norm() < 1 + 1e-4);
}

TEST_CASE("by itself a grid searches what the arm can do, from the middle, once, with a round step", "[path][grid]") {
  const std::vector<std::tuple<std::string, Search, double>> expected{{"ur5e", Search::pose, 5},
                                                                      {"franka_panda", Search::pose, 5},
                                                                      {"fanuc_m430ia2f", Search::axis, 5},
                                                                      {"dobot_magician", Search::all_joints, 1}};
  for (const auto& [arm, search, step_cm] : expected) {
    INFO(arm);
    const Study study = grid_of(arm);
    CHECK(study.search == search);
    CHECK(study.start == Start::middle);
    CHECK(study.runs == 1);
    CHECK(study.path->grid()->step == Approx(step_cm / 100));
  }
  for (const Robot& arm : all_robots()) {
    INFO(arm.name);
    const int points = grid_of(arm.name).path->points();
    CHECK(points > 100);
    CHECK(points < 6000);
  }
}

TEST_CASE("a grid is refused with what to change", "[path][grid]") {
  CHECK_THAT(refusal_of_grid("ur5e", {"path.step_cm=0.1"}), ContainsSubstring("expected at most 100000: step_cm = 1"));
  CHECK_THAT(refusal_of_grid("ur5e", {"path.step_cm=500"}), ContainsSubstring("expected a smaller step"));
  CHECK_THAT(refusal_of_grid("planar_3", {"path.tool=directions"}), ContainsSubstring("expected search = \"pose\""));
  CHECK_THAT(refusal_of_grid("planar_3", {"path.tool=directions", "search=axis"}),
             ContainsSubstring("parallel to all axes of planar_3"));
  CHECK_THAT(refusal_of_grid("ur5e", {"start=previous"}), ContainsSubstring("expected another start"));
  CHECK_THAT(refusal_of_grid("ur5e", {"runs=3"}), ContainsSubstring("expected runs = 1"));
}

TEST_CASE("the eight directions of a grid are within its plane", "[path][grid]") {
  for (const std::string plane : {"xz", "yz", "xy"}) {
    INFO(plane);
    const Study study = grid_of("ur5e", {"path.tool=directions", "path.step_cm=20", "path.plane=" + plane});
    const results::TargetGrid& grid = *study.path->grid();
    const Eigen::Vector3d normal = Eigen::Vector3d(grid.across.data()).cross(Eigen::Vector3d(grid.up.data()));
    for (const Pose& pose : targets_of_run(study, 1)) {
      CHECK(std::abs(pose.linear().col(2).dot(normal)) < 1e-15);
      CHECK(pose.linear().isUnitary(1e-14));
    }
  }
}

TEST_CASE("a stored grid is the same grid again", "[path][grid]") {
  const Study study = grid_of("ur5e", {"path.step_cm=20"});
  const ScratchFolder folder;
  results::Store store(folder.path / "store.sqlite", results::Store::Mode::write);
  const results::StoredStudy stored = to_stored(study);
  CHECK(stored.definition.grid == *study.path->grid());
  const Study again = load_study(store, stored);
  CHECK(to_stored(again).definition.json == stored.definition.json);
  const Study finer = load_study(store, stored, {"path.step_cm=10"});
  CHECK(finer.path->points() > 3 * study.path->points());
}

TEST_CASE("a grid normal to all axes is where a prismatic joint holds the tool at half its range", "[path][grid]") {
  // The links end 1.4 m above the floor and the tool 0.05 m below them; the slide lowers it by 0 to 0.15 m.
  const Study study = grid_of(std::filesystem::absolute("tests/data/arms/scara.toml").string());
  const results::TargetGrid& grid = *study.path->grid();
  CHECK(grid.up == std::vector{0.0, 1.0, 0.0});
  CHECK(std::abs(grid.shoulder[2] - (1.4 - 0.075 - 0.05)) < 1e-6);
}
