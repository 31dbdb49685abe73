// The description of an arm: its joints, reach and wrist, in words and as data.
#pragma once

#include <string>

#include "numerics/json.hpp"
#include "robots/robot.hpp"

namespace ikbench::cli {

std::string robot_text(const robots::Robot& arm);
numerics::OrderedJson robot_json(const robots::Robot& arm);

}  // namespace ikbench::cli
