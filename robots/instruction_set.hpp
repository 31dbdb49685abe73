// Which instruction sets the program can use on this machine, and which it does.
#pragma once

#include <string_view>
#include <vector>

namespace ikbench {

std::vector<std::string_view> instruction_sets();
std::string_view instruction_set();

}  // namespace ikbench
