// The files that somebody gave to the program: no output replaces one, whatever its name.
#pragma once

#include <filesystem>

namespace ikbench::numerics {

void note_input(const std::filesystem::path& file);
// Throws std::invalid_argument with both names if the output is an input.
void refuse_input(const std::filesystem::path& output);

}  // namespace ikbench::numerics
