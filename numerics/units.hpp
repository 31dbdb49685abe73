// The program computes in metres, radians and seconds. These constants convert other units at its edges.
#pragma once

#include <numbers>

namespace ikbench::numerics {

constexpr double centimetre = 0.01;
constexpr double degree = std::numbers::pi / 180;

}  // namespace ikbench::numerics
