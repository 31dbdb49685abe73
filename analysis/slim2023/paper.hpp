// Slim, Rokbani, Neji, Terres and Beyrouthy (2023), the bat algorithm for inverse kinematics: all that a report of its
// study has of the paper itself.
#pragma once

#include "analysis/report/paper.hpp"

namespace ikbench::slim2023 {

report::Paper paper();

}  // namespace ikbench::slim2023
