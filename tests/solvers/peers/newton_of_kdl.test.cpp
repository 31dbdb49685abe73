// KDL's own ChainIkSolverPos_NR_JL beside our `newton`, on the same poses.
#include <cmath>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_nr_jl.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>

#include "tests/catch.hpp"
#include "tests/solvers/objectives.hpp"

using namespace ikbench;
using namespace ikbench::numerics;
using namespace ikbench::robots;
using namespace ikbench::solvers;

namespace {

constexpr double tolerance = 1e-5;  // [m], [rad]; KDL's of each coordinate
constexpr int most_iterations = 100;

KDL::Frame frame(const Pose& T) {
  KDL::Frame frame;
  for (int i = 0; i < 3; ++i) {
    frame.p(i) = T.translation()[i];
    for (int j = 0; j < 3; ++j) frame.M(i, j) = T.linear()(i, j);
  }
  return frame;
}

KDL::Chain chain_of(const Chain& ours) {
  KDL::Chain chain;
  chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), frame(ours.base().pose())));
  for (const DhLink& link : ours.links()) {
    chain.addSegment(
        KDL::Segment(KDL::Joint(KDL::Joint::RotZ), KDL::Frame::DH(link.a, link.alpha, link.d, link.offset)));
  }
  chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), frame(ours.tool().pose())));
  return chain;
}

KDL::JntArray joints(const Eigen::VectorXd& q) {
  KDL::JntArray array(static_cast<unsigned>(q.size()));
  array.data = q;
  return array;
}

}  // namespace

TEST_CASE("newton without restarts solves the poses that KDL solves, from the middle of the limits",
          "[newton][peers]") {
  // The two round differently, and a descent that bounces off limits for long may end otherwise for that. So few in 100
  // may differ; of 300 poses that KDL solves with the probability p, two independent samples would differ in 2 p (1 -
  // p).
  constexpr int poses = 300;
  for (const auto& [name, printed] : {std::pair("abb_irb120", 0.3941), std::pair("franka_panda", 0.6177)}) {
    const Robot arm = robot(name);
    const Eigen::VectorXd middle = (arm.limits.lower + arm.limits.upper) / 2;
    const KDL::Chain chain = chain_of(arm.chain);
    KDL::ChainFkSolverPos_recursive position(chain);
    KDL::ChainIkSolverVel_pinv velocity(chain);
    KDL::ChainIkSolverPos_NR_JL kdl(chain, joints(arm.limits.lower), joints(arm.limits.upper), position, velocity,
                                    most_iterations, tolerance);
    const auto newton = solver("newton").make({{"restarts", "none"}});
    Random random{Key(2015)};
    int solved_by_kdl = 0, solved_by_us = 0, differ = 0;
    for (int pose = 0; pose < poses; ++pose) {
      Eigen::VectorXd q(arm.joints());
      for (Eigen::Index j = 0; j < q.size(); ++j) q[j] = random.uniform(arm.limits.lower[j], arm.limits.upper[j]);
      const Pose T = arm.chain.forward(q);

      KDL::JntArray answer(static_cast<unsigned>(q.size()));
      const bool by_kdl = kdl.CartToJnt(joints(middle), frame(T), answer) >= 0;

      Objective objective(arm.chain, {T, 0.3});
      const StopRule stop{.iterations = most_iterations - 1, .tolerance = tolerance, .angle_tolerance = tolerance};
      const Solution ours = solve(*newton, {.start = middle, .lower = arm.limits.lower, .upper = arm.limits.upper},
                                  objective, random, stop);
      const bool by_us = ours.stopped == Stopped::tolerance;
      solved_by_kdl += by_kdl ? 1 : 0;
      solved_by_us += by_us ? 1 : 0;
      differ += by_kdl != by_us ? 1 : 0;
    }
    CAPTURE(name, solved_by_kdl, solved_by_us, differ);
    CHECK(differ <= poses / 50);
    // What Beeson and Ames print, within 4 standard errors.
    CHECK(std::abs(solved_by_us - poses * printed) < 4 * std::sqrt(poses * printed * (1 - printed)));
  }
}
