// Places that an arm certainly never reaches: by lengths that are known, and by random configurations, none of which
// may be beyond.
#include "robots/reach.hpp"

#include <random>

#include "tests/common.hpp"

using namespace ikbench::robots;

namespace ikbench {

TEST_CASE("the ball of the last axis has the known radius", "[reach]") {
  CHECK(last_axis_of(robot("ur5e"))->ball.radius == Approx(0.9265).margin(1e-4));
  CHECK(reach_within(robot("ur5e").chain, robot("ur5e").limits).radius == Approx(0.9689).margin(5e-5));
  const LastAxis planar = last_axis_of(robot("planar_3")).value();
  CHECK(planar.ball.radius == Approx(1));
  CHECK((planar.in_tool - Eigen::Vector3d(-0.5, 0, 0)).norm() < 1e-12);
}

TEST_CASE("no pose of a configuration within the limits is beyond", "[reach]") {
  for (const Robot& arm : all_robots()) {
    INFO(arm.name);
    const Chain::Ball ball = reach_within(arm.chain, arm.limits);
    CHECK(std::isfinite(ball.radius));
    const std::optional<LastAxis> last = last_axis_of(arm);
    const JointLimits range = arm.limits.around(Configuration::Zero(arm.joints()));
    std::mt19937 random(5);
    for (int i = 0; i < 200; ++i) {
      Configuration q = range.lower;
      for (Eigen::Index j = 0; j < q.size(); ++j) {
        const double share = static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
        q[j] += share * (range.upper[j] - range.lower[j]);
      }
      const Pose pose = arm.chain.forward(q);
      CHECK((pose.translation() - ball.centre).norm() < ball.radius + 1e-9);
      if (!last) continue;
      CHECK(last->beyond(pose) < 1e-9);
      CHECK(last->beyond_of_axis(pose) < last->beyond(pose) + 1e-9);
    }
  }
}

TEST_CASE("of an axis alone, the best turn about it counts", "[reach]") {
  const LastAxis last{.in_tool = {0.3, 0, -0.1}, .ball = {Eigen::Vector3d(1, 0, 0), 0.2}};
  Pose tool = Pose::Identity();
  CHECK(last.beyond(tool) == Approx(std::hypot(0.7, 0.1) - 0.2));
  tool.linear() = Eigen::AngleAxisd(2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  CHECK(last.beyond_of_axis(tool) == Approx(std::hypot(0.7, 0.1) - 0.2));
}

TEST_CASE("a joint that slides adds half its range, and without limits the reach is not known", "[reach]") {
  Robot arm = robot("stanford");
  const Chain::Ball ball = reach_within(arm.chain, arm.limits);
  Eigen::Index slide = 0;
  while (!arm.chain.slides(slide)) ++slide;
  arm.limits.upper[slide] += 2;
  CHECK(reach_within(arm.chain, arm.limits).radius > ball.radius + 1);
  CHECK(reach_within(arm.chain, arm.limits).radius < ball.radius + 2 + 1e-9);
  arm.limits.upper[slide] = INFINITY;
  CHECK(std::isinf(reach_within(arm.chain, arm.limits).radius));
}

}  // namespace ikbench
