// The cause why answers miss their targets, found from the answers and the arm's kinematics only. Users of answers made
// elsewhere, `ikbench run` and `ikbench check-solver` show it, so that a wrong unit is not taken for a wrong solver.
// Costs a few forward kinematics per answer, and those of all orders of the joints for five answers.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "experiments/external/answers.hpp"
#include "experiments/study/study.hpp"
#include "robots/robot.hpp"

namespace ikbench::experiments {

enum class Cause {
  degrees,           // angles are in degrees
  joint_order,       // the joints are in another order
  shifted,           // answers belong to the targets some rows away
  tool_frame,        // all answers miss by one frame at the tool
  base_frame,        // all answers miss by one frame at the base
  quaternion_order,  // positions are right, and w of the quaternion stood in another place
  inverse,           // positions are right, and rotations are inverse
  few_digits         // all errors are small
};

struct Diagnosis {
  Cause cause = Cause::degrees;
  std::vector<int> order = {};  // joint_order: for each joint the column that has it, from 0
  int rows = 0;                 // shifted: an answer belongs to the target so many rows further down; negative: up
  std::size_t answers = 0, shifted_answers = 0;  // shifted: number of all answers, and of those that are
  Pose frame = Pose::Identity();                 // tool_frame, base_frame
  std::optional<Pose> base_frame = {};           // tool_frame: a frame of the base that explains the answers as well
  double error = 0;                              // few_digits: median [m]
};

// An answer with its target.
struct AnsweredTarget {
  Pose target;
  Configuration q;  // [rad, m], all joints
};

// The meaning of a right answer.
struct RightWithin {
  solvers::GoalKind kind = solvers::GoalKind::pose;
  double position = 1e-5, angle = 1e-5;  // [m], [rad]
};
// Returns what the study counts as right, and at least 1e-5 m and rad.
RightWithin right_within(const Study& study);

// Returns why the answers, in the order of their targets, are wrong. Returns nothing if at least 30 % of them are
// right, if there are fewer than three, or if no cause explains half of them.
std::optional<Diagnosis> diagnose(const Robot& arm, std::span<const AnsweredTarget> answers, const RightWithin& right);

// Returns the cause as a clause, such as "angles are in degrees, expected radians".
std::string diagnosis_text(const Diagnosis& diagnosis);

// The sentences about a file of answers.
struct AnswersReport {
  std::string cause;  // empty: at least 30 % are right, or no cause is known
  std::string facts;  // doubled rows, wrong answers beside right ones, cells without a number; empty: none
};
AnswersReport report_on(const GivenAnswers& answers, const Study& study, const Robot& arm);

}  // namespace ikbench::experiments
