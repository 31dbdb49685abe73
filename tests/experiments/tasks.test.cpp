// Kinds of path besides the paper's, sets of random targets, and starts of solves: by hand, and by their promises.
#include "tests/experiments/samples.hpp"

namespace {

using std::numbers::pi;

Study study_of_robot(const std::string& robot, const std::string& text) {
  return read("robot = \"" + robot + "\"\nsearch = \"all_joints\"\n" + text + "\n[[solvers]]\nsolver = \"bat\"\n");
}

std::string refusal_of(const std::string& robot, const std::string& text) {
  return complaint<std::invalid_argument>([&] { study_of_robot(robot, text); });
}

Study random_targets(const std::string& robot, const std::string& set, int points = 50) {
  return study_of_robot(robot, "[path]\nkind = \"random\"\nset = \"" + set + "\"\npoints = " + std::to_string(points));
}

std::vector<Configuration> solutions_of(const Study& study, int run = 1) {
  Random random(Key(study.seed).with("targets").with(static_cast<std::uint64_t>(run)));
  return study.path->source_configurations(robot_of(study), random);
}

}  // namespace

TEST_CASE("the tool of a circle turns about the vertical", "[path]") {
  const std::vector<Pose> poses =
      poses_of(path_of({"kind=circle", "tool_turns_deg=180", "points=3", "spacing=k_over_n_minus_1"}));
  CHECK((poses[0].translation() - poses[2].translation()).norm() < 1e-15);
  Eigen::Matrix3d half_way;  // down is diag(-1, 1, -1); x becomes y and y becomes -x
  half_way << 0, -1, 0, -1, 0, 0, 0, 0, -1;
  CHECK((poses[1].linear() - half_way).norm() < 1e-15);
  Eigen::Matrix3d end = Eigen::Vector3d(1, -1, -1).asDiagonal();
  CHECK((poses[2].linear() - end).norm() < 1e-15);
}

// ---- sets of random targets ---------------------------------------------------------------------------------------

TEST_CASE("near limits, each joint is within 5 % of its range of one, on both sides", "[path][targets]") {
  const Study study = random_targets("ur5e", "near_limits", 200);
  const JointLimits limits = robot_of(study).limits;
  int at_lower = 0;
  const std::vector<Configuration> all = solutions_of(study);
  for (const Configuration& q : all) {
    const Eigen::ArrayXd share = (q - limits.lower).array() / (limits.upper - limits.lower).array();
    CHECK(((share >= 0) && (share <= 1)).all());
    CHECK(((share < 0.05) || (share > 0.95)).all());
    at_lower += static_cast<int>((share < 0.5).count());
  }
  CHECK(std::abs(at_lower - 600) < 100);  // of 1200 fair throws: 5.7 standard deviations
}

TEST_CASE("near singular, the manipulability is below that of 99 of 100 random configurations", "[path][targets]") {
  const Study near = random_targets("franka_panda", "near_singular", 20),
              anywhere = random_targets("franka_panda", "anywhere", 500);
  const Robot arm = robot_of(near);
  const auto manipulability = [&](const Configuration& q) {
    Matrix6Xd jacobian(6, q.size());
    arm.chain.pose_jacobian(q, jacobian);
    double volume = 1;  // that the rows span (Gram-Schmidt), the product of the singular values
    for (int row = 0; row < 6; ++row) {
      Eigen::RowVectorXd apart = jacobian.row(row);
      for (int before = 0; before < row; ++before) apart -= apart.dot(jacobian.row(before)) * jacobian.row(before);
      volume *= apart.norm();
      jacobian.row(row) = apart.normalized();
    }
    return volume;
  };
  double largest_near = 0;
  for (const Configuration& q : solutions_of(near)) largest_near = std::max(largest_near, manipulability(q));
  const auto below = std::ranges::count_if(solutions_of(anywhere),
                                           [&](const Configuration& q) { return manipulability(q) <= largest_near; });
  CHECK(below <= 20);  // of 500 at 1 %: 5 expected, more than 20 with a probability below 1e-6
}

TEST_CASE("at the edge the tool is beyond 95 % of the largest distance", "[path][targets]") {
  const Study edge = random_targets("ur5e", "edge", 30), anywhere = random_targets("ur5e", "anywhere", 300);
  const Eigen::Vector3d shoulder = robot_of(edge).chain.reach().centre;
  const auto distance = [&](const Pose& pose) { return (pose.translation() - shoulder).norm(); };
  double least = 1e9, most = 0;
  for (const Pose& pose : targets_of_run(edge, 1)) least = std::min(least, distance(pose));
  for (const Pose& pose : targets_of_run(anywhere, 1)) most = std::max(most, distance(pose));
  CHECK(least >= 0.94 * most);
}

TEST_CASE("unreachable targets are beyond the reach by the share that is asked for", "[path][targets]") {
  const Study study = study_of_robot("ur5e", "[path]\nkind = \"random\"\nset = \"unreachable\"\nbeyond_percent = 25");
  const Chain::Ball ball = robot_of(study).chain.reach();
  for (const Pose& pose : targets_of_run(study, 1)) {
    CHECK((pose.translation() - ball.centre).norm() == Approx(1.25 * ball.radius).epsilon(1e-12));
  }
  const SolveRecord solve = solve_once(study, study.solvers[0], targets_of_run(study, 1)[0]);
  CHECK(solve.position_error_cm >= 25 * ball.radius * (1 - 1e-12));
}

TEST_CASE("a set that an arm does not have is refused", "[path][targets]") {
  CHECK_THAT(refusal_of("stanford", "[path]\nkind = \"random\"\nset = \"unreachable\""),
             ContainsSubstring("my.toml:3:1: path.set is \"unreachable\", but the reach of stanford is not known"));
  const ScratchFolder folder;
  const std::string arm = (folder.path / "endless.toml").string();
  write_text(arm, "summary = \"s\"\nsource = \"s\"\nlinks = [{ a_m = 0.5, limits_deg = \"none\" }]\n");
  CHECK_THAT(refusal_of(arm, "[path]\nkind = \"random\"\nset = \"near_limits\""),
             ContainsSubstring("no joint of endless has limits"));
  CHECK(refusal_of("stanford", "[path]\nkind = \"random\"\nset = \"edge\"").empty());
}

TEST_CASE("every set is made of its solutions, the same again, and more of them begin with fewer", "[path][targets]") {
  for (const std::string set : {"anywhere", "near_limits", "near_singular", "edge"}) {
    CAPTURE(set);
    const Study fewer = random_targets("ur5e", set, 3), more = random_targets("ur5e", set, 5);
    const std::vector<Pose> poses = targets_of_run(fewer, 2);
    const std::vector<Configuration> solutions = solutions_of(more, 2);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      CHECK(poses[i].matrix() == robot_of(fewer).chain.forward(solutions[i]).matrix());
      CHECK(poses[i].matrix() == targets_of_run(more, 2)[i].matrix());
    }
    CHECK(targets_of_run(fewer, 1)[0].matrix() != poses[0].matrix());
  }
}

// ---- starts -------------------------------------------------------------------------------------------------------

TEST_CASE("solves start in the middle of the limits, or at zero where a joint turns without end", "[starts]") {
  const Study study = study_of_robot("kinova_gen3", "start = \"middle\"\n[path]\nkind = \"random\"\npoints = 2");
  const Robot arm = robot_of(study);
  for (const Configuration& start : starts_of_run(study, arm, 1)) {
    for (Eigen::Index j = 0; j < start.size(); ++j) {
      const double lower = arm.limits.lower[j], upper = arm.limits.upper[j];
      CHECK(start[j] == (std::isfinite(lower) ? (lower + upper) / 2 : 0));
    }
  }
  CHECK(starts_of_run(study, arm, 1).size() == 2);
}

TEST_CASE("random starts are within the limits, of their own for every run and point", "[starts]") {
  const Study study = study_of_robot("ur5e", "start = \"random\"\n[path]\nkind = \"circle\"\npoints = 50");
  const Robot arm = robot_of(study);
  const std::vector<Configuration> first = starts_of_run(study, arm, 1), again = starts_of_run(study, arm, 1),
                                   second = starts_of_run(study, arm, 2);
  CHECK(first == again);
  for (std::size_t i = 0; i < first.size(); ++i) {
    CHECK(arm.limits.violation(first[i]) == 0);
    CHECK(first[i] != second[i]);
    if (i > 0) CHECK(first[i] != first[i - 1]);
  }
}

TEST_CASE("near starts are as far from the solution as near_deg allows, and inside the limits", "[starts]") {
  const Study study = study_of_robot(
      "stanford", "start = \"near\"\nnear_deg = 2\n[path]\nkind = \"random\"\nset = \"near_limits\"\npoints = 100");
  const std::vector<Configuration> near = starts_of_run(study, robot_of(study), 3), solutions = solutions_of(study, 3);
  double farthest = 0;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const Configuration away = (near[i] - solutions[i]).cwiseAbs();
    farthest = std::max(farthest, away.maxCoeff());
    CHECK(away[2] == 0);  // it slides
    CHECK(robot_of(study).limits.violation(near[i]) == 0);
  }
  CHECK(farthest <= 2 * pi / 180);
  CHECK(farthest > 1.9 * pi / 180);
}

TEST_CASE("near starts need targets that are made of configurations", "[starts]") {
  for (const std::string path : {"kind = \"circle\"", "kind = \"random\"\nset = \"unreachable\""}) {
    CHECK_THAT(
        refusal_of("ur5e", "start = \"near\"\n[path]\n" + path),
        ContainsSubstring("my.toml:3:9: start is \"near\", but the path's targets are not made of configurations"));
  }
}

TEST_CASE("every solver starts where the study says, run after run and from a store that has some", "[starts]") {
  for (const std::string start : {"initial", "middle", "random", "near"}) {
    CAPTURE(start);
    Study study = study_of_robot(
        "ur5e", "start = \"" + start +
                    "\"\npopulation = 4\nruns = 2\n[stop]\niterations = 3\n[path]\nkind = \"random\"\npoints = 3");
    study.solvers.push_back({"other", "particle_swarm", {}});
    for (const SolveRecord& solve : solve_all(study)) {
      const Configuration expected =
          start == "initial"
              ? Configuration(study.initial)
              : starts_of_run(study, robot_of(study), solve.run)[static_cast<std::size_t>(solve.point - 1)];
      CHECK(std::ranges::equal(solve.start_rad, expected));
    }
    ScratchStore store;
    const std::vector<SolveRecord> whole = solve_all(study);
    study.runs = 1;
    run(study, store, {});
    study.runs = 2;
    run(study, store, {});
    CHECK(same_numbers(solves_of(store, study.name), whole));
  }
}
