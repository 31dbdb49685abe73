// The independent verifier, which checks an answer after the clock has stopped. It has its own forward kinematics
// (plain 4x4 products of elementary transforms) and shares no code with robots/ except sine and cosine. The runner
// verifies each solve with it, and readers of a store verify the stored numbers again. Definitions of all numbers:
// docs/explanation/methods.md.
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
  bool is_axis_free = false;
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

// An answer to verify. The struct refers to values of the caller, so it is made in the call of `verify`.
struct Answered {
  const robots::Pose& target;
  const Eigen::VectorXd& start;   // [rad, m], all joints
  const Eigen::VectorXd& answer;  // [rad, m], all joints; may be not finite
  bool is_axis_free = false;      // the turn about the tool's z axis does not count
  int motion_joints = 0;          // joint motion is that of so many joints, from the first; 0: of all
};

// Returns the tool pose of a configuration, computed from the table of a Chain. For a Robot of a URDF file it is
// computed from the origins and axes of the file, so that the conversion to a table is verified, too.
Eigen::Matrix4d reference_pose(const robots::Chain& arm, const Eigen::VectorXd& q);
Eigen::Matrix4d reference_pose(const robots::Robot& arm, const Eigen::VectorXd& q);

// Verifies an answer. An answer that is not finite gives errors that are not finite.
Verification verify(const robots::Robot& robot, const Answered& answered);

// The requirements of an answer, besides being a finite configuration.
struct AcceptanceCriteria {
  double reported_error = 0;          // [m], as the solver reports it
  double report_tolerance = 0;        // [m] by which the report may be off, besides rounding
  double reported_pose_error = 0;     // [m], of three points of the tool, as solvers::Objective
  double rotation_weight = 0;         // [m]; 0: only positions are searched, so no pose error is reported
  solvers::StopRule stop = {};        // only the tolerances count
  bool orientation_is_exact = false;  // true if the closed form of the wrist completes answers
  bool limits_are_enforced = false;   // otherwise a violation is only recorded
};

// The distance [m] by which the self-reported error of a program may be off: rounding to single precision.
constexpr double program_report_tolerance = 1e-6;

// The multiple of its budget up to which a solver that stops by itself is not over budget.
constexpr double max_budget_ratio = 1.5;
// The cost of one solve.
struct ResourceUse {
  double seconds = 0;  // [s]
  std::int64_t evaluations = 0, iterations = 0;
};
// Returns true if a solver that stops by itself took more than `max_budget_ratio` times its budget.
bool exceeds_budget(const ResourceUse& used, const solvers::StopRule& budget);

// Returns the most severe fault of an answer, in the order of Status (results/record.hpp); `ok` if there is none. A
// difference of 1e-9 [m, rad] is rounding.
results::Status classify(const Verification& verified, const AcceptanceCriteria& criteria);

}  // namespace ikbench::experiments
