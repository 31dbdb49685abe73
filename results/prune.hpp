// Removes studies and forgotten solves from a store.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "results/store.hpp"

namespace ikbench::results {

// Counts what no study of a store uses: solves of earlier settings or sources, sessions without a solve.
struct Unused {
  std::int64_t solves = 0;
  std::int64_t sessions = 0;
};
Unused unused_in(const std::filesystem::path& store);

// Removes `study`, unless the name is empty, and then everything unused; returns how much. Solves that another study
// uses too stay. All or nothing, also where the process is killed. Throws std::invalid_argument if there is no such
// study, if the store was changed since it was written (new digests would hide that), and as store.hpp says.
Unused prune(const std::filesystem::path& store, const std::string& study);

}  // namespace ikbench::results
