#include "experiments/task.hpp"

#include <cmath>

#include "solvers/bounds.hpp"

namespace ikbench::experiments {

using namespace robots;
using namespace solvers;

namespace {

Chain without_last(const Chain& whole) {
  const std::vector<DhLink>& links = whole.links();
  return Chain({links.begin(), links.end() - 1}, whole.base(),
               {.position = {0, 0, links.back().d + whole.tool().position.z()}});
}

}  // namespace

bool rotates_tool_only(const Chain& whole) {
  const DhLink& last = whole.links().back();
  return whole.joints() > 1 && last.joint == Joint::turns && last.a == 0 && last.alpha == 0 && last.beta == 0 &&
         whole.tool().position.head<2>().isZero(0);
}

Task::Task(const Study& study, const Robot& arm)
    : study_(study),
      arm_(arm),
      wrist_(study.search == Search::wrist ? std::optional<SphericalWrist>(arm.chain) : std::nullopt),
      searched_(wrist_                           ? wrist_->arm()
                : study.search == Search::flange ? without_last(arm.chain)
                                                 : arm.chain) {}

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
    for (Eigen::Vector3d& branch : branches)
      for (Eigen::Index j = 0; j < 3 && study_.wrist_turns == WristTurns::nearest; ++j)
        branch[j] = near[j] + std::remainder(branch[j] - near[j], whole_turn);
    answer.resize(found.size() + 3);
    answer << found, branches[select_branch(branches, near)];
  } else if (study_.search == Search::flange) {
    answer = start;
    answer.head(found.size()) = found;
  }
  wrap(answer, start);
  return answer;
}

void Task::wrap(Configuration& answer, const Configuration& start) const {
  if (study_.wrap == WrapPolicy::no) return;
  for (Eigen::Index j = 0; j < answer.size(); ++j) {
    if (arm_.chain.slides(j)) continue;
    if (study_.wrap == WrapPolicy::nearest) answer[j] += whole_turn * std::round((start[j] - answer[j]) / whole_turn);
    answer[j] = turned_inside(answer[j], arm_.limits.lower[j], arm_.limits.upper[j]);
  }
}

std::size_t Task::select_branch(const std::array<Eigen::Vector3d, 2>& branches, const Eigen::Vector3d& near) const {
  const std::size_t nearer = (branches[0] - near).norm() <= (branches[1] - near).norm() ? 0 : 1;
  const auto is_inside = [&](const Eigen::Vector3d& angles) {
    return (angles.array() >= arm_.limits.lower.tail<3>().array()).all() &&
           (angles.array() <= arm_.limits.upper.tail<3>().array()).all();
  };
  const std::size_t first = study_.wrist_branch == WristBranch::positive   ? 0
                            : study_.wrist_branch == WristBranch::negative ? 1
                                                                           : nearer;
  const bool is_to_be_inside = study_.wrist_branch == WristBranch::inside || study_.limits == LimitPolicy::enforced;
  return is_to_be_inside && !is_inside(branches[first]) && is_inside(branches[1 - first]) ? 1 - first : first;
}

}  // namespace ikbench::experiments
