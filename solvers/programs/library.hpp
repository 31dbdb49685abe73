// What the programs in C++ share.
#pragma once

#include <Eigen/Dense>

#include "ikbench_program.hpp"

using ikbench::Values;

inline void require(const ikbench::Robot& robot, bool is_turning = false) {
  for (const ikbench::Json& joint : robot.message["joints"].list) {
    if (joint["type"].text == "coupled") throw ikbench::Declined{"coupled joints"};
    if (is_turning && joint["type"].text != "revolute") throw ikbench::Declined{"only revolute joints are supported"};
  }
}

inline Eigen::Matrix4d matrix(const Values& row_by_row) {
  return Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(row_by_row.data());
}

inline Eigen::Matrix4d target_of(const ikbench::Problem& problem) {
  const Values &r = problem.rotation, &p = problem.position;
  return matrix({r[0], r[1], r[2], p[0], r[3], r[4], r[5], p[1], r[6], r[7], r[8], p[2], 0, 0, 0, 1});
}

// Behind a joint at zero.
inline Eigen::Matrix4d link(const ikbench::Json& joint) {
  const double t = joint["theta"].number, al = joint["alpha"].number, a = joint["a"].number, d = joint["d"].number;
  const double c = std::cos(t), s = std::sin(t), ca = std::cos(al), sa = std::sin(al);
  const double cb = std::cos(joint["beta"].number), sb = std::sin(joint["beta"].number);
  return matrix({c, -s * ca, s * sa, a * c, s, c * ca, -c * sa, a * s, 0, sa, ca, d, 0, 0, 0, 1}) *
         matrix({cb, 0, sb, 0, 0, 1, 0, 0, -sb, 0, cb, 0, 0, 0, 0, 1});
}

// What `from` answers from the start, then from random ones, while it is {} and time is left (without a budget of time
// from twenty).
template <class From>
Values from_starts(ikbench::Problem& problem, From from) {
  Values answer = from(problem.start);
  for (int i = 1; answer.empty() && (problem.seconds > 0 || i < 20) && problem.is_left(); ++i)
    answer = from(problem.another_start());
  return answer;
}
