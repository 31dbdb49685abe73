// Checks that the fields of a study fit each other.
#pragma once

#include "experiments/study.hpp"
#include "numerics/toml_table.hpp"
#include "robots/robot.hpp"

namespace ikbench::experiments {

// Checks a study as it was read, with its arm. std::invalid_argument says where, what is wrong, and what is expected.
void check_fields(const numerics::TomlReader& reader, const Study& study, const robots::Robot& arm);

}  // namespace ikbench::experiments
