#include "robots/functions.hpp"

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "robots/instruction_set.hpp"
#include "robots/kernels.hpp"

namespace ikbench {

static_assert(FLT_EVAL_METHOD == 0, "arithmetic in double, not in registers of another width");

RobotKernels robot_kernels(InstructionSet set) {
#ifdef __x86_64__
  if (set == InstructionSet::x86_64_v4) return x86_64_v4::robot_kernels();
  if (set == InstructionSet::x86_64_v3) return x86_64_v3::robot_kernels();
#else
  static_cast<void>(set);
#endif
  return portable::robot_kernels();
}

const RobotKernels& robot_kernels() {
  static const RobotKernels chosen = robot_kernels(instruction_set());
  return chosen;
}

SinCos sin_cos(double angle) {
  SinCos of;
  robot_kernels().sines_and_cosines(&angle, 1, &of.sine, &of.cosine);
  return of;
}

void sines_and_cosines(const Eigen::Ref<const Eigen::VectorXd>& angles, Eigen::Ref<Eigen::VectorXd> sines,
                       Eigen::Ref<Eigen::VectorXd> cosines) {
  if (sines.size() != angles.size() || cosines.size() != angles.size()) {
    throw std::invalid_argument("as many sines and cosines as angles, or none");
  }
  robot_kernels().sines_and_cosines(angles.data(), angles.size(), sines.data(), cosines.data());
}

double arc_tangent(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
  const double up = std::abs(y), along = std::abs(x);
  const bool steep = up > along;
  // The ratio's arc tangent, from the nearest of 0, 1/2 and 1 on. (inf, inf) has the angle of (1, 1).
  const double ratio = up == along ? (up == 0 ? 0.0 : 1.0) : steep ? along / up : up / along;
  struct Centre {
    double tangent, high, low;  // arc tangent in two parts
  };
  constexpr Centre centres[]{
      {0, 0, 0}, {0.5, 0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56}, {1, std::numbers::pi / 4, 0x1.1a62633145c07p-55}};
  const Centre& centre = centres[ratio < 0.25 ? 0 : ratio < 0.75 ? 1 : 2];
  const double t = (ratio - centre.tangent) / (1 + ratio * centre.tangent);  // |t| <= 1/4
  const double z = t * t;
  double sum = 0;  // Gregory's series; the first term left out is below 2e-17 of the first
  for (int n = 27; n >= 3; n -= 2) sum = z * ((n % 4 == 1 ? 1.0 : -1.0) / n + sum);
  double angle = centre.high + (t + (t * sum + centre.low));
  constexpr double pi_low = 0x1.1a62633145c07p-53;
  if (steep) angle = std::numbers::pi / 2 - (angle - pi_low / 2);
  if (std::signbit(x)) angle = std::numbers::pi - (angle - pi_low);
  return std::copysign(angle, y);
}

double exponential(double x) {
  if (std::isnan(x)) return x;
  if (x > 0x1.62e42fefa39efp+9) return std::numeric_limits<double>::infinity();
  if (x < -708.39) return 0;
  // e^x = 2^n e^r with |r| <= ln(2) / 2, and ln 2 in two parts of which the first has bits to spare.
  constexpr double to_integer = 0x1.8p52;
  const double n = (x * std::numbers::log2e + to_integer) - to_integer;
  const double r = (x - n * 6.93147180369123816490e-01) - n * 1.90821492927058770002e-10;
  double sum = 0;  // Taylor's series; the first term left out is below 1e-18
  for (int k = 13; k >= 2; --k) sum = r / k * (1 + sum);
  const double mantissa = 1 + (r + r * sum);
  // In two steps: 2^1024 is no number.
  const auto half = static_cast<std::int64_t>(n) / 2, rest = static_cast<std::int64_t>(n) - half;
  const auto two_to_the = [](std::int64_t k) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + k) << 52);
  };
  return mantissa * two_to_the(half) * two_to_the(rest);
}

double power(double x, int n) {
  double result = 1;
  for (double square = x; n > 0; n /= 2, square *= square) {
    if (n % 2 == 1) result *= square;
  }
  return result;
}

}  // namespace ikbench
