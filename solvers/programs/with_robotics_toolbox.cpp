// source = roboticstoolbox-python==1.5.0
// flags = -I . -I src/roboticstoolbox/ets/cpp-extensions src/roboticstoolbox/ets/cpp-extensions/{ik,linalg,methods}.cpp
// Robotics Toolbox's core as with_robotics_toolbox.py asks it: ik_LM by Chan, 100 searches of 30 iterations; again
// while time is left. install.sh gives it stand-ins of Python's headers, of which it has memory and an exception.
#include <Python.h>

#include "ik.h"
#include "library.hpp"

struct Arm {
  std::vector<Eigen::Matrix4d> frames;
  std::vector<ET> elements;
  std::vector<ET*> places;
  Values lower, upper, half;
};

void turn(double* T, double q) {
  const double c = std::cos(q), s = std::sin(q);
  MapMatrix4dc(T) << c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
}

void slide(double* T, double q) { MapMatrix4dc(T) << 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, q, 0, 0, 0, 1; }

std::unique_ptr<Arm> prepare(const ikbench::Robot& robot) {
  require(robot);
  const std::vector<ikbench::Json>& joints = robot.message["joints"].list;
  auto arm = std::make_unique<Arm>();
  arm->frames.push_back(matrix(robot.message["base"].numbers()));
  for (const ikbench::Json& joint : joints) arm->frames.push_back(link(joint));
  arm->frames.back() *= matrix(robot.message["tool"].numbers());
  for (std::size_t i = 0; i < arm->frames.size(); ++i) {
    double* const frame = arm->frames[i].data();
    if (i > 0) {
      const bool is_turn = robot.turns[i - 1];
      arm->elements.push_back({0, 1, 0, static_cast<int>(i - 1), is_turn ? 2 : 5, frame, nullptr,
                               is_turn ? turn : slide, MapMatrix4dc(frame)});
    }
    arm->elements.push_back({0, 0, 0, 0, 0, frame, nullptr, nullptr, MapMatrix4dc(frame)});
  }
  for (ET& element : arm->elements) arm->places.push_back(&element);
  return arm;
}

Values solve(std::unique_ptr<Arm>& arm, ikbench::Problem& problem) {
  const int n = static_cast<int>(problem.start.size());
  arm->lower = problem.lower;
  arm->upper = problem.upper;
  arm->half = problem.upper;
  for (std::size_t j = 0; j < arm->half.size(); ++j) arm->half[j] = (problem.upper[j] - problem.lower[j]) / 2;
  ETS ets{arm->places.data(), n, static_cast<int>(arm->places.size()), arm->lower.data(), arm->upper.data(),
          arm->half.data()};
  const Eigen::Matrix4d target = target_of(problem);
  const double tolerance = 0.5 * std::pow(std::min(problem.near, problem.near_angle), 2);
  return from_starts(problem, [&](const Values& start) {
    Values from = start, q(start.size());
    int iterations = 0, searches = 1, is_solved = 0;
    double error = 0;
    _IK_LM_Chan(&ets, target, MapVectorX(from.data(), n), 30, 100, tolerance, 1, MapVectorX(q.data(), n), &iterations,
                &searches, &is_solved, &error, 1, MapVectorX(nullptr, 0));
    return is_solved ? q : Values();
  });
}

int main() { ikbench::run("robotics_toolbox", {}, prepare, solve, R"(["pose"])"); }
