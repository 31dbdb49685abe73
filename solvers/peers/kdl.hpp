// Converts arms, frames and joints to KDL's.
#pragma once

#include <kdl/config.h>

#include <algorithm>
#include <kdl/chain.hpp>
#include <kdl/chainiksolver.hpp>
#include <kdl/jntarray.hpp>
#include <string>
#include <utility>

#include "solvers/registry.hpp"

namespace ikbench::solvers {

inline KDL::Frame kdl_frame(const robots::Pose& T) {
  KDL::Frame frame;
  for (int i = 0; i < 3; ++i) {
    frame.p(i) = T.translation()[i];
    for (int j = 0; j < 3; ++j) frame.M(i, j) = T.linear()(i, j);
  }
  return frame;
}

inline KDL::JntArray kdl_joints(const robots::Configuration& q) {
  KDL::JntArray array(static_cast<unsigned>(q.size()));
  array.data = q;
  return array;
}

// The first segment is the frame of the base, which no joint moves.
inline KDL::Chain kdl_chain(const robots::Chain& arm) {
  KDL::Chain chain;
  chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), kdl_frame(arm.base().pose())));
  for (const robots::DhLink& link : arm.links()) {
    const KDL::Joint joint(link.joint == robots::Joint::slides ? KDL::Joint::TransZ : KDL::Joint::RotZ);
    chain.addSegment(KDL::Segment(joint, KDL::Frame::DH(link.a, link.alpha, link.d, link.offset)));
  }
  chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), kdl_frame(arm.tool().pose())));
  return chain;
}

// The solver's option, or else the study's iterations: an iteration of KDL is no generation of a population.
inline int kdl_iterations(int option, const Problem& problem) {
  return option > 0 ? option : std::min(problem.stop.iterations, 1'000'000);
}

// The answer of a position solver of KDL.
inline robots::Configuration kdl_answer(KDL::ChainIkSolverPos& solver, const robots::Configuration& start,
                                        const Goal& goal) {
  KDL::JntArray answer(static_cast<unsigned>(start.size()));
  solver.CartToJnt(kdl_joints(start), kdl_frame(goal.target), answer);
  return answer.data;
}

template <class S>
SolverInfo kdl_info(std::string name, std::string summary, std::string source) {
  SolverInfo info = solver_info<S>(std::move(name), std::move(summary), std::move(source));
  info.library = "KDL " KDL_VERSION_STRING;
  info.is_counted = false;  // it has its own kinematics
  return info;
}

inline std::string why_kdl_cannot(const robots::Chain& arm) {
  const bool is_coupled =
      std::ranges::any_of(arm.links(), [](const robots::DhLink& link) { return link.joint == robots::Joint::coupled; });
  return is_coupled ? "KDL has no coupled joints; expected an arm whose joints turn or slide" : "";
}

}  // namespace ikbench::solvers
