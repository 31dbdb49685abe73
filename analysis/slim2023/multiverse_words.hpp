// How numbers of universes are said.
#pragma once

#include <string>

namespace ikbench::slim2023 {

// "43.2 million", "144"
std::string count_words(double count);

}  // namespace ikbench::slim2023
