// KDL's forward kinematics of the transforms that a URDF file prints, beside our chain of the same file.
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>

#include "tests/robots/random_configuration.hpp"

namespace {

// The chain as kdl_parser makes it: the joint's origin and axis in the frame of the previous joint, and the frame
// behind it.
KDL::Chain kdl_chain(const Description& description) {
  KDL::Chain chain;
  for (const DescribedJoint& joint : description) {
    const Eigen::Vector3d &position = joint.origin.position, &rpy = joint.origin.rpy, &axis = joint.axis;
    const KDL::Frame origin(KDL::Rotation::RPY(rpy[0], rpy[1], rpy[2]),
                            KDL::Vector(position[0], position[1], position[2]));
    const KDL::Vector direction = origin.M * KDL::Vector(axis[0], axis[1], axis[2]);
    using enum DescribedJoint::Motion;
    chain.addSegment(KDL::Segment(
        joint.motion == none
            ? KDL::Joint(KDL::Joint::None)
            : KDL::Joint(origin.p, direction, joint.motion == slides ? KDL::Joint::TransAxis : KDL::Joint::RotAxis),
        origin));
  }
  return chain;
}

}  // namespace

TEST_CASE("KDL puts the tool of a URDF file where our chain puts it, to 1e-12 m", "[urdf][peers]") {
  for (const char* const name : {"iiwa14", "panda", "gen3", "ur5e", "fetch", "ur5_calibrated"}) {
    CAPTURE(name);
    const Robot arm = load_robot(fmt::format("tests/data/urdf/{}.urdf", name));
    const KDL::Chain chain = kdl_chain(arm.description);
    REQUIRE(chain.getNrOfJoints() == static_cast<unsigned>(arm.joints()));
    KDL::ChainFkSolverPos_recursive kdl(chain);
    RandomConfigurations random;
    double farthest = 0, most_turned = 0;
    for (int trial = 0; trial < 1000; ++trial) {
      KDL::JntArray joints(chain.getNrOfJoints());
      joints.data = random(arm.limits);
      KDL::Frame tool;
      REQUIRE(kdl.JntToCart(joints, tool) >= 0);
      const Pose ours = arm.chain.forward(joints.data);
      for (int i = 0; i < 3; ++i) {
        farthest = std::max(farthest, std::abs(tool.p(i) - ours.translation()[i]));
        for (int k = 0; k < 3; ++k) most_turned = std::max(most_turned, std::abs(tool.M(i, k) - ours.linear()(i, k)));
      }
    }
    CHECK(farthest < 1e-12);
    CHECK(most_turned < 1e-12);
  }
}
