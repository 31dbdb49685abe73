// The memory that is left, for checks before much of it is taken.
#pragma once

#include <cstdint>
#include <filesystem>

namespace ikbench::cli {

// The bytes that this process may still take: by its own limit (ulimit -v), by those of its control groups (of versions
// 1 and 2; their cached files count as free, since the kernel takes them back), and by the machine's free memory. The
// largest number if nothing is known. /proc and /sys are read below `root`.
std::int64_t memory_left(const std::filesystem::path& root = "/");

}  // namespace ikbench::cli
