// The files that somebody gave to the program: no output replaces one, whatever its name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace ikbench::base {

// The content of a user's file, an input. Throws std::invalid_argument if it is larger than `largest` bytes, no file or
// no regular one, and as refuse_place (base/files.hpp) if it cannot be read.
std::string text_of_file(const std::filesystem::path& file, std::uintmax_t largest = 10'000'000);
void note_input(const std::filesystem::path& file);
// Throws std::invalid_argument with both names if the output is an input.
void refuse_input(const std::filesystem::path& output);

}  // namespace ikbench::base
