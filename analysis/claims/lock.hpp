// The lock of a paper as its collection's file says it.
#pragma once

#include <string>

#include "analysis/report/lock.hpp"
#include "numerics/toml_table.hpp"

namespace ikbench::claims {

// Throws std::invalid_argument, also where a solver is not a row of the printed table.
report::Lock read_lock(numerics::TomlReader reader, const std::string& paper);

}  // namespace ikbench::claims
