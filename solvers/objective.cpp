// Here and not in the header, because they are timed: folders that include it are compiled with -O1.
#include "solvers/objective.hpp"

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
  if (goal_.kind == GoalKind::pose) {
    arm_.pose_errors(q, goal_.target, goal_.rotation_weight, errors);
  } else if (goal_.kind == GoalKind::axis) {
    arm_.axis_errors(q, goal_.target, goal_.rotation_weight, errors);
  } else {
    arm_.position_errors(q, goal_.target.translation(), errors);
  }
}

Residual Objective::evaluate_linear(const robots::ConfigurationRef& q, Eigen::Ref<Eigen::MatrixXd> jacobian) {
  if (!goal_.has_direction()) return goal_.target.translation() - arm_.position_jacobian(q, jacobian.topRows<3>());
  const robots::Pose reached = arm_.pose_jacobian(q, jacobian.topRows<6>());
  const Eigen::Vector3d z = reached.linear().col(2);
  for (Eigen::Index j = 0; j < jacobian.cols() && goal_.kind == GoalKind::axis; ++j)
    jacobian.col(j).tail<3>() -= z.dot(jacobian.col(j).tail<3>()) * z;
  jacobian.bottomRows<3>() *= goal_.rotation_weight;
  Residual residual(6);
  residual << goal_.target.translation() - reached.translation(), goal_.rotation_weight * turn_from(reached.linear());
  return residual;
}

}  // namespace ikbench::solvers
