#include "robots/chain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "numerics/functions.hpp"
#include "robots/robot.hpp"
#include "tests/catch.hpp"
#include "tests/numerics/reference.hpp"
#include "tests/robots/random_configuration.hpp"

using namespace ikbench;
using namespace ikbench::numerics;
using namespace ikbench::robots;
using std::numbers::pi;

namespace {

Eigen::VectorXd degrees(std::initializer_list<double> angles) {
  Eigen::VectorXd q(static_cast<Eigen::Index>(angles.size()));
  std::copy(angles.begin(), angles.end(), q.begin());
  return q * pi / 180;
}

}  // namespace

TEST_CASE("a link's transform has the elements of Eq. 18, with -cos(theta) sin(alpha) in place (2,3)",
          "[chain][paper]") {
  const double a = 0.3, alpha = 0.7, d = 0.2, theta = 1.1;
  const Chain chain({{.a = a, .alpha = alpha, .d = d, .offset = 0.4}});
  const Eigen::Matrix4d T = chain.forward(Eigen::VectorXd::Constant(1, theta - 0.4)).matrix();
  const double c = std::cos(theta), s = std::sin(theta), ca = std::cos(alpha), sa = std::sin(alpha);
  Eigen::Matrix4d expected;
  expected << c, -s * ca, s * sa, a * c,  //
      s, c * ca, -c * sa, a * s,          //
      0, sa, ca, d,                       //
      0, 0, 0, 1;
  CHECK((T - expected).cwiseAbs().maxCoeff() < 1e-15);
}

TEST_CASE("a planar arm of two links is where the sums of its angles put it", "[chain]") {
  const Chain chain = robot("planar_2").chain;
  RandomConfigurations random;
  for (int trial = 0; trial < 100; ++trial) {
    const double t1 = random.between(-pi, pi), t2 = random.between(-pi, pi);
    const Eigen::Vector3d expected(0.5 * std::cos(t1) + 0.5 * std::cos(t1 + t2),
                                   0.5 * std::sin(t1) + 0.5 * std::sin(t1 + t2), 0);
    CHECK((chain.position(Eigen::Vector2d(t1, t2)) - expected).norm() < 1e-15);
  }
}

TEST_CASE("a planar arm of three links is where the sums of its angles put it", "[chain]") {
  const Chain chain = robot("planar_3").chain;
  const double a = 0.3, b = 0.3 - 1.2, c = 0.3 - 1.2 + 2.1;
  const Eigen::Vector3d expected(0.5 * (std::cos(a) + std::cos(b) + std::cos(c)),
                                 0.5 * (std::sin(a) + std::sin(b) + std::sin(c)), 0);
  CHECK((chain.position(Eigen::Vector3d(0.3, -1.2, 2.1)) - expected).norm() < 1e-15);
}

TEST_CASE("a planar arm's Jacobian is the one of the textbook", "[chain]") {
  const Chain chain = robot("planar_2").chain;
  const double t1 = 0.3, t2 = -1.2;
  Eigen::Matrix3Xd jacobian(3, 2), expected(3, 2);
  chain.position_jacobian(Eigen::Vector2d(t1, t2), jacobian);
  expected << -0.5 * std::sin(t1) - 0.5 * std::sin(t1 + t2), -0.5 * std::sin(t1 + t2),  //
      0.5 * std::cos(t1) + 0.5 * std::cos(t1 + t2), 0.5 * std::cos(t1 + t2),            //
      0, 0;
  CHECK((jacobian - expected).cwiseAbs().maxCoeff() < 1e-15);
}

TEST_CASE("the iiwa is in its poses where its link lengths add up", "[chain]") {
  const Chain chain = robot("kuka_iiwa14").chain;
  const auto at = [&](std::initializer_list<double> angles) { return chain.position(degrees(angles)); };
  // 0.360 + 0.420 + 0.400 + 0.126 straight up
  CHECK((at({0, 0, 0, 0, 0, 0, 0}) - Eigen::Vector3d(0, 0, 1.306)).norm() < 1e-15);
  // the whole arm down to the side: 0.420 + 0.400 + 0.126 along x, at the shoulder's height
  CHECK((at({0, 90, 0, 0, 0, 0, 0}) - Eigen::Vector3d(0.946, 0, 0.360)).norm() < 1e-15);
  CHECK((at({90, 90, 0, 0, 0, 0, 0}) - Eigen::Vector3d(0, 0.946, 0.360)).norm() < 1e-15);
  // the elbow bends the forearm opposite to the shoulder
  CHECK((at({0, 0, 0, 90, 0, 0, 0}) - Eigen::Vector3d(-0.526, 0, 0.780)).norm() < 1e-15);
  // only the flange is level
  CHECK((at({0, 0, 0, 0, 0, 90, 0}) - Eigen::Vector3d(0.126, 0, 1.180)).norm() < 1e-15);
}

TEST_CASE("the iiwa's axes at rest are those of its base", "[chain]") {
  const Pose T = robot("kuka_iiwa14").chain.forward(Eigen::VectorXd::Zero(7));
  CHECK((T.linear() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-15);
}

TEST_CASE("position alone is the translation of the whole pose", "[chain]") {
  RandomConfigurations random;
  for (const Robot& arm : all_robots()) {
    const Chain with_tool(arm.chain.links(), {0.01, -0.02, 0.15});
    for (int trial = 0; trial < 10000; ++trial) {
      const Eigen::VectorXd q = random(arm.limits);
      REQUIRE((with_tool.position(q) - with_tool.forward(q).translation()).norm() < 2e-15);
    }
  }
}

TEST_CASE("position agrees with 4x4 products in long double to 1e-13 cm", "[chain]") {
  RandomConfigurations random;
  for (const Robot& arm : all_robots()) {
    const Chain with_tool(arm.chain.links(), {0.01, -0.02, 0.15});
    for (int trial = 0; trial < 2000; ++trial) {
      const Eigen::VectorXd q = random(arm.limits);
      const LongPoint expected = reference_position(with_tool, q);
      REQUIRE(reference_distance(expected, with_tool.position(q)) < 1e-15L);
    }
  }
}

TEST_CASE("the Jacobian is what central differences say", "[chain]") {
  RandomConfigurations random;
  const double h = 1e-5;  // truncation h^2 / 6 = 2e-11
  for (const Robot& arm : all_robots()) {
    Eigen::Matrix3Xd jacobian(3, arm.chain.joints());
    for (int trial = 0; trial < 100; ++trial) {
      const Eigen::VectorXd q = random(arm.limits);
      arm.chain.position_jacobian(q, jacobian);
      for (int j = 0; j < arm.chain.joints(); ++j) {
        const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(arm.chain.joints(), j);
        const Eigen::Vector3d slope = (arm.chain.position(q + step) - arm.chain.position(q - step)) / (2 * h);
        REQUIRE((jacobian.col(j) - slope).norm() < 1e-10);
      }
    }
  }
}

TEST_CASE("the error of a batch is the distance of each candidate, Eq. 1", "[chain][paper]") {
  const Robot arm = robot("kuka_iiwa14");
  RandomConfigurations random;
  const Eigen::Vector3d target(0.4, -0.1, 0.6);
  Candidates q(7, 50);
  for (int i = 0; i < 50; ++i) q.col(i) = random(arm.limits);
  Eigen::VectorXd errors(50);
  arm.chain.position_errors(q, target, errors);
  for (int i = 0; i < 50; ++i)
    CHECK(errors[i] == Approx((arm.chain.position(q.col(i)) - target).norm()).epsilon(1e-14));
}

TEST_CASE("no tool point leaves the ball of reach", "[chain]") {
  RandomConfigurations random;
  for (const Robot& arm : all_robots()) {
    const Chain with_tool(arm.chain.links(), {0.01, -0.02, 0.15});
    const Chain::Ball ball = with_tool.reach();
    for (int trial = 0; trial < 10000; ++trial) {
      REQUIRE((with_tool.position(random(arm.limits)) - ball.centre).norm() <= ball.radius + 1e-15);
    }
  }
}

TEST_CASE("a stretched arm touches the ball of reach", "[chain]") {
  const auto check = [](const char* name, std::initializer_list<double> angles) {
    const Chain arm = robot(name).chain;
    const Chain::Ball ball = arm.reach();
    CHECK((arm.position(degrees(angles)) - ball.centre).norm() == Approx(ball.radius).epsilon(1e-15));
  };
  check("kuka_iiwa14", {0, 0, 0, 0, 0, 0, 0});
  check("planar_3", {0, 0, 0});
  check("dobot_magician", {0, 90, 0});
}

TEST_CASE("the iiwa's wrist reaches the 820 mm of its name from the shoulder", "[chain][paper]") {
  const std::vector<DhLink> links = robot("kuka_iiwa14").chain.links();
  const Chain arm({links.begin(), links.begin() + 4}, {0, 0, links[4].d});
  CHECK(arm.reach().radius == Approx(0.820).epsilon(1e-15));
  CHECK((arm.reach().centre - Eigen::Vector3d(0, 0, 0.360)).norm() < 1e-15);
}

TEST_CASE("an arm refuses candidates, errors and angles of the wrong number", "[chain]") {
  const Chain chain = robot("kuka_iiwa14").chain;
  Eigen::VectorXd errors(5), few(4);
  errors.setZero();
  few.setZero();
  CHECK_THROWS_AS(chain.position_errors(Candidates::Zero(4, 5), Eigen::Vector3d::Zero(), errors),
                  std::invalid_argument);
  CHECK_THROWS_AS(chain.position_errors(Candidates::Zero(7, 5), Eigen::Vector3d::Zero(), few), std::invalid_argument);
  CHECK_THROWS_AS(chain.forward(Eigen::VectorXd::Zero(8)), std::invalid_argument);
  CHECK_THROWS_AS(sines_and_cosines(few, errors, errors), std::invalid_argument);
}
