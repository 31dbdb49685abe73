// Merges several stores into one, as if one machine had solved everything.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "results/store.hpp"

namespace ikbench::results {

// The first field in which two definitions (JSON, as the store has them) ask for different solves, with both values:
// "seed is 1 and 2"; empty if there is none. The number of runs may differ.
std::string difference_in_solves(const std::string& definition, const std::string& other);

// "lacks 21 of 90 solves"; empty if the study is complete.
std::string lack_of(const Store& store, const StoredStudy& study);

struct Merged {
  std::int64_t stores = 0;  // that were read: not empty, and not the one that gets all
  std::int64_t added = 0;
  std::int64_t known = 0;             // there already, with the same bits
  std::vector<std::string> lacks;     // of the studies that are not complete
  std::vector<std::string> left_out;  // why, of stores that no reader takes; solves that no study of their store has
};

// Makes the check of a study's solves.
using CheckOf = std::function<TakeSolve(const StoredStudy&)>;
// Told how many of all stores are read.
using MergeProgress = std::function<void(std::int64_t done, std::int64_t all)>;

// Adds studies, solves and sessions of `stores` to the store `out`, which is created if missing. Sessions get new
// numbers; those of which no solve is new are left out, so merging again changes nothing. A store that a kill left
// half-written is mended first; one that is empty, of a shard that was killed at once, is left out.
// A store with a solve that the check refuses, or that cannot be read, is left out, unless it is `out` or none remains.
// Solves that no study of their store has, as those of former keys, are left out: nothing says what they should be.
// Of a store all else is added, or nothing; a merge that fails or is killed has added those before, and may be given
// again. Throws std::invalid_argument if two stores have different studies of one name or different bits of one solve
// (columns of the fingerprint), and as store.hpp says.
Merged merge(const std::filesystem::path& out, std::vector<std::filesystem::path> stores, const CheckOf& check_of,
             const MergeProgress& progress = {});

}  // namespace ikbench::results
