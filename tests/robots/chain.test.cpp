#include "tests/robots/random_configuration.hpp"

using std::numbers::pi;

namespace {

Eigen::VectorXd degrees(std::initializer_list<double> angles) { return vector_of(angles) * pi / 180; }

}  // namespace

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
}
