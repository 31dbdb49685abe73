// The units at the edges of the program. Inside, it computes in metres, radians and seconds.
#pragma once

#include <numbers>
#include <string_view>

namespace ikbench::base {

constexpr double centimetre = 0.01;
constexpr double degree = std::numbers::pi / 180;

// Returns what tells that an angle in this unit (`degree`, or 1: radians) was meant in the other, and what to write;
// empty if nothing does. For radians that is more than a turn; for degrees a quarter turn in radians to each of its
// digits, such as 1.57 or 3.1416.
std::string_view doubt_of_angle(double value, double unit);

}  // namespace ikbench::base
