// How much memory is left, asked before much of it is taken.
#pragma once

#include <cstdint>
#include <filesystem>

namespace ikbench::cli {

// The bytes that this process may still take: by its own limit (ulimit -v), by those of its control groups (of versions
// 1 and 2; what they have of files counts as free, because the kernel takes it back), and by what the machine has left.
// The largest number where nothing says. /proc and /sys are looked for in `root`.
std::int64_t memory_left(const std::filesystem::path& root = "/");

}  // namespace ikbench::cli
