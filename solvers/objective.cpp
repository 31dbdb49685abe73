// Functions that are not in the header because they are timed: folders that include the header are compiled with -O1.
#include "solvers/objective.hpp"

#include <cmath>

#include "numerics/functions.hpp"
#include "robots/rotation.hpp"

namespace ikbench::solvers {

Deviation Objective::deviation(const robots::ConfigurationRef& q) const {
  const robots::Pose reached = arm_.forward(q);
  return {.position = (goal_.target.translation() - reached.translation()).norm(),
          .angle = turn_from(reached.linear()).norm()};
}

Eigen::Vector3d Objective::turn_from(const Eigen::Matrix3d& reached) const {
  if (goal_.kind == GoalKind::axis) return robots::shortest_turn(reached.col(2), goal_.target.linear().col(2));
  return robots::rotation_vector(goal_.target.linear() * reached.transpose());
}

void Objective::evaluate(const robots::CandidatesRef& q, Eigen::Ref<Eigen::VectorXd> errors) {
  if (goal_.has_direction())
    return arm_.pose_errors(q, goal_.target, goal_.rotation_weight, errors, goal_.kind == GoalKind::axis);
  arm_.position_errors(q, goal_.target.translation(), errors);
}

Linearized Objective::evaluate_linear(const robots::ConfigurationRef& q, Eigen::Ref<Eigen::MatrixXd> jacobian) {
  if (!goal_.has_direction()) {
    const Eigen::Vector3d away = goal_.target.translation() - arm_.position_jacobian(q, jacobian.topRows<3>());
    return {away.norm(), away};
  }
  const robots::Pose reached = arm_.pose_jacobian(q, jacobian.topRows<6>());
  const Eigen::Vector3d z = reached.linear().col(2);
  for (Eigen::Index j = 0; j < jacobian.cols() && goal_.kind == GoalKind::axis; ++j)
    jacobian.col(j).tail<3>() -= numerics::dot(z, jacobian.col(j).tail<3>()) * z;
  jacobian.bottomRows<3>() *= goal_.rotation_weight;

  const Eigen::Vector3d away = goal_.target.translation() - reached.translation();
  const Eigen::Matrix3d axes_away = goal_.rotation_weight * (goal_.target.linear() - reached.linear());
  // The error's three points; those of an axis lie on both sides of the tool.
  const double squares = goal_.kind == GoalKind::axis ? 3 * away.squaredNorm() + 2 * axes_away.col(2).squaredNorm()
                                                      : away.squaredNorm() + (away + axes_away.col(0)).squaredNorm() +
                                                            (away + axes_away.col(1)).squaredNorm();
  Residual to_go(6);
  to_go << away, goal_.rotation_weight * turn_from(reached.linear());
  return {std::sqrt(squares / 3), to_go};
}

}  // namespace ikbench::solvers
