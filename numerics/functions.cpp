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

// Returns 2^k. Requires -1022 <= k <= 1023.
double two_to_the(std::int64_t k) { return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + k) << 52); }

// Returns the smaller of two numbers >= 0, divided by the larger: 0 for two zeros, 1 for two infinities.
double ratio_of(double a, double b) {
  if (a == b) return a == 0 ? 0.0 : 1.0;
  return a > b ? b / a : a / b;
}

// A point about which the arc tangent is expanded.
struct Centre {
  double tangent;
  double high, low;  // the arc tangent in two parts
};

// Returns the nearest of 0, 1/2 and 1 for a ratio in [0, 1].
const Centre& centre_near(double ratio) {
  static constexpr Centre centres[]{
      {0, 0, 0}, {0.5, 0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56}, {1, std::numbers::pi / 4, 0x1.1a62633145c07p-55}};
  if (ratio < 0.25) return centres[0];
  return centres[ratio < 0.75 ? 1 : 2];
}

}  // namespace

IKBENCH_DEFINE_KERNELS

SinCos sin_cos(double angle) {
  SinCos result;
  kernels().sines_and_cosines(&angle, 1, &result.sine, &result.cosine);
  return result;
}

void sines_and_cosines(const Eigen::Ref<const Eigen::VectorXd>& angles, Eigen::Ref<Eigen::VectorXd> sines,
                       Eigen::Ref<Eigen::VectorXd> cosines) {
  kernels().sines_and_cosines(angles.data(), angles.size(), sines.data(), cosines.data());
}

double arc_tangent(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return not_a_number;
  const double up = std::abs(y), along = std::abs(x);
  const bool steep = up > along;
  const double ratio = ratio_of(up, along);
  const Centre& centre = centre_near(ratio);
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
