// Slim, Rokbani, Neji, Terres and Beyrouthy (2023), the bat algorithm for inverse kinematics: the tables, figures and
// sentences that only reports of its study have.
#pragma once

#include "analysis/report/paper.hpp"

namespace ikbench::slim2023 {

void complete(report::Paper& paper);

}  // namespace ikbench::slim2023
