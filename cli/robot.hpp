// The description of an arm: its joints, reach and wrist.
#pragma once

#include <string>

#include "robots/robot.hpp"

namespace ikbench::cli {

std::string robot_text(const robots::Robot& arm);

}  // namespace ikbench::cli
