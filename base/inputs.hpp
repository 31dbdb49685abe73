// The files that the user gave to the program. No output replaces one of them, whatever its name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace ikbench::base {

// Returns the content of a file that the user named, and notes it as an input. Throws std::invalid_argument if it is
// larger than `max_bytes`, missing or no regular file, and as refuse_place (base/files.hpp) if it cannot be read.
std::string text_of_file(const std::filesystem::path& file, std::uintmax_t max_bytes = 10'000'000);
// Notes a file as an input.
void note_input(const std::filesystem::path& file);
// Throws std::invalid_argument, with both names, if the output is an input.
void refuse_input(const std::filesystem::path& output);

}  // namespace ikbench::base
