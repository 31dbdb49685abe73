// The independent verifier, which checks an answer after the clock has stopped. It has its own forward kinematics
// (plain 4x4 products of elementary transforms) and shares no code with robots/ except sine and cosine.
#pragma once

#include "results/record.hpp"
#include "robots/robot.hpp"
#include "solvers/solver.hpp"

namespace ikbench::experiments {

// The verified numbers of an answer.
struct Verification {
  Eigen::Vector3d reached = Eigen::Vector3d::Zero();  // position of the tool [m]
  double position_error = 0;                          // [m], Eq. 1
  // If the turn about the tool's z axis is free, Rd is turned about that axis to where it is nearest to R.
  bool turns_freely = false;
  double orientation_error = 0;  // ||R - Rd|| / ||Rd||, Eq. 3
  double angle = 0;              // between R and Rd [rad], 0 to pi
  // The reached frame minus the target: x, y and z axes of the tool as unit vectors, and its point [m].
  Eigen::Matrix<double, 3, 4> pose_difference = Eigen::Matrix<double, 3, 4>::Zero();
  // Revolute joints [rad] and prismatic joints [m] (_m) are never added. A continuous joint moves the shorter way
  // round.
  double joint_motion = 0, joint_motion_m = 0;        // Eq. 12
  double largest_move = 0;                            // [rad], of one revolute joint
  double limit_violation = 0, limit_violation_m = 0;  // of the worst joint; 0 inside and up to 1e-9 outside
};

// Returns the tool pose of a configuration by the verifier's own route. For a Chain that is its table. For a Robot from
// a URDF file it is the origins and axes of the file, so that their conversion to a table is verified, too.
Eigen::Matrix4d reference_pose(const robots::Chain& arm, const Eigen::VectorXd& q);
Eigen::Matrix4d reference_pose(const robots::Robot& arm, const Eigen::VectorXd& q);

// Verifies an answer. `answer` and `start` have all joints of the robot. An answer that is not finite gives errors that
// are not finite. With `turns_freely` the turn about the tool's z axis is free. Joint motion is that of the first
// `motion_joints` joints; 0: of all.
Verification verify(const robots::Robot& robot, const robots::Pose& target, const Eigen::VectorXd& start,
                    const Eigen::VectorXd& answer, bool turns_freely = false, int motion_joints = 0);

// The requirements of an answer, besides being a finite configuration.
struct AcceptanceCriteria {
  double reported_error = 0;          // [m], as the solver reports it
  double report_tolerance = 0;        // [m] that it may be off, besides rounding
  double reported_pose_error = 0;     // [m], of three points of the tool, as solvers::Objective
  double rotation_weight = 0;         // [m]; 0: only positions are searched, without a pose claim
  solvers::StopRule stop = {};        // only the tolerances count
  bool orientation_is_exact = false;  // true if the closed form of the wrist completes answers
  bool limits_are_enforced = false;   // otherwise a violation is only recorded
};

// How far [m] the self-reported error of a program may be off: rounding to single precision.
constexpr double program_report_tolerance = 1e-6;

// The share of its budget up to which a solver that stops by itself is not over budget.
constexpr double max_budget_ratio = 1.5;
// The cost of one solve.
struct ResourceUse {
  double seconds = 0;
  std::int64_t evaluations = 0, iterations = 0;
};
// Returns true if a solver that stops by itself took more than `max_budget_ratio` times its budget.
bool exceeds_budget(const ResourceUse& spent, const solvers::StopRule& budget);

// Returns the most severe fault of an answer, in the order of Status (results/record.hpp). A difference of 1e-9 (m,
// rad) is rounding.
results::Status classify(const Verification& verified, const AcceptanceCriteria& requirement);

}  // namespace ikbench::experiments
