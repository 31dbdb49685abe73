#include "numerics/functions.hpp"

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "numerics/instruction_set.hpp"
#include "numerics/kernels.hpp"

namespace ikbench::numerics {

static_assert(FLT_EVAL_METHOD == 0, "arithmetic in double, not in registers of another width");

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// Requires -1022 <= k <= 1023.
double two_to_the(std::int64_t k) { return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + k) << 52); }

}  // namespace

IKBENCH_DEFINE_KERNELS

SinCos sin_cos(double angle) {
  SinCos of;
  kernels().sines_and_cosines(&angle, 1, &of.sine, &of.cosine);
  return of;
}

void sines_and_cosines(const Eigen::Ref<const Eigen::VectorXd>& angles, Eigen::Ref<Eigen::VectorXd> sines,
                       Eigen::Ref<Eigen::VectorXd> cosines) {
  kernels().sines_and_cosines(angles.data(), angles.size(), sines.data(), cosines.data());
}

double arc_tangent(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return not_a_number;
  const double up = std::abs(y), along = std::abs(x);
  const bool steep = up > along;
  // The ratio's arc tangent, expanded about the nearest of 0, 1/2 and 1. (inf, inf) has the angle of (1, 1).
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
  if (x > 0x1.62e42fefa39efp+9) return infinity;
  if (x < -708.39) return 0;
  // e^x = 2^n e^r with |r| <= ln(2) / 2; ln 2 in two parts, so that n times the first is exact.
  constexpr double to_integer = 0x1.8p52;
  const double n = (x * std::numbers::log2e + to_integer) - to_integer;
  const double r = (x - n * 6.93147180369123816490e-01) - n * 1.90821492927058770002e-10;
  double sum = 0;  // Taylor's series; the first term left out is below 1e-18
  for (int k = 13; k >= 2; --k) sum = r / k * (1 + sum);
  const double mantissa = 1 + (r + r * sum);
  // In two steps, since 2^1024 is not a double.
  const auto half = static_cast<std::int64_t>(n) / 2, rest = static_cast<std::int64_t>(n) - half;
  return mantissa * two_to_the(half) * two_to_the(rest);
}

double power(double x, int n) {
  double result = 1;
  for (double square = x; n > 0; n /= 2, square *= square) {
    if (n % 2 == 1) result *= square;
  }
  return result;
}

}  // namespace ikbench::numerics
