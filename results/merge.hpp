// Merges several stores into one, as if one machine had solved everything. `ikbench merge` calls it for the stores of
// the shards of a cluster.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "results/store.hpp"

namespace ikbench::results {

// Returns the first field in which two definitions (JSON, as the store has them) ask for different solves, with both
// values: "seed is 1 and 2". Empty if there is none. The numbers of runs may differ.
std::string difference_in_solves(const std::string& first, const std::string& second);

// Returns how much is missing, such as "lacks 21 of 90 solves"; empty if the study is complete.
std::string missing_solves_text(const Store& store, const StoredStudy& study);

struct MergeResult {
  std::int64_t stores = 0;  // stores that were read, without empty ones and `out`
  std::int64_t added = 0;
  std::int64_t duplicates = 0;          // solves that were there already, with the same bits
  std::vector<std::string> incomplete;  // sentences on studies that are not complete
  std::vector<std::string> skipped;     // reasons: stores that cannot be read; solves that no study of their store has
};

// Makes the check of a study's solves. The check throws std::invalid_argument for a solve that cannot be right.
using MakeCheck = std::function<SolveVisitor(const StoredStudy&)>;
// Receives how many of all stores were read.
using MergeProgress = std::function<void(std::int64_t done, std::int64_t all)>;

// Adds studies, solves and sessions of `stores` to the store `out`, which is created if missing. Sessions get new
// numbers. A session without new solves is left out, so merging again changes nothing. A store that a kill left
// half-written is mended first; an empty store, of a shard that was killed at once, is left out.
// A store that cannot be read, or with a solve that the check refuses, is left out, unless it is `out` or no other
// remains. Solves that no study of their store has, such as those of former keys, are left out, since nothing says what
// they should be.
// Each store is added in one transaction. A merge that fails or is killed keeps the stores that it has added, and can
// be repeated. Throws std::invalid_argument if two stores have different studies of one name, or different bits of one
// solve (columns of the fingerprint and all_answers_rad), and as store.hpp says.
MergeResult merge(const std::filesystem::path& out, std::vector<std::filesystem::path> stores,
                  const MakeCheck& check_of, const MergeProgress& progress = {});

}  // namespace ikbench::results
