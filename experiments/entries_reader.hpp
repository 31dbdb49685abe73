// Reads the entries of a study: what each solver is, its settings, and the values that a sweep gives them.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "experiments/study.hpp"
#include "numerics/toml_table.hpp"

namespace ikbench::experiments {

constexpr std::size_t most_swept = 200;  // entries of a study with a sweep

// The folder of a file that a key names: the study's, or the current one if --set gave the key.
std::filesystem::path folder_of(const numerics::TomlReader& reader, std::string_view key);

// Removes entries that may be left out and whose solvers this program was built without.
std::vector<LeftOut> leave_out(toml::table& study);

// Reads [[solvers]]. A setting that has a list of values, in the entry or in the table [sweep], makes one entry per
// combination: "IK-BA population=20". A key of [sweep] is a setting of every solver that has it, or with a label or a
// solver's name in front ("IK-BA.alpha") of these alone; it replaces what the entry says.
std::vector<SolverEntry> read_solvers(numerics::TomlReader& study, const std::vector<LeftOut>& left_out);

}  // namespace ikbench::experiments
