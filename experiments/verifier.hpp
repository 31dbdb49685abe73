// The independent verifier: looks at an answer after the clock has stopped, by a forward kinematics of its own
// (plain 4x4 products of elementary transforms, no code shared with robots/ but sine and cosine).
#pragma once

#include "results/record.hpp"
#include "robots/robot.hpp"

namespace ikbench::experiments {

struct Verification {
  Eigen::Vector3d reached = Eigen::Vector3d::Zero();  // position of the tool [m]
  double position_error = 0;                          // [m], Eq. 1
  double orientation_error = 0;                       // ||R - Rd|| / ||Rd||, Eq. 3
  double angle = 0;                                   // between R and Rd [rad], 0 to pi
  // By how much the tool is off: its x, y and z axes, as unit vectors, and its point [m].
  Eigen::Matrix<double, 3, 4> off = Eigen::Matrix<double, 3, 4>::Zero();
  // Of the joints that turn [rad], and of those that slide [m]; never added. A joint that turns without end moves the
  // shorter way round.
  double variation = 0, variation_m = 0;              // Eq. 12, over all joints
  double largest_move = 0, largest_move_m = 0;        // of a single joint
  double limit_violation = 0, limit_violation_m = 0;  // of the worst joint; 0 inside, and up to 1e-9
  // From the nearest limit of all joints, as a share of that joint's range: 0.5 in the middle of each, negative
  // outside; NaN for an arm without limits.
  double limit_margin = 0;
  // Of the geometric Jacobian's singular values (singular_values.hpp): the smallest, and the product of all.
  double smallest_singular_value = 0, manipulability = 0;
};

// Tool pose of a configuration by the verifier's own route: that of the table, or of an arm from a URDF file that of
// its origins and axes, so that what was made of them is verified too.
Eigen::Matrix4d verified_pose(const robots::Chain& arm, const Eigen::VectorXd& q);
Eigen::Matrix4d verified_pose(const robots::Robot& arm, const Eigen::VectorXd& q);

// `answer` and `start` have all joints of the robot. A non-finite answer gives non-finite errors.
Verification verify(const robots::Robot& robot, const robots::Pose& target, const Eigen::VectorXd& start,
                    const Eigen::VectorXd& answer);

// Into the columns that say it.
void write_verified(const Verification& verified, results::SolveRecord& solve);

// What the study gives a program that stops by itself; 0: no end.
struct Budget {
  double seconds = 0;
  double evaluations = 0;
};

// What is asked of an answer besides being a finite configuration.
struct Requirement {
  double claimed_error = 0;           // [m], as the solver reports it
  double claimed_pose_error = 0;      // [m], of three points of the tool: as solvers::Objective has it
  double rotation_weight = 0;         // [m]; 0: the position alone was searched, and there is no such claim
  double tolerance = 0;               // [m]; 0: none
  double angle_tolerance = 0;         // [rad]; 0: none
  bool orientation_is_exact = false;  // the closed form of the wrist sets it
  bool limits_are_enforced = false;   // otherwise a violation is only recorded
  Budget budget = {};                 // of a program; is_over() asks it
};

constexpr double most_of_budget = 1.5;
// Whether a program took more than that many times its budget. Messages, and waiting for a processor, are not its own.
bool is_over(const results::SolveRecord& solve, const Budget& budget);

// The most severe thing that is wrong with an answer, in the order of Status' description (results/record.hpp).
// A difference of 1e-9 (m, rad) is rounding.
results::Status judge(const Verification& verified, const Requirement& requirement);

}  // namespace ikbench::experiments
