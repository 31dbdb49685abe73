// The program computes in metres, radians and seconds. These constants convert other units at its edges.
#pragma once

#include <numbers>
#include <string_view>

namespace ikbench::base {

constexpr double centimetre = 0.01;
constexpr double degree = std::numbers::pi / 180;

// What says that an angle in this unit (`degree`, or 1: radians) was meant in the other, and what to write; empty if
// nothing does. Of radians more than a turn, of degrees quarter turns in radians to each of their digits: 1.57, 3.1416.
std::string_view doubt_of_angle(double value, double unit);

}  // namespace ikbench::base
