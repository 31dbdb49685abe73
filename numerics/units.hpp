// Inside the program are metres, radians and seconds; these turn what stands at the edges into them.
#pragma once

#include <numbers>

namespace ikbench::numerics {

constexpr double centimetre = 0.01;
constexpr double degree = std::numbers::pi / 180;

}  // namespace ikbench::numerics
