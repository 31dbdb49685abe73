#include "robots/closed_form.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "robots/robot.hpp"
#include "tests/catch.hpp"
#include "tests/robots/random_configuration.hpp"

using namespace ikbench;
using namespace ikbench::robots;
using std::numbers::pi;

namespace {

constexpr double right_angle = pi / 2;

// An arm whose first three links are these, with the wrist's centre 0.42 m behind them, and a base and a tool.
Chain with_wrist(std::vector<DhLink> links) {
  links.push_back({.alpha = right_angle, .d = 0.42, .offset = 0.2});
  links.push_back({.alpha = -right_angle, .offset = -0.1});
  links.push_back({.d = 0.08, .offset = 0.5});
  return {links, {{0.1, -0.2, 0.3}, {0.3, -0.2, 1}}, {{0.02, 0.01, 0.15}, {0.1, 0.7, -0.4}}};
}

Chain anthropomorphic() {  // as most industrial arms: axes 2 and 3 parallel, a length between axes 1 and 2
  return with_wrist({{.a = 0.025, .alpha = -right_angle, .d = 0.4, .offset = 0.1},
                     {.a = 0.455, .offset = -right_angle},
                     {.a = 0.035, .alpha = -right_angle}});
}

Chain general() {
  return with_wrist({{.a = 0.15, .alpha = 1.1, .d = 0.3, .offset = 0.4},
                     {.a = 0.4, .alpha = -0.7, .d = 0.1},
                     {.a = 0.05, .alpha = 0.9, .d = -0.08}});
}

struct NamedArm {
  std::string name;
  Chain chain;
  std::vector<int> counts;  // possible numbers of branches of a reachable pose
};

std::vector<NamedArm> arms() {
  return {{"abb_irb120", robot("abb_irb120").chain, {8}},
          {"puma560", robot("puma560").chain, {8}},
          {"anthropomorphic", anthropomorphic(), {4, 8}},
          {"general", general(), {4, 8}},
          {"first axes meet",
           with_wrist({{.alpha = 0.8, .d = 0.3}, {.a = 0.4, .alpha = 0.6, .d = 0.1}, {.a = 0.1, .alpha = 1.2}}),
           {4, 8}},
          {"first axes parallel",
           with_wrist({{.a = 0.3}, {.a = 0.35, .alpha = right_angle}, {.a = 0.02, .alpha = -right_angle}}),
           {4, 8}},
          {"all at right angles",
           with_wrist({{.a = 0.1, .alpha = right_angle},
                       {.a = 0.3, .alpha = -right_angle, .d = 0.05},
                       {.a = 0.1, .alpha = right_angle, .d = 0.02}}),
           {4, 8}}};
}

JointLimits anything() { return {Eigen::VectorXd::Constant(6, -pi), Eigen::VectorXd::Constant(6, pi)}; }

// The largest difference of an angle, modulo whole turns.
double apart(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a - b).unaryExpr([](double angle) { return std::abs(std::remainder(angle, 2 * pi)); }).maxCoeff();
}

// The distance in metres, and in radians by the chord of the angle between the orientations.
double way(const Chain& chain, const Eigen::VectorXd& q, const Pose& wanted) {
  const Pose T = chain.forward(q);
  return std::max((T.translation() - wanted.translation()).norm(),
                  (T.linear() - wanted.linear()).norm() / std::sqrt(2));
}

const Eigen::VectorXd folded = Eigen::VectorXd::Zero(6);

}  // namespace

TEST_CASE("a configuration is among the branches of its pose, and every branch reaches that", "[closed_form]") {
  for (const NamedArm& arm : arms()) {
    CAPTURE(arm.name);
    const ClosedForm closed_form(arm.chain);
    RandomConfigurations random;
    std::vector<int> seen;
    for (int trial = 0; trial < 2000; ++trial) {
      const Eigen::VectorXd q = random(anything());
      const Pose T = arm.chain.forward(q);
      const ClosedForm::Branches branches = closed_form.branches(T, folded);
      CAPTURE(q.transpose(), branches.cols());
      const int count = static_cast<int>(branches.cols());
      REQUIRE(std::ranges::count(arm.counts, count) == 1);
      seen.push_back(count);
      double nearest = pi;
      for (Eigen::Index i = 0; i < count; ++i) {
        REQUIRE(branches.col(i).cwiseAbs().maxCoeff() <= pi);
        REQUIRE(way(arm.chain, branches.col(i), T) < 1e-9);
        for (Eigen::Index j = 0; j < i; ++j) REQUIRE(apart(branches.col(i), branches.col(j)) > 1e-6);
        nearest = std::min(nearest, apart(branches.col(i), q));
      }
      REQUIRE(nearest < 1e-9);
    }
    for (const int count : arm.counts) CHECK(std::ranges::count(seen, count) > 0);
  }
}

TEST_CASE("the IRB 120's elbow is up or down, its shoulder before or behind, its wrist flipped or not",
          "[closed_form]") {
  // With theta1 turned by half a turn the wrist's centre is reached backwards; theta4 and theta6 turn with theta5's
  // sign.
  const Chain chain = robot("abb_irb120").chain;
  const Eigen::VectorXd q = (Eigen::VectorXd(6) << 0.3, 0.4, -0.5, 0.6, 0.7, -0.8).finished();
  const ClosedForm::Branches branches = ClosedForm(chain).branches(chain.forward(q), folded);
  REQUIRE(branches.cols() == 8);
  const auto count = [&](const auto& is_so) { return std::ranges::count_if(branches.colwise(), is_so); };
  CHECK(count([](const auto& branch) { return std::abs(branch[0] - 0.3) < 1e-9; }) == 4);
  CHECK(count([](const auto& branch) { return std::abs(branch[0] - (0.3 - pi)) < 1e-9; }) == 4);
  CHECK(count([](const auto& branch) { return branch[4] > 0; }) == 4);
}

TEST_CASE("at singular configurations every branch reaches the pose", "[closed_form]") {
  RandomConfigurations random;
  for (const NamedArm& arm : arms()) {
    CAPTURE(arm.name);
    const ClosedForm closed_form(arm.chain);
    for (int trial = 0; trial < 300; ++trial) {
      Eigen::VectorXd q = random(anything());
      // The wrist is stretched or folded; or angles are quarter turns, where arms of right angles are stretched too.
      if (trial % 3 == 0) q[4] = -arm.chain.links()[4].offset + (trial % 2 == 0 ? 0 : pi);
      for (int j = 0; trial % 3 != 0 && j < 6; ++j) {
        if (trial % 3 == 1 || j < 3)
          q[j] = right_angle * std::round(q[j] / right_angle) - arm.chain.links()[static_cast<std::size_t>(j)].offset;
      }
      const Pose T = arm.chain.forward(q);
      const ClosedForm::Branches branches = closed_form.branches(T, q);
      CAPTURE(trial, q.transpose(), branches.cols());
      for (const auto& branch : branches.colwise()) REQUIRE(way(arm.chain, branch, T) < 1e-9);
      if (trial % 3 == 0) REQUIRE(branches.cols() > 0);
    }
  }
}

TEST_CASE("a stretched arm has one branch for its elbow", "[closed_form]") {
  // The IRB 120's elbow stretched: the wrist's centre, the elbow and the shoulder in a line.
  const Chain chain = robot("abb_irb120").chain;
  Eigen::VectorXd q = (Eigen::VectorXd(6) << 0.3, 0.4, 0, 0.6, 0.7, -0.8).finished();
  q[2] = std::atan2(0.302, 0.07) - pi;  // the centre is 0.302 m along and 0.07 m beside the third link
  for (const double side : {0.0, pi}) {
    q[2] += side;
    const Pose T = chain.forward(q);
    const ClosedForm::Branches branches = ClosedForm(chain).branches(T, folded);
    CAPTURE(side, branches);
    for (const auto& branch : branches.colwise()) REQUIRE(way(chain, branch, T) < 1e-9);
  }
}

TEST_CASE("a joint whose axis goes through the wrist's centre stays where it is", "[closed_form]") {
  // The IRB 120 with its wrist's centre above its shoulder: joint 1 is free.
  const Chain chain = robot("abb_irb120").chain;
  Pose T = Pose::Identity();
  T.linear() = chain.forward(folded).linear();
  T.translation() = Eigen::Vector3d(0, 0, 0.29 + 0.4) + T.linear() * Eigen::Vector3d(0, 0, 0.072);
  const Eigen::VectorXd near = Eigen::VectorXd::Constant(6, 0.2);
  const ClosedForm::Branches branches = ClosedForm(chain).branches(T, near);
  CHECK(branches.cols() > 0);
  for (const auto& branch : branches.colwise()) {
    CHECK(branch[0] == Approx(0.2).epsilon(1e-8));
    CHECK(way(chain, branch, T) < 1e-9);
  }
}

TEST_CASE("a pose out of reach or not finite has no branches", "[closed_form]") {
  for (const NamedArm& arm : arms()) {
    CAPTURE(arm.name);
    const ClosedForm closed_form(arm.chain);
    for (const double far :
         {5.0, 1e3, 1e100, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
      Pose T = arm.chain.forward(folded);
      T.translation().x() = far;
      CHECK(closed_form.branches(T, folded).cols() == 0);
      T.linear()(0, 0) = far;
      CHECK(closed_form.branches(T, folded).cols() == 0);
    }
  }
}

TEST_CASE("an arm without a closed form is refused with the reason", "[closed_form]") {
  const auto refused = [](const Chain& chain, const std::string& why) {
    CHECK(ClosedForm::why_not(chain) == why);
    CHECK_THROWS_WITH(ClosedForm(chain),
                      "an arm with a closed form has six joints that turn and a spherical wrist; this arm " + why);
  };
  refused(robot("kuka_iiwa14").chain, "has 7 joints, not six");
  refused(robot("stanford").chain, "has a joint that does not turn, number 3");
  refused(robot("ur5e").chain, "has no spherical wrist");
  refused(robot("kinova_jaco2").chain, "has no spherical wrist");
  const std::string stuck = "cannot move its wrist in all directions with its first three joints";
  refused(with_wrist({{.a = 0.3}, {.a = 0.3}, {.a = 0.2}}), stuck);  // three parallel axes
  refused(with_wrist({{.alpha = right_angle}, {.alpha = -right_angle}, {.alpha = right_angle}}),
          stuck);                                                                          // three that meet
  refused(with_wrist({{.d = 0.3}, {.a = 0.3, .alpha = right_angle}, {.a = 0.2}}), stuck);  // the first two the same
}
