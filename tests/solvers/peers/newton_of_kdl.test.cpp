// KDL's own ChainIkSolverPos_NR_JL beside our `newton`, on the same poses.
#include "tests/solvers/objectives.hpp"

TEST_CASE("newton without restarts solves the poses that KDL solves, from the middle of the limits",
          "[newton][peers]") {
  const std::vector<MissingPeer> missing = missing_peers();
  if (std::ranges::find(missing, "kdl_newton", &MissingPeer::name) != missing.end()) return;
  // The two round differently, and a long descent that bounces off limits may end elsewhere for that. So few in 100 may
  // differ; two independent samples of 300 poses, which KDL solves with the probability p, would differ in 2 p (1 - p).
  constexpr int poses = 300, most_iterations = 100;
  constexpr double tolerance = 1e-5;  // [m], [rad]; KDL's of each coordinate
  const auto newton = solver("newton").make({{"restarts", "none"}});
  const auto kdl = solver("kdl_newton").make({{"accuracy", 1e-5}});
  for (const auto& [name, printed] : {std::pair("abb_irb120", 0.3941), std::pair("franka_panda", 0.6177)}) {
    const Robot arm = robot(name);
    const Eigen::VectorXd middle = (arm.limits.lower + arm.limits.upper) / 2;
    Random random{Key(2015)};
    int solved_by_kdl = 0, solved_by_us = 0, differ = 0;
    for (int pose = 0; pose < poses; ++pose) {
      Eigen::VectorXd q(arm.joints());
      for (Eigen::Index j = 0; j < q.size(); ++j) q[j] = random.uniform(arm.limits.lower[j], arm.limits.upper[j]);
      const Pose T = arm.chain.forward(q);
      const auto is_solved_by = [&](Solver& solver, int iterations) {
        Objective objective(arm.chain, {T, 0.3});
        const Problem problem{
            .start = middle, .lower = arm.limits.lower, .upper = arm.limits.upper, .iterations = most_iterations};
        const Solution solution =
            solve(solver, problem, objective, random,
                  {.iterations = iterations, .tolerance = 2 * tolerance, .angle_tolerance = 2 * tolerance});
        return solution.stopped == StopReason::tolerance;
      };
      const bool by_kdl = is_solved_by(*kdl, most_iterations), by_us = is_solved_by(*newton, most_iterations - 1);
      solved_by_kdl += by_kdl ? 1 : 0;
      solved_by_us += by_us ? 1 : 0;
      differ += by_kdl != by_us ? 1 : 0;
    }
    CAPTURE(name, solved_by_kdl, solved_by_us, differ);
    CHECK(differ <= poses / 50);
    // The rate that Beeson and Ames print, within 4 standard errors.
    for (const int solved : {solved_by_kdl, solved_by_us}) {
      CHECK(std::abs(solved - poses * printed) < 4 * std::sqrt(poses * printed * (1 - printed)));
    }
  }
}
