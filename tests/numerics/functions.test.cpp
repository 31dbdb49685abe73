// The elementary functions that decide numbers, against long double.
#include "numerics/functions.hpp"

#include "tests/common.hpp"
#include "tests/numerics/reference.hpp"

using namespace ikbench::numerics;
using std::numbers::pi;

namespace {

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

TEST_CASE("a product of vectors has the same order of sums with every version of Eigen", "[functions]") {
  Dice dice;
  for (int i = 0; i < 1000; ++i) {
    Eigen::Matrix<double, 6, 1> a, b, p;
    for (int k = 0; k < 6; ++k) p[k] = (a[k] = dice.between(-1, 1)) * (b[k] = dice.between(-1, 1));
    REQUIRE(dot(a, b) == (p[0] + (p[1] + p[2])) + (p[3] + (p[4] + p[5])));
    REQUIRE(dot(a.head<3>(), b.head<3>()) == p[0] + (p[1] + p[2]));
  }
}
