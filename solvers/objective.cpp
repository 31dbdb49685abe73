// Here and not in the header, because they are timed: folders that include it are compiled with -O1.
#include "solvers/objective.hpp"

#include "robots/rotation.hpp"

namespace ikbench::solvers {

Deviation Objective::deviation(const robots::ConfigurationRef& q) const {
  const robots::Pose reached = arm_.forward(q);
  return {.position = (goal_.target.translation() - reached.translation()).norm(),
          .angle = robots::rotation_vector(goal_.target.linear() * reached.linear().transpose()).norm()};
}

void Objective::evaluate(const robots::CandidatesRef& q, Eigen::Ref<Eigen::VectorXd> errors) {
  if (goal_.is_pose()) {
    arm_.pose_errors(q, goal_.target, goal_.rotation_weight, errors);
  } else {
    arm_.position_errors(q, goal_.target.translation(), errors);
  }
}

Residual Objective::evaluate_linear(const robots::ConfigurationRef& q, Eigen::Ref<Eigen::MatrixXd> jacobian) {
  if (!goal_.is_pose()) return goal_.target.translation() - arm_.position_jacobian(q, jacobian.topRows<3>());
  const robots::Pose reached = arm_.pose_jacobian(q, jacobian.topRows<6>());
  jacobian.bottomRows<3>() *= goal_.rotation_weight;
  Residual residual(6);
  residual << goal_.target.translation() - reached.translation(),
      goal_.rotation_weight * robots::rotation_vector(goal_.target.linear() * reached.linear().transpose());
  return residual;
}

}  // namespace ikbench::solvers
