// Where the tool of an arm is for a configuration of its joints, whatever the arm is made of. Metres and radians
// throughout.
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "robots/kernels.hpp"

namespace ikbench::robots {

using Pose = Eigen::Isometry3d;

// Candidates as columns, joint-contiguous: row j holds joint j of every candidate.
using Candidates = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using CandidatesRef = Eigen::Ref<const Candidates, 0, Eigen::OuterStride<>>;
// One configuration, an element a joint; it takes no memory from the heap.
using Configuration = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_joints, 1>;
// A Configuration, another vector, or a column of Candidates without a copy.
using ConfigurationRef = Eigen::Ref<const Eigen::VectorXd, 0, Eigen::InnerStride<>>;

class Kinematics {
 public:
  virtual ~Kinematics() = default;

  virtual int joints() const = 0;
  // T_base_tool.
  virtual Pose forward(const ConfigurationRef& q) const = 0;
  // The tool's position, and d position / d q into `jacobian`, 3 x joints.
  virtual Eigen::Vector3d linearize(const ConfigurationRef& q, Eigen::Ref<Eigen::Matrix3Xd> jacobian) const = 0;
  // Distance of each candidate's tool point to the target, Eq. 1; `errors` has one element a candidate. It is not a
  // finite number where an angle or the target is none, or an angle is 2^51 quarter turns (3.5e15 rad) or more.
  virtual void position_errors(const CandidatesRef& q, const Eigen::Vector3d& target,
                               Eigen::Ref<Eigen::VectorXd> errors) const = 0;
  // Every reachable tool point lies in this ball.
  struct Ball {
    Eigen::Vector3d centre;
    double radius;
  };
  virtual Ball reach() const = 0;
  // All that decides its positions, each number with all its digits: two arms of one definition are the same arm.
  virtual std::string definition() const = 0;

  // Position of the tool point alone: forward(q).translation().
  Eigen::Vector3d position(const ConfigurationRef& q) const { return forward(q).translation(); }
};

}  // namespace ikbench::robots
