// The verifier's own kinematics and judgement, by hand and against the chain's.
#include "tests/experiments/samples.hpp"

namespace {

using std::numbers::pi;

Pose place(double x, double y, double z) { return Pose(Eigen::Translation3d(x, y, z)); }

constexpr AcceptanceCriteria any{.reported_error = 0};

}  // namespace

TEST_CASE("joints of any kind, bases and tools are in both forward kinematics", "[verifier]") {
  Dice dice;
  for (int i = 0; i < 1000; ++i) {
    const Chain chain = random_chain(dice);
    const Eigen::VectorXd q = random_joints(chain, dice);
    const Eigen::Matrix4d verified = reference_pose(chain, q);
    REQUIRE((verified - chain.forward(q).matrix()).cwiseAbs().maxCoeff() <= 1e-12);
    const Eigen::Vector3d target(dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1));
    Eigen::VectorXd error(1);
    chain.position_errors(q, target, error);
    REQUIRE(std::abs(error[0] - (verified.topRightCorner<3, 1>() - target).norm()) <= 1e-12);
  }
}

TEST_CASE("an arm from a URDF file is verified by its origins and axes, not by the table made of them", "[verifier]") {
  std::mt19937_64 random(15);
  std::uniform_real_distribution<double> angle(-pi, pi);
  for (const char* const name : {"fetch", "gen3", "iiwa14", "panda", "ur5_calibrated", "ur5e"}) {
    CAPTURE(name);
    Robot arm = load_robot(fmt::format("tests/data/urdf/{}.urdf", name));
    Eigen::VectorXd q(arm.joints());
    for (int i = 0; i < 1000; ++i) {
      for (double& joint : q) joint = angle(random);
      REQUIRE((reference_pose(arm, q) - arm.chain.forward(q).matrix()).cwiseAbs().maxCoeff() <= 1e-11);
    }
    // A table that is wrong by a tenth of a millimetre makes the self-reported error wrong.
    const Pose target = arm.chain.forward(q);
    Robot wrong = arm;
    std::vector<DhLink> links = arm.chain.links();
    links[2].a += 1e-4;
    wrong.chain = Chain(links, arm.chain.base(), arm.chain.tool());
    const double claimed = (wrong.chain.position(q) - target.translation()).norm();
    CHECK(classify(verify(wrong, {.target = target, .start = q, .answer = q}), {.reported_error = claimed}) ==
          Status::misreported);
  }
}

TEST_CASE("the position error is the Euclidean distance", "[verifier][paper]") {
  // The tool is at (1, 0, 0); the target 0.3 m, 0.4 m, 1.2 m off: 1.3 m away (Eq. 1).
  const Verification verified = verify(
      robot("planar_2"), {.target = place(1.3, 0.4, -1.2), .start = to_eigen({0, 0}), .answer = to_eigen({0, 0})});
  CHECK(verified.position_error == Approx(1.3));
}

TEST_CASE("the orientation error is ||R - Rd|| / ||Rd||", "[verifier][paper]") {
  // R = 1, Rd = Rz(theta): ||R - Rd||^2 = 4 (1 - cos theta), ||Rd||^2 = 3 (Eq. 3 with Frobenius' norm).
  const auto error_at = [](double theta) {
    Pose target = place(1, 0, 0);
    target.linear() = Eigen::AngleAxisd(theta, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    return verify(robot("planar_2"), {.target = target, .start = to_eigen({0, 0}), .answer = to_eigen({0, 0})})
        .orientation_error;
  };
  CHECK(error_at(0) == Approx(0).margin(1e-15));
  CHECK(error_at(pi / 2) == Approx(2 / std::sqrt(3.0)));  // sqrt(4/3)
  CHECK(error_at(pi) == Approx(std::sqrt(8.0 / 3)));      // the largest there is
  CHECK(error_at(pi / 3) == Approx(std::sqrt(2.0 / 3)));  // 4 (1 - 1/2) = 2
}

TEST_CASE("the variation is the norm of the joint moves over all joints, the largest move that of one",
          "[verifier][paper]") {
  const Eigen::VectorXd start = to_eigen({0.1, 0.2, 0.3});
  const Verification verified = verify(
      robot("planar_3"), {.target = place(0, 0, 0), .start = start, .answer = start + to_eigen({0.3, -0.4, 1.2})});
  CHECK(verified.joint_motion == Approx(1.3));  // Eq. 12: sqrt(0.09 + 0.16 + 1.44)
  CHECK(verified.largest_move == Approx(1.2));
  const Verification of_two = verify(
      robot("planar_3"),
      {.target = place(0, 0, 0), .start = start, .answer = start + to_eigen({0.3, -0.4, 1.2}), .motion_joints = 2});
  CHECK(of_two.joint_motion == Approx(0.5));
  CHECK(of_two.largest_move == Approx(1.2));  // of all joints
  CHECK(verify(robot("planar_3"),
               {.target = place(0, 0, 0), .start = start, .answer = start + to_eigen({0.3, -0.4, 0.2})})
            .largest_move == Approx(0.4));  // a move down is a move
}

TEST_CASE("metres of joints that slide and radians of those that turn are never added", "[verifier]") {
  const Robot arm = robot("stanford");  // its third joint slides, from 0.3048 to 1.27 m
  const Eigen::VectorXd start = to_eigen({0, 0, 0.5, 0, 0, 0});
  const Verification verified =
      verify(arm, {.target = place(0, 0, 0), .start = start, .answer = start + to_eigen({0.3, 0, 0.8, 0, -0.4, 0})});
  CHECK(verified.joint_motion == Approx(0.5));
  CHECK(verified.joint_motion_m == Approx(0.8));
  CHECK(verified.largest_move == Approx(0.4));
  CHECK(verified.limit_violation == 0);
  CHECK(verified.limit_violation_m == Approx(0.03));
  CHECK(classify({.limit_violation_m = 0.03}, any) == Status::limit_violated);
}

TEST_CASE("a joint without limits violates none, however far it turns, unless it is not finite", "[verifier]") {
  const Robot arm = robot("kinova_gen3");
  Eigen::VectorXd q = Eigen::VectorXd::Zero(7);
  q[0] = -1e4;
  CHECK(verify(arm, {.target = place(0, 0, 0), .start = q, .answer = q}).limit_violation == 0);
  q[0] = infinity;
  CHECK_FALSE(std::isfinite(verify(arm, {.target = place(0, 0, 0), .start = q, .answer = q}).limit_violation));
}

TEST_CASE("the limit violation is that of the worst joint, on either side", "[verifier]") {
  const double degree = pi / 180;  // limits of the iiwa: 170, 120, 170, 120, 170, 120, 175 deg, Table 2
  const auto violation_deg = [&](std::initializer_list<double> degrees) {
    const Eigen::VectorXd q = to_eigen(degrees) * degree;
    return verify(robot("kuka_iiwa14"), {.target = place(0, 0, 0), .start = Eigen::VectorXd::Zero(7), .answer = q})
               .limit_violation /
           degree;
  };
  CHECK(violation_deg({170, -120, 170, -120, 170, -120, 175}) == Approx(0).margin(1e-12));
  CHECK(violation_deg({0, 121, 0, 0, 0, 0, 0}) == Approx(1));
  CHECK(violation_deg({0, 121, 0, 0, 0, -123.5, 0}) == Approx(3.5));
  CHECK(violation_deg({-190, 0, 0, 0, 0, 0, 176}) == Approx(20));
}

TEST_CASE("an answer that is not finite gives errors that are not finite", "[verifier]") {
  for (const double bad : {not_a_number, infinity, -infinity}) {
    for (int joint = 0; joint < 7; ++joint) {
      Eigen::VectorXd answer = Eigen::VectorXd::Zero(7);
      answer[joint] = bad;
      const Verification verified = verify(
          robot("kuka_iiwa14"), {.target = place(0.5, 0, 0.5), .start = Eigen::VectorXd::Zero(7), .answer = answer});
      CHECK_FALSE((std::isfinite(verified.position_error) && std::isfinite(verified.orientation_error)));
      CHECK_FALSE(std::isfinite(verified.joint_motion));
      CHECK_FALSE(std::isfinite(verified.largest_move));
      CHECK_FALSE(std::isfinite(verified.limit_violation));
      CHECK(classify(verified, any) == Status::not_finite);
    }
  }
}

TEST_CASE("a joint outside its limits by more than rounding is a violation", "[verifier]") {
  const auto violated = [](double outside) {  // the limits of planar_2 are +-180 deg
    return verify(robot("planar_2"),
                  {.target = place(0, 0, 0), .start = to_eigen({0, 0}), .answer = to_eigen({0, pi + outside})})
        .limit_violation;
  };
  CHECK(violated(2e-9) == Approx(2e-9));
  CHECK(violated(0.5e-9) == 0);
  CHECK(classify({.limit_violation = 2e-9}, any) == Status::limit_violated);
  CHECK(classify({.limit_violation = 0}, any) == Status::ok);
}

TEST_CASE("the angle between a target and the tool is that by which the one is turned from the other", "[verifier]") {
  const Robot arm = robot("ur5e");
  const Eigen::VectorXd q = to_eigen({0.1, -0.2, 0.3, -0.4, 0.5, -0.6});
  for (const double angle : {0.0, 1e-9, 1e-3, 0.5, pi / 2, 3.0, pi}) {
    Pose target = arm.chain.forward(q);
    target.rotate(Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, -3).normalized()));
    const double rounding = angle < 3 ? 4e-15 : 3e-8;  // the sine of half of it is flat at half a turn
    CHECK(std::abs(verify(arm, {.target = target, .start = q, .answer = q}).angle - angle) <= rounding);
    // If the tool may turn about its z axis, only the angle between the two z axes counts.
    const Eigen::Matrix3d R = arm.chain.forward(q).linear();
    target.linear() = R * Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 0).normalized()) *
                      Eigen::AngleAxisd(2, Eigen::Vector3d::UnitZ());
    const Verification free = verify(arm, {.target = target, .start = q, .answer = q, .is_axis_free = true});
    CHECK(std::abs(free.angle - angle) <= 3e-8);
    CHECK(std::abs(free.orientation_error - std::sqrt(8.0 / 3) * std::sin(angle / 2)) <= 4e-15);
  }
}

TEST_CASE("where squares are added, both shares of the tolerances are within a circle", "[verifier]") {
  const solvers::StopRule squares{.tolerance = 5, .angle_tolerance = 1, .adds_squares = true};
  CHECK(squares.is_met(3, 0.8));
  CHECK_FALSE(squares.is_met(3, 0.81));
  CHECK_FALSE(squares.is_met(5, 0.1));
}

TEST_CASE("a status is the most severe of what is wrong by more than rounding", "[verifier]") {
  struct Case {
    Verification verified;
    AcceptanceCriteria required;
    Status status;
  };
  constexpr AcceptanceCriteria enforced{.reported_error = 0, .limits_are_enforced = true};
  constexpr AcceptanceCriteria claimed{.reported_error = 1, .stop = {.tolerance = 0.1}};
  const std::vector<Case> cases{
      {{.position_error = 0.01}, {.reported_error = 0.01, .stop = {.tolerance = 0.009}}, Status::tolerance_missed},
      {{.position_error = 0.01}, {.reported_error = 0.01, .stop = {.tolerance = 0.01 - 0.5e-9}}, Status::ok},
      {{.position_error = 0.01}, {.reported_error = 0.01, .stop = {.tolerance = 0.01}}, Status::ok},
      {{.position_error = 0.01}, {.reported_error = 0.01, .stop = {.tolerance = 0}}, Status::ok},
      {{.angle = 0.01}, {.stop = {.tolerance = 1, .angle_tolerance = 0.009}}, Status::tolerance_missed},
      {{.angle = 0.01}, {.stop = {.tolerance = 1, .angle_tolerance = 0.01}}, Status::ok},
      {{.angle = 0.01}, {.stop = {.tolerance = 1}}, Status::ok},
      {{.position_error = 2, .angle = 0.01},
       {.reported_error = 2, .stop = {.tolerance = 1, .angle_tolerance = 1}},
       Status::tolerance_missed},
      {{.limit_violation = 2e-9}, enforced, Status::refused},
      {{.limit_violation = 0}, enforced, Status::ok},
      {{.position_error = 1, .limit_violation = 2e-9}, enforced, Status::misreported},
      {{.position_error = 0.01}, {.reported_error = 0.02}, Status::misreported},
      {{.position_error = 0.02}, {.reported_error = 0.01}, Status::misreported},
      {{.position_error = 0.01}, {.reported_error = 0.01 + 0.5e-9}, Status::ok},
      {{.position_error = 0.01}, {.reported_error = not_a_number}, Status::misreported},
      {{.position_error = 0.01}, {.reported_error = infinity}, Status::misreported},
      {{.orientation_error = 0.1}, {.orientation_is_exact = true}, Status::misreported},
      {{.orientation_error = 0.1}, {.orientation_is_exact = false}, Status::ok},
      {{.orientation_error = 0.5e-9}, {.orientation_is_exact = true}, Status::ok},
      {{.position_error = 1, .limit_violation = 1}, claimed, Status::limit_violated},
      {{.position_error = 2, .limit_violation = 1}, claimed, Status::misreported},
      {{.position_error = infinity, .limit_violation = 1}, claimed, Status::not_finite},
      {{.orientation_error = not_a_number}, claimed, Status::not_finite}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    CAPTURE(i);
    CHECK(classify(cases[i].verified, cases[i].required) == cases[i].status);
  }
}

TEST_CASE("what is claimed of a pose or an axis has to hold of its position and of its orientation", "[verifier]") {
  const bool is_axis = GENERATE(false, true);
  const Robot arm = robot("ur5e");
  const Eigen::VectorXd q = to_eigen({0.1, -0.2, 0.3, -0.4, 0.5, -0.6});
  Pose target = arm.chain.forward(q);
  target.rotate(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX()));
  target.translation() += Eigen::Vector3d(0.03, 0, 0.04);
  const Verification verified = verify(arm, {.target = target, .start = q, .answer = q, .is_axis_free = is_axis});
  Eigen::VectorXd error(1);
  arm.chain.pose_errors(q, target, 0.3, error, is_axis);
  const AcceptanceCriteria honest{.reported_error = 0.05, .reported_pose_error = error[0], .rotation_weight = 0.3};
  CHECK(classify(verified, honest) == Status::ok);
  AcceptanceCriteria wrong = honest;
  wrong.reported_pose_error += 1e-8;
  CHECK(classify(verified, wrong) == Status::misreported);
  wrong.reported_pose_error = not_a_number;
  CHECK(classify(verified, wrong) == Status::misreported);
  wrong = honest;
  wrong.reported_error = 0.04;
  CHECK(classify(verified, wrong) == Status::misreported);
  wrong = honest;
  wrong.rotation_weight = 0.2;
  CHECK(classify(verified, wrong) == Status::misreported);
}

TEST_CASE("a solver that stops by itself is over its budget by half of it", "[verifier]") {
  const solvers::StopRule budget{.iterations = 10, .evaluations = 100, .seconds = 1};
  CHECK_FALSE(exceeds_budget({.seconds = 1.49, .evaluations = 150, .iterations = 15}, budget));
  CHECK(exceeds_budget({.seconds = 1.51}, budget));
  CHECK(exceeds_budget({.evaluations = 151}, budget));
  CHECK(exceeds_budget({.iterations = 16}, budget));
  CHECK_FALSE(exceeds_budget({.seconds = 100, .evaluations = 1000}, {.iterations = 10}));
}
