#include "experiments/task.hpp"

#include <cmath>

#include "solvers/bounds.hpp"

namespace ikbench::experiments {

using namespace robots;
using namespace solvers;

namespace {

// Returns the arm before its last joint, with the tool's point, which that joint does not move.
Chain without_last(const Chain& whole) {
  const std::vector<DhLink>& links = whole.links();
  return Chain({links.begin(), links.end() - 1}, whole.base(),
               {.position = {0, 0, links.back().d + whole.tool().position.z()}});
}

// Returns the joints that a study searches: those before the wrist if there is one, those before the flange, or all.
Chain searched_chain(const Study& study, const Robot& arm, const std::optional<SphericalWrist>& wrist) {
  if (wrist) return wrist->arm();
  return study.search == Search::flange ? without_last(arm.chain) : arm.chain;
}

// Turns the wrist's angles [rad] by whole turns to where they are nearest to `near`.
void turn_near(Eigen::Vector3d& angles, const Eigen::Vector3d& near) {
  for (Eigen::Index j = 0; j < 3; ++j) angles[j] = near[j] + std::remainder(angles[j] - near[j], whole_turn);
}

}  // namespace

bool rotates_tool_only(const Chain& whole) {
  const DhLink& last = whole.links().back();
  return whole.joints() > 1 && last.joint == Joint::turns && last.a == 0 && last.alpha == 0 && last.beta == 0 &&
         whole.tool().position.head<2>().isZero(0);
}

void wrap(Configuration& answer, const Configuration& start, const JointLimits& limits, const Chain& chain,
          WrapPolicy policy) {
  if (policy == WrapPolicy::no) return;
  for (Eigen::Index j = 0; j < answer.size(); ++j) {
    if (chain.slides(j)) continue;
    if (policy == WrapPolicy::nearest) answer[j] += whole_turn * std::round((start[j] - answer[j]) / whole_turn);
    answer[j] = turned_inside(answer[j], limits.lower[j], limits.upper[j]);
  }
}

Task::Task(const Study& study, const Robot& arm)
    : study_(study),
      arm_(arm),
      wrist_(study.search == Search::wrist ? std::optional<SphericalWrist>(arm.chain) : std::nullopt),
      searched_(searched_chain(study, arm, wrist_)) {}

Goal Task::goal(const Pose& target) const {
  if (const GoalKind kind = goal_kind(study_.search); kind != GoalKind::position)
    return {target, study_.rotation_weight, kind};
  return wrist_ ? wrist_->centre(target) : Eigen::Vector3d(target.translation());
}

Problem Task::problem(const Configuration& start, int population) const {
  const int joints = arm().joints();
  return {.start = start.head(joints),
          .lower = arm_.limits.lower.head(joints),
          .upper = arm_.limits.upper.head(joints),
          .population = population};
}

Configuration Task::with_wrist(const Configuration& found, const Pose& target, const Configuration& start) const {
  Configuration answer = found;
  if (wrist_) {
    const Eigen::Vector3d near = start.tail<3>();
    std::array<Eigen::Vector3d, 2> branches = wrist_->angles(found, target.linear(), near);
    if (study_.wrist_turns == WristTurns::nearest) {
      for (Eigen::Vector3d& branch : branches) turn_near(branch, near);
    }
    answer.resize(found.size() + 3);
    answer << found, branches[select_branch(branches, near)];
  } else if (study_.search == Search::flange) {
    answer = start;
    answer.head(found.size()) = found;
  }
  wrap(answer, start, arm_.limits, arm_.chain, study_.wrap);
  return answer;
}

std::size_t Task::preferred_branch(const std::array<Eigen::Vector3d, 2>& branches, const Eigen::Vector3d& near) const {
  switch (study_.wrist_branch) {
    case WristBranch::positive:
      return 0;
    case WristBranch::negative:
      return 1;
    case WristBranch::nearest:
    case WristBranch::inside:
      break;
  }
  return (branches[0] - near).norm() <= (branches[1] - near).norm() ? 0 : 1;
}

std::size_t Task::select_branch(const std::array<Eigen::Vector3d, 2>& branches, const Eigen::Vector3d& near) const {
  const auto is_inside = [&](const Eigen::Vector3d& angles) {
    return (angles.array() >= arm_.limits.lower.tail<3>().array()).all() &&
           (angles.array() <= arm_.limits.upper.tail<3>().array()).all();
  };
  const std::size_t preferred = preferred_branch(branches, near);
  const std::size_t alternative = 1 - preferred;
  const bool must_be_inside = study_.wrist_branch == WristBranch::inside || study_.limits == LimitPolicy::enforced;
  return must_be_inside && !is_inside(branches[preferred]) && is_inside(branches[alternative]) ? alternative
                                                                                               : preferred;
}

}  // namespace ikbench::experiments
