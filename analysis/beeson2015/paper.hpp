// Beeson and Ames 2015, TRAC-IK, with the table of solve rates that its authors keep in its README.
#pragma once

#include "analysis/report/paper.hpp"

namespace ikbench::beeson2015 {

report::Paper paper();

}  // namespace ikbench::beeson2015
