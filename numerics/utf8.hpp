// Any text (labels and titles come from files of users) as one line of whole characters.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ikbench::numerics {

// One line of valid UTF-8: control characters become blanks, bytes that are none U+FFFD.
std::string one_line(std::string_view text);
std::size_t character_count(std::string_view utf8);
// One line of at most so many characters; an ellipsis stands for its middle, because variants differ at their ends.
std::string shortened(std::string_view text, std::size_t length);

}  // namespace ikbench::numerics
