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

// A solve by calls of a position solver of KDL. It knows no clock, so where the study has a limit of time, a call makes
// a few iterations and the next goes on from its answer.
class KdlCalls {
 public:
  // The solver's option, or else the study's iterations; an iteration is about one evaluation.
  void start(const Problem& problem, Objective& objective, int option) {
    std::int64_t most = option > 0 ? option : std::min(problem.stop.iterations, 1'000'000);
    if (problem.stop.evaluations > 0) most = std::min(most, problem.stop.evaluations);
    left_ = static_cast<int>(most);
    const int calls = problem.stop.seconds > 0 ? (left_ + longest_call - 1) / longest_call : 1;
    a_call_ = left_ / std::max(1, calls);
    last_ = problem.start;
    best = {last_};
    best.improve(last_, objective.error(last_));
  }

  void call(KDL::ChainIkSolverPos& solver, Objective& objective) {
    KDL::JntArray answer(static_cast<unsigned>(last_.size()));
    const int how = solver.CartToJnt(kdl_joints(last_), kdl_frame(objective.goal().target), answer);
    last_ = answer.data;
    best.improve(last_, objective.error(last_));
    left_ = how == KDL::SolverI::E_MAX_ITERATIONS_EXCEEDED && left_ >= 2 * a_call_ ? left_ - a_call_ : 0;
  }

  int iterations_of_call() const { return a_call_; }
  bool has_ended() const { return left_ <= 0; }

  Best best;

 private:
  static constexpr int longest_call = 50;  // iterations between looks at the clock

  robots::Configuration last_;
  int left_ = 0, a_call_ = 0;
};

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
