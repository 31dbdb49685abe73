// Where the joints of an arm are, so that it can be drawn.
#pragma once

#include <array>
#include <vector>

#include "analysis/inference/definition.hpp"

namespace ikbench::figures {

using Point = std::array<double, 3>;  // x, y, z [m]

// The corners of the arm from the base to the tool. None where the definition has no arm of a known kind, or the angles
// are not those of its joints.
std::vector<Point> arm_points(const inference::Definition& definition, const std::vector<double>& angles_rad);

}  // namespace ikbench::figures
