// The elementary functions that decide numbers, against long double.
#include "numerics/functions.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/catch.hpp"
#include "tests/numerics/reference.hpp"

using namespace ikbench;
using namespace ikbench::numerics;
using std::numbers::pi;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// Two numbers next to a multiple of a quarter turn, where the rest of the angle is smallest.
std::vector<double> hard_angles(Dice& dice, double most, int count) {
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) {
    angles.push_back(dice.between(-most, most));
    const double turns = std::round(angles.back() / (pi / 2));
    const auto nearest = static_cast<double>(turns * (std::numbers::pi_v<long double> / 2));
    angles.push_back(nearest);
    angles.push_back(std::nextafter(nearest, dice.below(2) == 0 ? infinity : -infinity));
    angles.push_back((turns + 0.5) * (pi / 2));  // where one polynomial replaces the other
  }
  return angles;
}

}  // namespace

TEST_CASE("sine and cosine are within 1.5 ulp, and 1.6e-33 a quarter turn, of long double", "[functions][sines]") {
  Dice dice;
  double worst = 0;
  for (const double most : {4 * pi, 4 * pi, 1e3, 1e5, 1e9}) {
    for (const double angle : hard_angles(dice, most, 100'000)) {
      const long double exact = angle;
      const double turns = std::abs(angle) / (pi / 2);
      const auto check = [&](double number, long double truth) {
        // pi/2 in two doubles leaves out 1.6e-33 = 1.94 2^-110 (pi/2's bits 108 on).
        const long double off = std::abs(number - truth) - 1.6e-33L * turns;
        if (off > 0) worst = std::max(worst, last_places(number, number < truth ? number + off : number - off));
      };
      const SinCos of = sin_cos(angle);
      check(of.sine, std::sin(exact));
      check(of.cosine, std::cos(exact));
    }
  }
  CHECK(worst < 1.5);
  CHECK(sin_cos(0.0).sine == 0);
  CHECK(sin_cos(0.0).cosine == 1);
}

TEST_CASE("sine and cosine are not a number for angles that are none or too large", "[functions][sines]") {
  for (const double bad : {not_a_number, infinity, -infinity, 1e300, -1e300, too_far, -too_far}) {
    CAPTURE(bad);
    CHECK(std::isnan(sin_cos(bad).sine));
    CHECK(std::isnan(sin_cos(bad).cosine));
  }
  CHECK(std::isfinite(sin_cos(0x1p51 * 1.5707).sine));
}

TEST_CASE("an arc tangent is within 3 ulp of long double in every quadrant", "[functions]") {
  Dice dice;
  double worst = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    // Uniform ratios, or sizes of any magnitude.
    const double turn = dice.between(-pi, pi), scale = std::exp2(dice.between(-300, 300));
    const double y = i % 2 == 0 ? scale * std::sin(turn) : std::copysign(std::exp2(dice.between(-40, 40)), turn);
    const double x = i % 2 == 0 ? scale * std::cos(turn) : dice.between(-1, 1) * std::exp2(dice.between(-40, 40));
    const long double truth = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    worst = std::max(worst, last_places(arc_tangent(y, x), truth));
  }
  CHECK(worst < 3);
}

TEST_CASE("an arc tangent of zeros, infinities and what is no number is that of the C library", "[functions]") {
  const double special[]{0.0, -0.0, 1.0, -1.0, infinity, -infinity, 1e-310, -1e-310, 1e308, -1e308};
  for (const double y : special) {
    for (const double x : special) {
      CAPTURE(y, x);
      const double angle = arc_tangent(y, x), expected = std::atan2(y, x);
      CHECK(std::signbit(angle) == std::signbit(expected));
      CHECK(last_places(angle, expected) <= 1);
    }
  }
  for (const double x : special) {
    CHECK(std::isnan(arc_tangent(not_a_number, x)));
    CHECK(std::isnan(arc_tangent(x, not_a_number)));
  }
}

TEST_CASE("an exponential is within 1 ulp of long double, infinite above and 0 below", "[functions]") {
  Dice dice;
  double worst = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const double x = i % 2 == 0 ? dice.between(-708.39, 709.78) : dice.between(-2, 2);
    worst = std::max(worst, last_places(exponential(x), std::exp(static_cast<long double>(x))));
  }
  CHECK(worst < 1);
  CHECK(exponential(0) == 1);
  CHECK(exponential(-0.0) == 1);
  const double last = 709.78271289338397;  // log of the largest double
  CHECK(last_places(exponential(last), std::exp(static_cast<long double>(last))) < 1);
  for (const double x : {std::nextafter(last, infinity), 1e3, 1e300, infinity}) CHECK(exponential(x) == infinity);
  for (const double x : {-708.4, -1e3, -1e300, -infinity}) CHECK(exponential(x) == 0);
  CHECK(exponential(-708.39) > 0);
  CHECK(std::isnan(exponential(not_a_number)));
}

TEST_CASE("a power is the product of its factors", "[functions]") {
  CHECK(power(3, 0) == 1);
  CHECK(power(0, 0) == 1);
  CHECK(power(0, 5) == 0);
  for (int n = 0; n <= 33; ++n) CHECK(power(-3, n) == (n % 2 == 0 ? 1 : -1) * std::round(std::pow(3.0L, n)));
  Dice dice;
  for (int i = 0; i < 10000; ++i) {
    const double x = dice.between(0, 1.5);
    const int n = dice.below(320);  // MO-PSO takes five times the joints
    const long double truth = std::pow(static_cast<long double>(x), n);
    if (truth > 1e-300L)
      CHECK(last_places(power(x, n), truth) < n + 1);  // half an ulp per product, and squares grow it
  }
}

TEST_CASE("a logarithm is within 0.51 ulp of long double for every size of number", "[functions]") {
  Dice dice;
  double worst = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const double x = i % 3 == 0   ? std::exp2(dice.between(-1074, 1024))                         // every exponent
                     : i % 3 == 1 ? dice.between(0.5, 2)                                         // small logarithms
                                  : 1 + dice.between(-1, 1) * std::exp2(dice.between(-52, -2));  // smaller ones
    worst = std::max(worst, last_places(logarithm(x), std::log(static_cast<long double>(x))));
  }
  CHECK(worst < 0.51);
  const double largest = std::numeric_limits<double>::max(), smallest = std::numeric_limits<double>::denorm_min();
  for (const double x : {largest, smallest, 3 * smallest, std::numeric_limits<double>::min()}) {
    CHECK(last_places(logarithm(x), std::log(static_cast<long double>(x))) < 0.51);
  }
}

TEST_CASE("a logarithm of 0 is minus infinity and of less is not a number", "[functions]") {
  CHECK(logarithm(1) == 0);
  CHECK_FALSE(std::signbit(logarithm(1)));
  CHECK(logarithm(0.0) == -infinity);
  CHECK(logarithm(-0.0) == -infinity);
  CHECK(logarithm(infinity) == infinity);
  for (const double bad : {-1.0, -1e-310, -1e300, -infinity, not_a_number}) CHECK(std::isnan(logarithm(bad)));
}

TEST_CASE("a real power is within 0.7 ulp of long double, within 1 ulp where it is denormal", "[functions]") {
  Dice dice;
  double worst = 0, worst_denormal = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const double x = i % 2 == 0 ? std::exp2(dice.between(-1074, 1024)) : dice.between(0.25, 4);
    // Any result from below the denormal numbers to infinity; or a typical printed exponent.
    const double y = i % 4 < 2 ? dice.between(-1080, 1026) / std::log2(x) : dice.between(-8, 8);
    const long double truth = std::pow(static_cast<long double>(x), static_cast<long double>(y));
    const double number = power(x, y);
    if (truth > std::numeric_limits<double>::max()) {
      CHECK((number == infinity || number == std::numeric_limits<double>::max()));
    } else if (truth < std::numeric_limits<double>::min()) {
      worst_denormal = std::max(worst_denormal, last_places(number, truth));
    } else {
      worst = std::max(worst, last_places(number, truth));
    }
  }
  CHECK(worst < 0.7);
  CHECK(worst_denormal < 1);
}

TEST_CASE("a real power near 1 with a huge exponent is that of long double", "[functions]") {
  Dice dice;
  double worst = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double size = std::exp2(dice.between(-52, -2)), x = 1 + (i % 2 == 0 ? size : -size);
    const double y = dice.between(-700, 700) / std::log1p(x - 1);  // up to 3e18
    const long double truth = std::exp(static_cast<long double>(y) * std::log1p(static_cast<long double>(x) - 1));
    // The exponent of the truth is itself rounded, to 2^-64 of up to 700.
    worst = std::max(worst, last_places(power(x, y), truth));
  }
  CHECK(worst < 1.2);
}

TEST_CASE("a real power that is a double is that double", "[functions]") {
  for (int n = 0; n <= 22; ++n) CHECK(power(10, static_cast<double>(n)) == power(10, n));  // 10^22 is a double
  for (int n = -1074; n <= 1023; ++n) {
    CHECK(power(2, static_cast<double>(n)) == std::ldexp(1.0, n));
    CHECK(power(std::ldexp(1.0, n), 1.0) == std::ldexp(1.0, n));
  }
  Dice dice;
  for (int i = 0; i < 10000; ++i) {
    const double root = dice.below(1 << 26), x = dice.between(-1e6, 1e6);
    CHECK(power(root * root, 0.5) == root);
    CHECK(power(-root, 2.0) == root * root);
    CHECK(power(x, 1.0) == x);
  }
}

TEST_CASE("a real power of zeros, infinities, negative numbers and what is no number is that of std::pow",
          "[functions]") {
  const double special[]{0.0,   1.0,    2.0,    3.0,      0.5,  1.5,  1e-310,       1e-320,   1e308,
                         1e300, 0x1p53, 0x1p64, 1e18 + 1, 1e16, 7e15, 0x1p52 + 0.5, infinity, not_a_number};
  for (const double x_size : special) {
    for (const double y_size : special) {
      for (const double x : {x_size, -x_size}) {
        for (const double y : {y_size, -y_size}) {
          CAPTURE(x, y);
          const double number = power(x, y), expected = std::pow(x, y);
          CHECK(std::isnan(number) == std::isnan(expected));
          if (std::isnan(expected)) continue;
          CHECK(std::signbit(number) == std::signbit(expected));
          CHECK((number == expected || last_places(number, expected) <= 1));
        }
      }
    }
  }
}

TEST_CASE("logarithms and real powers have the same bits from every compiler and on every processor", "[functions]") {
  Dice dice;
  std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a, one number at a time
  const auto add = [&](double number) { hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 0x100000001b3u; };
  for (int i = 0; i < 100'000; ++i) {
    const double x = dice.between(0, 10), y = dice.between(-5, 5);
    add(logarithm(x));
    add(power(x, y));
  }
  CHECK(hash == 0xd40dadf6ab400a58u);
}
