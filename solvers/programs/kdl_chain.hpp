// KDL's arm, for the programs in C++ that need it.
#pragma once

#include <kdl/chain.hpp>
#include <kdl/jntarray.hpp>

#include "library.hpp"

inline KDL::Frame frame_of(const Eigen::Matrix4d& T) {
  KDL::Frame frame;
  for (int i = 0; i < 3; ++i) {
    frame.p(i) = T(i, 3);
    for (int j = 0; j < 3; ++j) frame.M(i, j) = T(i, j);
  }
  return frame;
}

inline KDL::JntArray array(const Values& values) {
  KDL::JntArray q(static_cast<unsigned>(values.size()));
  std::copy(values.begin(), values.end(), q.data.data());
  return q;
}

inline Values values(const KDL::JntArray& q) { return {q.data.data(), q.data.data() + q.rows()}; }

inline KDL::Chain chain_of(const ikbench::Robot& robot) {
  require(robot);
  KDL::Chain chain;
  const auto add = [&](KDL::Joint::JointType type, const Eigen::Matrix4d& frame) {
    chain.addSegment(KDL::Segment(KDL::Joint(type), frame_of(frame)));
  };
  add(KDL::Joint::None, matrix(robot.message["base"].numbers()));
  for (const ikbench::Json& joint : robot.message["joints"].list)
    add(joint["type"].text == "revolute" ? KDL::Joint::RotZ : KDL::Joint::TransZ, link(joint));
  add(KDL::Joint::None, matrix(robot.message["tool"].numbers()));
  return chain;
}
