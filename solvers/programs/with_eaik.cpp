// source = eaik==1.2.2
// flags = $(printf -- '-I CPP/%s ' src src/IK src/utils src/IK/utils external/ik-geo/cpp/subproblems)
// flags = $(find CPP -name '*.cpp' ! -path '*Tests*')
// EAIK as with_eaik.py asks it: of seven joints the last that works is locked at one of 64 values, each an arm derived
// once: that nearest to the start, then random ones. Of the answers inside the limits the one nearest to the start is
// given.
#include "EAIK.h"
#include "library.hpp"

struct Arm {
  Eigen::MatrixXd axes, ways;
  Eigen::Matrix3d tool;
  int lock = -1;  // none
  std::vector<bool> turns;
  double lowest = 0, step = 1;  // of the locked joint's values
  std::vector<EAIK::Robot> robots;

  EAIK::Robot locked(double value) const {
    std::vector<std::pair<int, double>> locks;
    if (lock >= 0) locks.emplace_back(lock, value);
    return {axes, ways, tool, locks, true};
  }
  // Derives an arm for each of 64 values inside the limits of the locked joint, or the only one where none is locked.
  void derive(const ikbench::Robot& robot) {
    if (lock < 0) {
      robots.push_back(locked(0));
      return;
    }
    const ikbench::Json& joint = robot.message["joints"].list[static_cast<std::size_t>(lock)];
    const bool is_endless = !std::isfinite(joint["lower"].number);
    const double low = is_endless ? -M_PI : joint["lower"].number, high = is_endless ? M_PI : joint["upper"].number;
    step = (high - low) / 64;
    lowest = low + step / 2;
    for (int i = 0; i < 64; ++i) robots.push_back(locked(lowest + i * step));
  }
  const EAIK::Robot& nearest(const Values& start) const {
    if (lock < 0) return robots.front();
    const double i = std::round((start[static_cast<std::size_t>(lock)] - lowest) / step);
    return robots[static_cast<std::size_t>(std::clamp(i, 0.0, static_cast<double>(robots.size() - 1)))];
  }
};

std::vector<Values> exact(const EAIK::Robot& robot, const Eigen::Matrix4d& target) {
  const IKS::IK_Solution found = robot.calculate_IK(target);
  std::vector<Values> answers;
  for (std::size_t i = 0; i < found.Q.size(); ++i)
    if (!found.is_LS_vec[i]) answers.push_back(found.Q[i]);
  return answers;
}

// Also where the tool is with all joints at 0.3.
std::pair<Arm, Eigen::Matrix4d> arm_of(const ikbench::Robot& robot) {
  const std::vector<ikbench::Json>& joints = robot.message["joints"].list;
  const Eigen::Index n = static_cast<Eigen::Index>(joints.size());
  Arm arm{Eigen::MatrixXd(3, n), Eigen::MatrixXd(3, n + 1), {}, -1, robot.turns};
  Eigen::Matrix4d zero = matrix(robot.message["base"].numbers()), moved = zero, turn = Eigen::Matrix4d::Identity();
  turn.topLeftCorner<3, 3>() = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < n; ++i) {
    arm.axes.col(i) = zero.block<3, 1>(0, 2);
    arm.ways.col(i) = zero.block<3, 1>(0, 3) - before;
    before = zero.block<3, 1>(0, 3);
    zero *= link(joints[i]);
    moved *= turn * link(joints[i]);
  }
  const Eigen::Matrix4d tool = matrix(robot.message["tool"].numbers());
  zero *= tool;
  arm.ways.col(n) = zero.block<3, 1>(0, 3) - before;
  arm.tool = zero.topLeftCorner<3, 3>();
  return {std::move(arm), moved * tool};
}

Arm prepare(const ikbench::Robot& robot) {
  require(robot, true);
  auto [arm, target] = arm_of(robot);
  const int n = static_cast<int>(robot.turns.size());
  for (arm.lock = n == 7 ? 6 : -1; n <= 7 && arm.lock >= (n == 7 ? 0 : -1); --arm.lock) {
    const EAIK::Robot derived = arm.locked(0.3);
    if (!derived.has_known_decomposition() || exact(derived, target).empty()) continue;
    arm.derive(robot);
    return std::move(arm);
  }
  throw ikbench::Declined{"no kinematic family that EAIK knows"};
}

Values solve(Arm& arm, ikbench::Problem& problem) {
  const Eigen::Matrix4d target = target_of(problem);
  return from_starts(problem, [&](const Values& start) {
    Values nearest;
    double least = std::numeric_limits<double>::infinity();
    for (Values& q : exact(arm.nearest(start), target)) {
      for (std::size_t j = 0; j < q.size(); ++j)
        q[j] = problem.start[j] + std::remainder(q[j] - problem.start[j], 2 * M_PI);
      q = ikbench::inside(q, arm.turns, problem.lower, problem.upper);
      double way = 0;
      for (std::size_t j = 0; j < q.size(); ++j)
        way += q[j] < problem.lower[j] || q[j] > problem.upper[j] ? least : std::pow(q[j] - problem.start[j], 2);
      if (way < least) least = way, nearest = q;
    }
    return nearest;
  });
}

int main() { ikbench::run("eaik", {}, prepare, solve, R"(["pose"])"); }
