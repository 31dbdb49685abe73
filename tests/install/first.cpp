// Forward kinematics and one solve, with the installed libraries: docs/reference/api.md.
#include <cstdio>
#include <ikbench.hpp>

using namespace ikbench;

int main() {
  const robots::Robot arm = robots::robot("ur5e");                        // a file: load_robot("my_arm.urdf")
  const Eigen::Vector<double, 6> joints{0.1, -1.2, 1.4, -0.3, 1.1, 0.5};  // [rad]
  const robots::Pose target = arm.chain.forward(joints);
  std::printf("the tool is at (%.6f, %.6f, %.6f) m\n", target(0, 3), target(1, 3), target(2, 3));
  const experiments::Study study = experiments::parse_study(
      "robot = 'ur5e'\nsearch = 'pose'\nstart = 'middle'\npath = { kind = 'random' }\n"
      "stop = { iterations = 1000, tolerance_cm = 0.0001, tolerance_deg = 0.001 }\n"
      "solvers = [{ solver = 'damped_least_squares' }]\n",
      "my study");
  const results::SolveRecord solve = experiments::solve_once(study, study.solvers.front(), target);
  std::printf("%s, %.1e cm:", results::name_of(solve.status).data(), solve.position_error_cm);
  for (const double angle : solve.answer_rad) std::printf(" %.6f", angle);
  std::puts("");
}
