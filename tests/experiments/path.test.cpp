// Paths by hand. Helix of Slim et al. 2023, Sec. 5.2: centre (60, 0, 10) cm, radius 20 cm, length 50 cm, 2 turns,
// 20 points; point k lies at t = 2 pi h k/20 (docs/papers/slim2023-notes.md 2.2).
#include "tests/experiments/samples.hpp"

namespace {

using std::numbers::pi;

Eigen::Vector3d point(const Path& path, std::size_t k) { return poses_of(path).at(k).translation(); }

bool same_poses(const std::vector<Pose>& a, const std::vector<Pose>& b) {
  return std::ranges::equal(a, b, [](const Pose& x, const Pose& y) { return x.matrix() == y.matrix(); });
}

// Returns a path of every kind, with `count` points.
std::vector<Path> with_points(int count) {
  const ScratchFolder folder;
  std::string csv = "x_m,y_m,z_m\n";
  for (int i = 0; i < count; ++i) csv += fmt::format("0.5,0,0.{}\n", i);
  write_text(folder.path / "path.csv", csv);
  write_text(folder.path / "study.toml",
             "robot = 'ur5e'\nsearch = 'pose'\n[path]\nkind = 'csv'\nfile = 'path.csv'\n[[solvers]]\nsolver = 'bat'\n");
  std::vector<Path> all{path_through(std::vector(static_cast<std::size_t>(count), Pose::Identity())),
                        load_study((folder.path / "study.toml").string()).path};
  for (const char* kind : {"helix", "circle", "random"})
    all.push_back(path_of({fmt::format("kind={}", kind), fmt::format("points={}", count)}));
  CHECK(all.size() + 1 == target_sets().size());  // a grid has as many as fit the arm
  return all;
}

bool near(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (a - b).norm() < 1e-15; }

}  // namespace

TEST_CASE("the paper's helix is the default: 20 points, a fifth of a turn and 2.5 cm of rise apart", "[path][paper]") {
  const std::vector<Pose> helix = poses_of(Study{}.path);
  REQUIRE(helix.size() == 20);
  // t = 0, pi, 2 pi, 3 pi: (sin t, cos t) is (0, 1), (0, -1), ...; z = 10 + 50 k/20 cm
  CHECK(near(helix[0].translation(), {0.60, 0.20, 0.10}));
  CHECK(near(helix[5].translation(), {0.60, -0.20, 0.225}));
  CHECK(near(helix[10].translation(), {0.60, 0.20, 0.35}));
  CHECK(near(helix[15].translation(), {0.60, -0.20, 0.475}));
  // t = 4 pi/20 = 36 deg
  CHECK(near(helix[1].translation(), {0.60 + 0.20 * std::sin(pi / 5), 0.20 * std::cos(pi / 5), 0.125}));
  // With k/n, the end of the helix, z = 60 cm, is not a target.
  CHECK(helix[19].translation().z() == Approx(0.10 + 0.50 * 19 / 20));
}

TEST_CASE("with the spacing k/(n - 1) the last point is the end of the helix; one point is its start", "[path]") {
  for (const std::string spacing : {"k_over_n", "k_over_n_minus_1"})
    CHECK(near(point(path_of({"points=1", "spacing=" + spacing}), 0), {0.60, 0.20, 0.10}));
  const Path helix = path_of({"spacing=k_over_n_minus_1"});
  CHECK(near(point(helix, 0), {0.60, 0.20, 0.10}));
  CHECK(near(point(helix, 19), {0.60, 0.20, 0.60}));  // t = 4 pi
  CHECK(poses_of(helix).size() == 20);
}

TEST_CASE("the phase cos_sin starts on the x axis and turns towards y, a quarter later a quarter on", "[path]") {
  const Path helix = path_of({"phase=cos_sin"});
  CHECK(near(point(helix, 0), {0.80, 0.0, 0.10}));
  CHECK(near(point(helix, 5), {0.40, 0.0, 0.225}));
  CHECK(point(helix, 1).y() > 0);
  CHECK(near(point(path_of({"start_deg=90"}), 0), {0.80, 0.0, 0.10}));                    // (sin, cos) of 90 deg
  CHECK(near(point(path_of({"start_deg=90", "phase=cos_sin"}), 0), {0.60, 0.20, 0.10}));  // (cos, sin) of 90 deg
}

TEST_CASE("the Dobot's circle is level, its 20 points 18 degrees apart from the x axis towards y", "[path][paper]") {
  const std::vector<Pose> circle = poses_of(path_of({"kind=circle"}));  // Sec. 6: centre (16, 16, 0) cm, radius 7 cm
  REQUIRE(circle.size() == 20);
  for (std::size_t k = 0; k < 20; ++k) {
    const double t = 18 * pi / 180 * static_cast<double>(k);
    CHECK(near(circle[k].translation(), {0.16 + 0.07 * std::cos(t), 0.16 + 0.07 * std::sin(t), 0.0}));
    CHECK(circle[k].linear() == tool_rotation(ToolOrientation::down));
  }
}

TEST_CASE("a circle has its own centre, radius, points and tool", "[path]") {
  const std::vector<Pose> circle =
      poses_of(path_of({"kind=circle", "centre_cm=[10, -20, 30]", "radius_cm=50", "points=4", "tool=eq27"}));
  REQUIRE(circle.size() == 4);
  CHECK(near(circle[1].translation(), {0.1, 0.3, 0.3}));
  CHECK(near(circle[2].translation(), {-0.4, -0.2, 0.3}));
  CHECK(circle[3].linear() == tool_rotation(ToolOrientation::eq27));
}

TEST_CASE("random targets are tool poses of configurations within the limits, on every arm", "[path]") {
  for (const Robot& arm : all_robots()) {
    INFO(arm.name);
    Random random(Key(1)), again(Key(1));
    const std::vector<Pose> poses = path_of({"kind=random", "points=200"})->poses(arm, random);
    REQUIRE(poses.size() == 200);
    const JointLimits limits = arm.limits.around(Eigen::VectorXd::Zero(arm.joints()));
    Configuration lowest = limits.upper, highest = limits.lower;
    for (const Pose& pose : poses) {
      Configuration q(arm.joints());
      for (Eigen::Index j = 0; j < q.size(); ++j) q[j] = again.uniform(limits.lower[j], limits.upper[j]);
      CHECK(pose.matrix() == arm.chain.forward(q).matrix());
      lowest = lowest.cwiseMin(q);
      highest = highest.cwiseMax(q);
    }
    const Configuration range = limits.upper - limits.lower;  // 200 draws leave little of it at either end
    CHECK(((highest - lowest).array() > 0.9 * range.array()).all());
  }
}

// ---- every kind ---------------------------------------------------------------------------------------------------

TEST_CASE("a path has so many targets as it says, of finite numbers, and each is a place and a rotation", "[path]") {
  for (const Path& path : with_points(5)) {
    INFO(path->name());
    CHECK(path->points() == 5);
    for (const Robot& arm : all_robots()) {
      Random random(Key(1));
      const std::vector<Pose> poses = path->poses(arm, random);
      REQUIRE(poses.size() == 5);
      for (const Pose& pose : poses) {
        CHECK(pose.matrix().allFinite());
        CHECK(pose.linear().isUnitary(1e-12));
        CHECK(pose.linear().determinant() > 0);
      }
    }
  }
}

TEST_CASE("drawn targets differ from stream to stream, others know no stream, and neither the arm", "[path]") {
  const Robot arm = robot("kuka_iiwa14"), other_arm = robot("planar_2");
  for (const Path& path : with_points(5)) {
    INFO(path->name());
    Random random(Key(1)), again(Key(1)), other(Key(2)), untouched(Key(2));
    const std::vector<Pose> poses = path->poses(arm, random);
    CHECK(same_poses(path->poses(arm, again), poses));
    CHECK(same_poses(path->poses(arm, other), poses) == !path->is_random());
    CHECK((other.uniform() == untouched.uniform()) == !path->is_random());
    Random third(Key(1));
    CHECK(same_poses(path->poses(other_arm, third), poses) == !path->is_random());
  }
}

TEST_CASE("every kind of path has a name and words of its own", "[path]") {
  std::set<std::string_view> names, summaries;
  for (const Path& path : target_sets()) {
    CHECK(names.insert(path->name()).second);
    CHECK(summaries.insert(path->summary()).second);
    CHECK(path->summary().size() > 5);
  }
  CHECK(Study{}.path->name() == "helix");  // the default of study files
}

// ---- orientation --------------------------------------------------------------------------------------------------

TEST_CASE("both tools are rotations, and every point of a path has its tool's", "[path][paper]") {
  CHECK(tool_rotation(ToolOrientation::down) ==
        Eigen::Matrix3d(Eigen::Vector3d(-1, 1, -1).asDiagonal()));  // to the floor
  CHECK(rotation_from_rpy({pi, 0, pi}).isApprox(tool_rotation(ToolOrientation::down), 1e-15));
  CHECK(tool_rotation(ToolOrientation::eq27).col(2) == Eigen::Vector3d(0, 1, 0));  // level
  for (const ToolOrientation tool : {ToolOrientation::down, ToolOrientation::eq27}) {
    const Eigen::Matrix3d R = tool_rotation(tool);
    CHECK(R * R.transpose() == Eigen::Matrix3d::Identity());
    CHECK(R.determinant() == 1);
    const std::string name = tool == ToolOrientation::down ? "down" : "eq27";
    for (const Pose& pose : poses_of(path_of({"tool=" + name}))) CHECK(pose.linear() == R);
  }
}

TEST_CASE("a tool turns about its own axis, then about the vertical", "[path]") {
  const auto R = [](std::vector<std::string> fields) -> Eigen::Matrix3d {
    return poses_of(path_of(fields)).front().linear();
  };
  // Rolled by a quarter turn, its x axis is where its y axis was.
  CHECK(R({"tool_roll_deg=90"}).col(0).isApprox(Eigen::Vector3d::UnitY(), 1e-15));
  CHECK(R({"tool_roll_deg=90"}).col(2).isApprox(-Eigen::Vector3d::UnitZ(), 1e-15));
  // Eq. 27 points along y; a quarter turn back about the vertical, it points outward, along x.
  CHECK(R({"tool=eq27", "tool_yaw_deg=-90"}).col(2).isApprox(Eigen::Vector3d::UnitX(), 1e-15));
  CHECK(R({"tool=eq27", "tool_yaw_deg=-90", "tool_roll_deg=180"}).col(2).isApprox(Eigen::Vector3d::UnitX(), 1e-15));
}
