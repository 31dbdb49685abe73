// The independent verifier checks an answer after the clock has stopped, with its own forward kinematics (plain 4x4
// products of elementary transforms, no code shared with robots/ except sine and cosine).
#pragma once

#include "results/record.hpp"
#include "robots/robot.hpp"
#include "solvers/solver.hpp"

namespace ikbench::experiments {

struct Verification {
  Eigen::Vector3d reached = Eigen::Vector3d::Zero();  // position of the tool [m]
  double position_error = 0;                          // [m], Eq. 1
  // Where the turn about the tool's z axis is free, Rd is turned about it to where it is nearest to R.
  bool turns_freely = false;
  double orientation_error = 0;  // ||R - Rd|| / ||Rd||, Eq. 3
  double angle = 0;              // between R and Rd [rad], 0 to pi
  // Reached minus target: the tool's x, y and z axes as unit vectors, and its point [m].
  Eigen::Matrix<double, 3, 4> off = Eigen::Matrix<double, 3, 4>::Zero();
  // Joints that turn [rad] and joints that slide [m] (_m) are never added. A joint that turns without end moves the
  // shorter way round.
  double variation = 0, variation_m = 0;              // Eq. 12
  double largest_move = 0;                            // of one joint that turns
  double limit_violation = 0, limit_violation_m = 0;  // of the worst joint; 0 inside and up to 1e-9 outside
};

// Tool pose of a configuration by the verifier's own route. A Chain is its table. A Robot from a URDF file is its
// origins and axes, so that their conversion to a table is verified too.
Eigen::Matrix4d verified_pose(const robots::Chain& arm, const Eigen::VectorXd& q);
Eigen::Matrix4d verified_pose(const robots::Robot& arm, const Eigen::VectorXd& q);

// `answer` and `start` have all joints of the robot. A non-finite answer gives non-finite errors. With `turns_freely`
// the turn about the tool's z axis is free. The variation is that of so many joints from the first; 0: of all.
Verification verify(const robots::Robot& robot, const robots::Pose& target, const Eigen::VectorXd& start,
                    const Eigen::VectorXd& answer, bool turns_freely = false, int motion_joints = 0);

// The requirements of an answer, besides being a finite configuration.
struct Requirement {
  double claimed_error = 0;           // [m], as the solver reports it
  double claim_slack = 0;             // [m]; it may be off by this, besides rounding
  double claimed_pose_error = 0;      // [m], of three points of the tool, as solvers::Objective
  double rotation_weight = 0;         // [m]; 0: only positions are searched, without a pose claim
  solvers::StopRule stop = {};        // of which the tolerances count
  bool orientation_is_exact = false;  // true if the closed form of the wrist completes answers
  bool limits_are_enforced = false;   // otherwise a violation is only recorded
};

// What the claim of a program may be off [m]: rounding to single precision.
constexpr double claim_slack_of_programs = 1e-6;

constexpr double most_of_budget = 1.5;
struct Spent {
  double seconds = 0;
  std::int64_t evaluations = 0, iterations = 0;
};
// True if a solver that stops by itself took more than `most_of_budget` times its budget.
bool is_over(const Spent& spent, const solvers::StopRule& budget);

// The most severe fault of an answer, in the order of Status' description (results/record.hpp). A difference of 1e-9
// (m, rad) is rounding.
results::Status status_by(const Verification& verified, const Requirement& requirement);

}  // namespace ikbench::experiments
