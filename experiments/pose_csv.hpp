// Poses from a CSV file of any origin.
#pragma once

#include <string_view>
#include <vector>

#include "robots/chain.hpp"

namespace ikbench::experiments {

// The first line names the columns, in any order, with their units: x, y and z, each with _m, _cm or _mm; and one of:
// qw, qx, qy, qz (of length 1 to 1 %); roll, pitch, yaw, each with _deg or _rad (Rz(yaw) Ry(pitch) Rx(roll)); r11, r12,
// ... r33 (row by row, a rotation to 1e-3); nothing for a tool that points straight down. Quaternions and matrices are
// made exact. Blanks about a cell are skipped, and what results/csv.hpp skips. Anything else, a number that is not
// finite or beyond 1e6, no row, or more than 100000 rows throws std::invalid_argument with file, line and column.
std::vector<robots::Pose> poses_from_csv(std::string_view text, std::string_view file);

}  // namespace ikbench::experiments
