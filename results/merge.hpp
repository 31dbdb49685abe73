// Merges several stores into one, as if one machine had solved everything.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "results/store.hpp"

namespace ikbench::results {

struct Merged {
  std::int64_t added = 0;
  std::int64_t known = 0;                 // there already, with the same bits
  std::vector<std::string> half_written;  // a sentence for each store that a kill left half-written; it is not merged
};

// Thrown by a cancelled merge, which has added nothing.
struct MergeCancelled {};

// Told how many of all stores are read.
using MergeProgress = std::function<void(std::int64_t done, std::int64_t all)>;

// Adds studies, solves and sessions of `stores` to the store `out`, which is created if missing. Sessions get new
// numbers. A session that `out` has already is the same one, so merging again changes nothing. Solves are copied as
// they are.
// All or nothing: a merge that fails or is killed has added nothing (its half-written rest goes when the store is next
// opened for writing), and the work of another merge stays. A store that becomes half-written or is replaced during the
// copy ends the merge.
// Throws std::invalid_argument if two stores have different studies of one name or different bits of one solve (columns
// of the fingerprint), if no store can be read, and as store.hpp says. Throws MergeCancelled soon after `cancelled` is
// set, unless all is merged by then.
Merged merge(const std::filesystem::path& out, const std::vector<std::filesystem::path>& stores,
             const std::atomic<bool>* cancelled = nullptr, const MergeProgress& progress = {});

}  // namespace ikbench::results
