// References for kernels and chains: Eqs. 18 and 26 as 4x4 products in long double, and distances in last places.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "robots/chain.hpp"

namespace ikbench {

using LongPoint = std::array<long double, 3>;

// A twist within 1e-15 of quarter turns counts as exactly that many.
inline long double meant_twist(double alpha) {
  constexpr long double quarter = std::numbers::pi_v<long double> / 2;
  const long double turns = std::round(static_cast<long double>(alpha) / quarter);
  return std::abs(alpha - turns * quarter) < 1e-15L ? turns * quarter : static_cast<long double>(alpha);
}

using LongMatrix = std::array<std::array<long double, 4>, 4>;

inline LongMatrix product(const LongMatrix& left, const LongMatrix& right) {
  LongMatrix result{};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      for (std::size_t k = 0; k < 4; ++k) result[row][column] += left[row][k] * right[k][column];
    }
  }
  return result;
}

// Eq. 18; a coupled link is turned about y, and after it back. Without the turn by beta.
inline LongMatrix unleaning_matrix(const robots::DhLink& link, long double joint) {
  const long double theta = link.joint == robots::Joint::slides ? link.offset : joint + link.offset;
  const long double d = link.joint == robots::Joint::slides ? joint + link.d : link.d, alpha = meant_twist(link.alpha);
  const long double c = std::cos(theta), s = std::sin(theta), ca = std::cos(alpha), sa = std::sin(alpha);
  if (link.joint == robots::Joint::coupled) {
    return {{{1, 0, 0, c * link.a + s * d}, {0, ca, -sa, 0}, {0, sa, ca, c * d - s * link.a}, {0, 0, 0, 1}}};
  }
  return {{{c, -s * ca, s * sa, link.a * c}, {s, c * ca, -c * sa, link.a * s}, {0, sa, ca, d}, {0, 0, 0, 1}}};
}

inline LongMatrix reference_matrix(const robots::DhLink& link, long double joint) {
  const long double c = std::cos(static_cast<long double>(link.beta)),
                    s = std::sin(static_cast<long double>(link.beta));
  return product(unleaning_matrix(link, joint), {{{c, 0, s, 0}, {0, 1, 0, 0}, {-s, 0, c, 0}, {0, 0, 0, 1}}});
}

inline LongMatrix reference_matrix(const robots::Frame& frame) {
  const auto turned = [](std::size_t from, std::size_t to, long double angle) {
    LongMatrix turn{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    turn[from][from] = turn[to][to] = std::cos(angle);
    turn[to][from] = std::sin(angle);
    turn[from][to] = -std::sin(angle);
    return turn;
  };
  LongMatrix pose =
      product(turned(0, 1, frame.rpy.z()), product(turned(2, 0, frame.rpy.y()), turned(1, 2, frame.rpy.x())));
  for (std::size_t row = 0; row < 3; ++row) pose[row][3] = frame.position[static_cast<Eigen::Index>(row)];
  return pose;
}

template <class Angles>
LongMatrix reference_pose(const robots::Chain& chain, const Angles& q) {
  LongMatrix pose = reference_matrix(chain.base());
  Eigen::Index joint = 0;
  for (const robots::DhLink& link : chain.links()) pose = product(pose, reference_matrix(link, q[joint++]));
  return product(pose, reference_matrix(chain.tool()));
}

template <class Angles>
LongPoint reference_position(const robots::Chain& chain, const Angles& q) {
  const LongMatrix pose = reference_pose(chain, q);
  return {pose[0][3], pose[1][3], pose[2][3]};
}

inline long double reference_distance(const LongPoint& point, const Eigen::Vector3d& target) {
  const long double x = point[0] - target.x(), y = point[1] - target.y(), z = point[2] - target.z();
  return std::sqrt(x * x + y * y + z * z);
}

// Distance of a number from the true one, in units of the true one's last place as a double.
inline double last_places(double number, long double truth) {
  if (static_cast<long double>(number) == truth) return 0;
  int exponent = 0;
  std::frexp(truth, &exponent);
  const long double place = std::ldexp(1.0L, std::max(exponent - 53, -1074));
  return static_cast<double>(std::abs(static_cast<long double>(number) - truth) / place);
}

// pi/2 is below 1.5708: 2^51 quarter turns and a little more, the smallest of the angles that are refused for certain.
constexpr double too_far = 0x1p51 * 1.5708;

struct Dice {
  std::mt19937_64 engine{20230305};
  double between(double low, double high) { return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53; }
  int below(int count) { return static_cast<int>(engine() % static_cast<unsigned>(count)); }
};

// Half of them have joints of any kind; in the others all turn.
inline std::vector<robots::DhLink> random_links(Dice& dice, int joints) {
  constexpr double pi = std::numbers::pi;
  const bool all_turn = dice.below(2) == 0;
  std::vector<robots::DhLink> links(static_cast<std::size_t>(joints));
  for (robots::DhLink& link : links) {
    const int turns = dice.below(5) - 2;  // exact quarter turns, also two; or any twist
    link = {.a = dice.below(2) == 0 ? 0 : dice.between(-1, 1),
            .alpha = dice.below(3) == 0 ? dice.between(-pi, pi) : turns * (pi / 2),
            .d = dice.below(2) == 0 ? 0 : dice.between(-1, 1),
            .offset = dice.below(2) == 0 ? 0 : dice.between(-pi, pi),
            .joint = all_turn ? robots::Joint::turns : static_cast<robots::Joint>(dice.below(3)),
            .beta = dice.below(5) == 0 ? dice.between(-pi, pi) : 0};
  }
  return links;
}

// Of up to nine joints, perhaps with a base and a turned tool.
inline robots::Chain random_chain(Dice& dice) {
  const auto three = [&](double most) -> Eigen::Vector3d {
    return {dice.between(-most, most), dice.between(-most, most), dice.between(-most, most)};
  };
  robots::Frame base, tool{.position = three(1)};
  if (dice.below(2) == 0) base = {three(1), three(std::numbers::pi)};
  if (dice.below(2) == 0) tool.rpy = three(std::numbers::pi);
  return {random_links(dice, 1 + dice.below(9)), base, tool};
}

inline Eigen::VectorXd random_joints(const robots::Chain& chain, Dice& dice, double most_turned = 3) {
  Eigen::VectorXd q(chain.joints());
  for (Eigen::Index j = 0; j < q.size(); ++j) q[j] = (chain.slides(j) ? 3 : most_turned) * dice.between(-1, 1);
  return q;
}

inline Eigen::VectorXd vector_of(std::initializer_list<double> values) {
  return Eigen::Map<const Eigen::VectorXd>(values.begin(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace ikbench
