// The kernels of every instruction set of this machine equal the portable ones bit by bit; these agree with long
// double.
#include "robots/kernels.hpp"

#include <cstdlib>

#include "numerics/elementary.hpp"
#include "numerics/instruction_set.hpp"
#include "numerics/kernels.hpp"
#include "tests/numerics/guarded.hpp"
#include "tests/robots/random_configuration.hpp"

namespace {

KernelLink kernel_link(const DhLink& link) {
  const long double alpha = meant_twist(link.alpha);
  const auto exact = [](long double x) { return std::abs(x) < 1e-15L ? 0.0 : static_cast<double>(x); };
  const double c = exact(std::cos(alpha)), s = exact(std::sin(alpha));
  KernelLink::Twist twist = KernelLink::general;
  if (c == 0) twist = s > 0 ? KernelLink::quarter : KernelLink::minus_quarter;
  if (s == 0 && c == 1) twist = KernelLink::none;
  if (link.beta != 0) twist = KernelLink::leaning;
  const auto beta = static_cast<long double>(link.beta);
  return {twist,
          true,
          link.joint,
          c,
          s,
          link.a,
          link.d,
          link.offset,
          static_cast<double>(std::cos(beta)),
          static_cast<double>(std::sin(beta))};
}

struct Arm {
  std::vector<KernelLink> links;
  Eigen::Vector3d tip;

  Arm(const std::vector<DhLink>& from, Eigen::Vector3d at) : tip(std::move(at)) {
    for (const DhLink& link : from) links.push_back(kernel_link(link));
  }

  KernelChain chain() const {
    const bool all_turn = std::ranges::all_of(links, [](const KernelLink& link) { return link.joint == Joint::turns; });
    return {links.data(), static_cast<int>(links.size()), {tip.x(), tip.y(), tip.z()}, all_turn};
  }
};

Eigen::Vector3d random_target(Dice& dice) { return {dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1)}; }

KernelPose random_pose(Dice& dice) {
  KernelPose pose;
  for (double* const numbers :
       {pose.target, pose.target_axes.x, pose.target_axes.y, pose.tool_axes.x, pose.tool_axes.y}) {
    for (int i = 0; i < 3; ++i) numbers[i] = dice.between(-1, 1);
  }
  return pose;
}

// Checks that the errors of `count` candidates from column `from` on, in rows of `row`, are those of the portable
// kernels, and that nothing before or behind them is written.
void check_errors(const Arm& arm, Dice& dice, ptrdiff_t count, ptrdiff_t row, ptrdiff_t from, Guarded::Page page) {
  const auto joints = static_cast<ptrdiff_t>(arm.links.size());
  CAPTURE(joints, count, row, from);
  // No spare numbers: the last row ends with the last candidate.
  Guarded q(static_cast<std::size_t>((joints - 1) * row + from + count), page);
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = dice.between(-7, 7);
  const KernelPose goal = random_pose(dice);
  const KernelChain chain = arm.chain();
  const auto position_errors = [&](InstructionSet set, double* errors) {
    robots::kernels(set).position_errors(chain, {goal.target}, {q.data() + from, row, count}, errors);
  };
  const auto pose_errors = [&](InstructionSet set, double* errors) {
    robots::kernels(set).pose_errors(chain, goal, {q.data() + from, row, count}, errors);
  };
  const auto check = [&](const auto& errors_by) {
    std::vector<double> expected(static_cast<std::size_t>(count));
    errors_by(InstructionSet::portable, expected.data());
    for (const InstructionSet set : instruction_sets()) {
      CAPTURE(name_of(set));
      Row errors(std::vector<double>(expected.size(), -1), page);
      errors_by(set, errors.data());
      REQUIRE(same_bits(errors.data(), expected.data(), expected.size()));
      REQUIRE(errors.kept_within());
    }
  };
  check(position_errors);
  check(pose_errors);
}

}  // namespace

TEST_CASE("every instruction set gives the portable errors bit for bit, for 1 to 64 joints and 0 to 100 candidates",
          "[kernels]") {
  Dice dice;
  for (int joints = 1; joints <= max_joints; ++joints) {
    const Arm arm(random_links(dice, joints), dice.below(2) * 0.3 * random_target(dice));
    for (ptrdiff_t count = 0; count <= 100; ++count) {
      if (joints > 8 && count > 20 && dice.below(8) != 0) continue;
      const ptrdiff_t from = dice.below(12), row = from + count + dice.below(20);
      check_errors(arm, dice, count, row, from, dice.below(2) == 0 ? Guarded::Page::after : Guarded::Page::before);
    }
  }
}

TEST_CASE("every instruction set gives the portable sines and cosines bit for bit", "[kernels]") {
  Dice dice;
  for (std::size_t count = 0; count <= 100; ++count) {
    for (const Guarded::Page page : {Guarded::Page::after, Guarded::Page::before}) {
      Guarded angles(count, page);
      for (std::size_t i = 0; i < count; ++i) {
        angles[i] = dice.below(10) == 0 ? dice.between(-too_far, too_far) : dice.between(-10, 10);
        if (dice.below(20) == 0) angles[i] = i % 2 == 0 ? infinity : not_a_number;
      }
      std::vector<double> sines(count), cosines(count);
      numerics::kernels(InstructionSet::portable)
          .sines_and_cosines(angles.data(), static_cast<ptrdiff_t>(count), sines.data(), cosines.data());
      for (const InstructionSet set : instruction_sets()) {
        CAPTURE(name_of(set), count);
        Guarded s(count, page), c(count, page);
        numerics::kernels(set).sines_and_cosines(angles.data(), static_cast<ptrdiff_t>(count), s.data(), c.data());
        REQUIRE(same_bits(s.data(), sines.data(), count));
        REQUIRE(same_bits(c.data(), cosines.data(), count));
      }
    }
  }
}

TEST_CASE("an angle that is none spoils its own candidate, in whatever joint, and no other", "[kernels]") {
  Dice dice;
  const std::vector<DhLink> iiwa = robot("kuka_iiwa14").chain.links();
  Arm arm(iiwa, Eigen::Vector3d::Zero());
  arm.links.back().turns = false;
  constexpr ptrdiff_t count = 19;
  for (const InstructionSet set : instruction_sets()) {
    for (ptrdiff_t joint = 0; joint < 7; ++joint) {
      for (const double bad : {not_a_number, infinity, -infinity, 1e300, -1e300, too_far, -too_far}) {
        CAPTURE(name_of(set), joint, bad);
        Candidates q(7, count);
        for (Eigen::Index i = 0; i < q.size(); ++i) q.data()[i] = dice.between(-2, 2);
        const Eigen::Vector3d target = random_target(dice);
        std::vector<double> good(count), errors(count);
        robots::kernels(set).position_errors(arm.chain(), {target.data()}, {q.data(), count, count}, good.data());
        const auto victim = static_cast<std::size_t>(dice.below(count));
        q(joint, static_cast<Eigen::Index>(victim)) = bad;
        robots::kernels(set).position_errors(arm.chain(), {target.data()}, {q.data(), count, count}, errors.data());
        CHECK_FALSE(std::isfinite(errors[victim]));
        errors[victim] = good[victim];
        CHECK(errors == good);
        Eigen::VectorXd by_chain(count);  // the last joint moves nothing
        Chain(iiwa).position_errors(q, target, by_chain);
        CHECK_FALSE(std::isfinite(by_chain[static_cast<Eigen::Index>(victim)]));
        robots::kernels(set).pose_errors(arm.chain(), random_pose(dice), {q.data(), count, count}, errors.data());
        for (std::size_t i = 0; i < errors.size(); ++i) CHECK(std::isfinite(errors[i]) == (i != victim));
      }
    }
  }
}

TEST_CASE("a target that is none, or a link beyond all squares, gives no finite error", "[kernels]") {
  const Arm arm(robot("kuka_iiwa14").chain.links(), Eigen::Vector3d::Zero());
  const std::vector<double> q(7 * 11, 0.3);
  for (const InstructionSet set : instruction_sets()) {
    for (const double bad : {not_a_number, infinity, -infinity, 1e300}) {
      CAPTURE(name_of(set), bad);
      const Eigen::Vector3d at(0.1, 0.2, 0.3);
      const auto check = [&](const Arm& arm_here, const Eigen::Vector3d& target) {
        std::vector<double> errors(11);
        robots::kernels(set).position_errors(arm_here.chain(), {target.data()}, {q.data(), 11, 11}, errors.data());
        for (const double error : errors) CHECK_FALSE(std::isfinite(error));
      };
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        Eigen::Vector3d target = at;
        target[axis] = bad;
        check(arm, target);
      }
      for (std::size_t joint = 0; joint < 7; ++joint) {
        for (const auto length : {&KernelLink::a, &KernelLink::d}) {
          Arm huge = arm;
          huge.links[joint].*length = bad;
          check(huge, at);
        }
      }
    }
  }
}

TEST_CASE("a logarithm is within 2.5 ulp of long double from 2^-52 to 1", "[kernels]") {
  Dice dice;
  double worst = 0;
  const auto logarithm_of = [](double x) {
    std::array<double, numerics::width> all{};
    numerics::store(all.data(), logarithm(numerics::all(x)));
    return all.front();
  };
  const auto check = [&](double x) {
    worst = std::max(worst, last_places(logarithm_of(x), std::log(static_cast<long double>(x))));
  };
  for (int i = 0; i < 1'000'000; ++i) {
    check(1 - std::floor(dice.between(0, 1) * 0x1p52) * 0x1p-52);  // as for a radius of normal numbers
    check(std::exp2(dice.between(-52, 0)));
    check(1 - std::exp2(dice.between(-52, -1)));
  }
  for (int e = 0; e <= 52; ++e) check(std::ldexp(1.0, -e));
  CHECK(worst < 2.5);  // two roundings before the last, of numbers of up to two units
  CHECK(logarithm_of(1.0) == 0);
}

TEST_CASE("an instruction set can be named, and an unknown one is refused with those there are", "[kernels]") {
  const char* const variable = "IKBENCH_INSTRUCTION_SET";
  const std::string before = std::getenv(variable) == nullptr ? "" : std::getenv(variable);
  std::string names;
  for (const InstructionSet set : instruction_sets()) {
    names += (names.empty() ? "" : ", ") + std::string(name_of(set));
    setenv(variable, std::string(name_of(set)).c_str(), 1);
    CHECK(instruction_set() == set);
  }
  setenv(variable, "x86-64-v5", 1);
  CHECK_THAT(complaint<std::invalid_argument>([] { instruction_set(); }),
             StartsWith(variable) && ContainsSubstring("x86-64-v5") && ContainsSubstring(names));
  setenv(variable, "", 1);
  CHECK(instruction_set() == instruction_sets().back());
  setenv(variable, before.c_str(), 1);  // empty: as without it
}
