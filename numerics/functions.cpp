#include "numerics/functions.hpp"

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "numerics/instruction_set.hpp"
#include "numerics/kernels.hpp"

namespace ikbench::numerics {

static_assert(FLT_EVAL_METHOD == 0, "arithmetic in double, not in registers of another width");

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// Requires -1022 <= k <= 1023.
double two_to_the(std::int64_t k) { return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + k) << 52); }

// The sum high + low; low is the rounding error of high, so it has twice the digits of a double (Dekker, Numerische
// Mathematik 18 (1971) 224).
struct Pair {
  double high, low;
};

Pair sum(double larger, double smaller) {
  const double high = larger + smaller;
  return {high, smaller - (high - larger)};
}

Pair sum(Pair larger, Pair smaller) {
  const Pair high = sum(larger.high, smaller.high);
  return sum(high.high, high.low + (larger.low + smaller.low));
}

Pair product(Pair a, Pair b) {
  const double high = a.high * b.high;
  return sum(high, std::fma(a.high, b.high, -high) + (a.high * b.low + a.low * b.high));
}

constexpr Pair ln_2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

// The natural logarithm of a finite x > 0, within 2^-66 of itself.
Pair logarithm_in_two(double x) {
  std::int64_t exponent = 0;
  if (x < std::numeric_limits<double>::min()) {
    x *= 0x1p54;
    exponent = -54;
  }
  // x = 2^exponent (1 + f) with 1 + f in [sqrt(1/2), sqrt(2)).
  constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcdu;
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const std::int64_t shift = static_cast<std::int64_t>(bits - root_half) >> 52;
  exponent += shift;
  const double f = std::bit_cast<double>(bits - (static_cast<std::uint64_t>(shift) << 52)) - 1;
  // log(1 + f) = 2 atanh(s) with s = f / (2 + f), |s| < 0.172; its series, the first terms of it in pairs.
  const Pair divisor = sum(2, f);
  const double ratio = f / divisor.high;
  const Pair s = sum(ratio, (std::fma(-ratio, divisor.high, f) - ratio * divisor.low) / divisor.high);
  const Pair z = product(s, s);
  double tail = 0;  // the first term left out is below 2^-75 of the first
  for (int n = 29; n >= 7; n -= 2) tail = 1.0 / n + z.high * tail;
  constexpr Pair third{0x1.5555555555555p-2, 0x1.5555555555555p-56},
      fifth{0x1.999999999999ap-3, -0x1.999999999999ap-57};
  const Pair series = sum(third, product(z, sum(fifth, product(z, {tail, 0}))));
  const Pair of_mantissa = sum(s, product(s, product(z, series)));
  const Pair twice{2 * of_mantissa.high, 2 * of_mantissa.low};
  if (exponent == 0) return twice;
  return sum(product({static_cast<double>(exponent), 0}, ln_2), twice);
}

// e to the power of x, accurate enough for power(x, y).
double exponential_of(Pair x) {
  if (x.high > 710) return infinity;
  if (x.high < -746) return 0;
  constexpr double to_integer = 0x1.8p52;
  const double n = (x.high * std::numbers::log2e + to_integer) - to_integer;
  const Pair r = sum(std::fma(-n, ln_2.high, x.high), x.low - n * ln_2.low);  // the first of the two is exact
  double series = 0;                                                          // Taylor's, as in exponential()
  for (int k = 14; k >= 3; --k) series = r.high / k * (1 + series);
  const Pair mantissa = sum(1, r.high);
  const double rest = r.high * r.high / 2 * (1 + series) + (r.low + r.low * r.high);
  const double result = mantissa.high + (mantissa.low + rest);
  const auto whole = static_cast<std::int64_t>(n), half = whole / 2;
  return result * two_to_the(half) * two_to_the(whole - half);
}

bool is_whole(double y) { return std::trunc(y) == y; }

}  // namespace

IKBENCH_DEFINE_KERNELS

SinCos sin_cos(double angle) {
  SinCos of;
  kernels().sines_and_cosines(&angle, 1, &of.sine, &of.cosine);
  return of;
}

void sines_and_cosines(const Eigen::Ref<const Eigen::VectorXd>& angles, Eigen::Ref<Eigen::VectorXd> sines,
                       Eigen::Ref<Eigen::VectorXd> cosines) {
  if (sines.size() != angles.size() || cosines.size() != angles.size()) {
    throw std::invalid_argument("as many sines and cosines as angles, or none");
  }
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

double logarithm(double x) {
  if (std::isnan(x) || x < 0) return not_a_number;
  if (x == 0) return -infinity;
  return std::isinf(x) ? x : logarithm_in_two(x).high;
}

double power(double x, int n) {
  double result = 1;
  for (double square = x; n > 0; n /= 2, square *= square) {
    if (n % 2 == 1) result *= square;
  }
  return result;
}

double power(double x, double y) {
  if (x == 1 || y == 0) return 1;
  if (std::isnan(x) || std::isnan(y)) return not_a_number;
  const double size = std::abs(x);
  if (x < 0 && std::isfinite(x) && !is_whole(y)) return not_a_number;
  const double sign = std::signbit(x) && std::isfinite(y) && is_whole(y) && !is_whole(y / 2) ? -1 : 1;
  if (size == 1) return sign;
  if (size == 0 || std::isinf(size) || std::isinf(y)) return sign * ((size > 1) == (y > 0) ? infinity : 0.0);
  const Pair log = logarithm_in_two(size);
  if (std::abs(y) > 0x1p64) return sign * ((log.high > 0) == (y > 0) ? infinity : 0.0);  // since |log| >= 2^-53
  return sign * exponential_of(product({y, 0}, log));
}

}  // namespace ikbench::numerics
