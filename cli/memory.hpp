// How much memory is left, asked before much of it is taken.
#pragma once

#include <cstdint>
#include <string_view>

namespace ikbench::cli {

// std::runtime_error where `bytes` are more than the process may take: by its own limit (ulimit -v), by that of its
// control group, or by what the machine has left. `what` needs them: "a report of 10 solves".
void expect_memory(std::int64_t bytes, std::string_view what);

}  // namespace ikbench::cli
