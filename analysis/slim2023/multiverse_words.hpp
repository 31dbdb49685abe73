// How numbers and choices of a multiverse are said.
#pragma once

#include <span>
#include <string>

#include "analysis/inference/multiverse.hpp"

namespace ikbench::slim2023 {

// "43.2 million", "144"
std::string count_words(double count);
// "the default", or what is not as in the default: "bounds=clamp, population=20".
std::string choice_words(const inference::Multiverse& multiverse,
                         std::span<const inference::Multiverse::Choice> chosen);

}  // namespace ikbench::slim2023
