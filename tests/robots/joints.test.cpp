// Joints that slide and links that are coupled, bases and tools: by hand, by published numbers, and for random arms
// against 4x4 products in long double.
#include "tests/robots/random_configuration.hpp"

using std::numbers::pi;

namespace {

constexpr double quarter = pi / 2;

void check_position(const Chain& chain, std::initializer_list<double> q, const Eigen::Vector3d& expected) {
  CAPTURE(chain.position(vector_of(q)).transpose(), expected.transpose());
  CHECK((chain.position(vector_of(q)) - expected).norm() < 1e-15);
}

}  // namespace

TEST_CASE("a Cartesian arm is where its three slides are", "[joints]") {
  // Along z, then along y, then along x: each axis is turned to the direction of the next.
  const Chain arm({{.alpha = -quarter, .joint = Joint::slides},
                   {.alpha = quarter, .offset = quarter, .joint = Joint::slides},
                   {.d = 0.1, .joint = Joint::slides}});
  check_position(arm, {0, 0, 0}, {0.1, 0, 0});
  check_position(arm, {0.3, 0.4, 0.5}, {0.6, 0.4, 0.3});
  Eigen::Matrix3Xd jacobian(3, 3), expected(3, 3);
  arm.position_jacobian(vector_of({0.3, 0.4, 0.5}), jacobian);
  expected << 0, 0, 1, 0, 1, 0, 1, 0, 0;
  CHECK((jacobian - expected).cwiseAbs().maxCoeff() < 1e-15);
  CHECK(std::isinf(arm.reach().radius));
}

TEST_CASE("a SCARA arm is a planar arm whose tool slides down", "[joints]") {
  const Chain arm({{.a = 0.3, .d = 0.4}, {.a = 0.2, .alpha = pi}, {.joint = Joint::slides}});
  check_position(arm, {0, 0, 0.15}, {0.5, 0, 0.25});
  check_position(arm, {quarter, -quarter, 0.05}, {0.2, 0.3, 0.35});
}

TEST_CASE("a coupled link moves what comes after it and turns nothing", "[joints]") {
  const Chain arm({{.d = 0.2}, {.d = 0.5, .joint = Joint::coupled}, {.a = 0.3, .joint = Joint::coupled}}, {0.1, 0, 0});
  check_position(arm, {0, 0, 0}, {0.4, 0, 0.7});
  check_position(arm, {0, quarter, 0}, {0.9, 0, 0.2});         // the first of them level
  check_position(arm, {0, quarter, quarter}, {0.6, 0, -0.1});  // the second straight down
  check_position(arm, {quarter, quarter, quarter}, {0, 0.6, -0.1});
  CHECK((arm.forward(vector_of({0, 0.7, -1.1})).linear() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() == 0);
  // A twist turns what follows, whatever the angle; an offset is added to the angle.
  const Chain twisted({{.a = 0.5, .alpha = quarter, .offset = quarter, .joint = Joint::coupled}}, {0, 0.1, 0});
  check_position(twisted, {-quarter}, {0.5, 0, 0.1});
  check_position(twisted, {0}, {0, 0, -0.4});
}

TEST_CASE("base and tool are moved and then turned", "[joints]") {
  const Frame base{{1, 2, 3}, {0, 0, quarter}}, tool{{0, 0, 0.1}, {pi, 0, 0}};
  const Chain arm({{.a = 0.5}}, base, tool);
  check_position(arm, {0}, {1, 2.5, 3.1});
  check_position(arm, {quarter}, {0.5, 2, 3.1});
  CHECK((arm.forward(vector_of({0})).linear().col(2) - Eigen::Vector3d(0, 0, -1)).norm() < 1e-15);
  // About the point of the axis that is level with the tool.
  CHECK((arm.reach().centre - Eigen::Vector3d(1, 2, 3.1)).norm() < 1e-15);
  CHECK(arm.reach().radius == Approx(0.5));
}

TEST_CASE("an arm of any kind has the pose of 4x4 products, and its errors their distance, with all instruction sets",
          "[joints]") {
  Dice dice;
  for (int trial = 0; trial < 3000; ++trial) {
    const Chain chain = random_chain(dice);
    // The angle that turns is the sum with its offset as a double: of 1e5, half a unit of its last place is 7e-12.
    const double most_turned = trial % 2 == 0 ? 3 : 1e5, within = trial % 2 == 0 ? 1e-13 : 1e-9;
    const Eigen::VectorXd q = random_joints(chain, dice, most_turned);
    const LongMatrix expected = reference_pose(chain, q);
    const Pose pose = chain.forward(q);
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 4; ++column) {
        const double element = pose(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
        REQUIRE(std::abs(element - static_cast<double>(expected[row][column])) < within);
      }
    }
    const Chain::Ball ball = chain.reach();
    REQUIRE((pose.translation() - ball.centre).norm() <= ball.radius + within);
    const Eigen::Vector3d target(dice.between(-2, 2), dice.between(-2, 2), dice.between(-2, 2));
    Eigen::VectorXd error(1);
    chain.position_errors(q, target, error);
    const auto distance = static_cast<double>(reference_distance(reference_position(chain, q), target));
    REQUIRE(std::abs(error[0] - distance) < within);
  }
}

TEST_CASE("the Jacobians of an arm of any kind are what central differences say", "[joints]") {
  Dice dice;
  const double h = 1e-5;
  for (int trial = 0; trial < 500; ++trial) {
    const Chain chain = random_chain(dice);
    const Eigen::VectorXd q = random_joints(chain, dice);
    Matrix6Xd jacobian(6, chain.joints());
    Eigen::Matrix3Xd of_position(3, chain.joints());
    REQUIRE(chain.pose_jacobian(q, jacobian).matrix() == chain.forward(q).matrix());
    REQUIRE((chain.position_jacobian(q, of_position) - chain.position(q)).norm() < 1e-14);
    REQUIRE(jacobian.topRows<3>() == of_position);
    for (int j = 0; j < chain.joints(); ++j) {
      const Eigen::VectorXd step = h * Eigen::VectorXd::Unit(chain.joints(), j);
      const Eigen::Vector3d slope = (chain.position(q + step) - chain.position(q - step)) / (2 * h);
      REQUIRE((of_position.col(j) - slope).norm() < 1e-9);
      const Eigen::Matrix3d turned = chain.forward(q + step).linear() * chain.forward(q - step).linear().transpose();
      REQUIRE((jacobian.col(j).tail<3>() - rotation_vector(turned) / (2 * h)).norm() < 1e-9);
    }
  }
}

TEST_CASE("the error of a pose is the root mean square of how far three points of the tool are off", "[joints]") {
  Dice dice;
  for (int trial = 0; trial < 3000; ++trial) {
    const Chain chain = random_chain(dice);
    const double weight = dice.between(0.01, 2);
    Candidates q(chain.joints(), 3);
    for (int i = 0; i < 3; ++i) q.col(i) = random_joints(chain, dice);
    const Pose target = random_chain(dice).base().pose();
    Eigen::VectorXd errors(3);
    chain.pose_errors(q, target, weight, errors);
    for (int i = 0; i < 3; ++i) {
      const LongMatrix reached = reference_pose(chain, q.col(i));
      long double squares = 0;
      for (int point = 0; point < 3; ++point) {  // the tool's, and those along its x and y
        for (std::size_t row = 0; row < 3; ++row) {
          const auto at = static_cast<Eigen::Index>(row);
          long double off = reached[row][3] - static_cast<long double>(target(at, 3));
          if (point > 0) {
            const auto axis = static_cast<std::size_t>(point - 1);
            off += weight * (reached[row][axis] - static_cast<long double>(target(at, point - 1)));
          }
          squares += off * off;
        }
      }
      REQUIRE(std::abs(errors[i] - static_cast<double>(std::sqrt(squares / 3))) < 1e-13);
    }
    chain.pose_errors(q, chain.forward(q.col(1)), weight, errors);
    REQUIRE(errors[1] < 1e-13);  // the pose itself
  }
}

TEST_CASE("what is new in an arm is said in its definition, and nothing of what it has not", "[joints]") {
  const std::vector<DhLink> one{{.a = 0.5, .alpha = 1, .d = 0.25, .offset = 2}};
  CHECK(Chain(one).definition() == "0.5 1 0.25 2 0 0 0 ");
  std::vector<DhLink> slides = one, coupled = one;
  slides[0].joint = Joint::slides;
  coupled[0].joint = Joint::coupled;
  CHECK(Chain(slides).definition() == "0.5 1 0.25 2 slides 0 0 0 ");
  CHECK(Chain(coupled).definition() == "0.5 1 0.25 2 coupled 0 0 0 ");
  CHECK(Chain({{.a = 0.5, .alpha = 1, .d = 0.25, .offset = 2, .beta = 3}}).definition() ==
        "0.5 1 0.25 2 leans 3 0 0 0 ");
  CHECK(Chain(one, {{1, 2, 3}, {4, 5, 6}}, {{7, 8, 9}, {1, 0, 0}}).definition() ==
        "0.5 1 0.25 2 7 8 9 turned 1 0 0 base 1 2 3 4 5 6 ");
  // Older stores know the Dobot by the words of its closed form.
  CHECK(robot("dobot_magician").chain.definition() == " dobot magician 0.135 0.147 0.061 0.058 ");
}

TEST_CASE("the wrist of an arm on a base, with a slide before it and a turned tool, reaches given poses", "[joints]") {
  std::vector<DhLink> links{{.alpha = -quarter, .d = 0.4}, {.alpha = quarter}, {.d = 0.3, .joint = Joint::slides},
                            {.alpha = -quarter, .d = 0.1}, {.alpha = quarter}, {.d = 0.05}};
  const Chain chain(links, {{0.1, -0.2, 0.3}, {0.4, -0.5, 0.6}}, {{0.01, 0.02, 0.03}, {-1, 2, 0.5}});
  REQUIRE(SphericalWrist::fits(chain));
  const SphericalWrist wrist(chain);
  Dice dice;
  for (int trial = 0; trial < 1000; ++trial) {
    const Eigen::VectorXd q = random_joints(chain, dice);
    const Pose pose = chain.forward(q);
    CHECK((wrist.arm().position(q.head(3)) - wrist.centre(pose)).norm() < 1e-14);
    for (const Eigen::Vector3d& angles : wrist.angles(q.head(3), pose.linear(), Eigen::Vector3d::Zero())) {
      Eigen::VectorXd again(6);
      again << q.head(3), angles;
      CHECK((chain.forward(again).matrix() - pose.matrix()).cwiseAbs().maxCoeff() < 1e-13);
    }
  }
  for (std::size_t joint = 3; joint < 6; ++joint) {
    for (const Joint kind : {Joint::slides, Joint::coupled}) {
      std::vector<DhLink> other = links;
      other[joint].joint = kind;
      CHECK_FALSE(SphericalWrist::fits(Chain(other)));
    }
  }
}
