// Several stores put together into one, as if one machine had solved everything.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "results/store.hpp"

namespace ikbench::results {

struct Merged {
  std::int64_t added = 0;
  std::int64_t known = 0;                 // were there already, with the same bits
  std::vector<std::string> half_written;  // a sentence for each store that a kill left so: what it has is not merged
};

// A merge that was to stop, which has added nothing.
struct MergeCancelled {};

// Adds what `stores` have to the store `out`, which is made where it is missing: studies, solves and sessions, whose
// numbers change where they are taken. A session that `out` has already is the same one: so merging again changes
// nothing. Solves are copied as they are: who reads them finds what is damaged in them. All or nothing: a merge that
// fails or is killed has added nothing (what is half-written goes when the store is opened to be written again), and
// what another merge has made stays. A store that becomes half-written or is replaced while it is copied ends it.
// std::invalid_argument where sessions or studies were changed since they were written (digest.hpp), where two stores
// have another study of one name, or other bits of one solve (columns of the fingerprint), where no store can be read,
// and as store.hpp says. MergeCancelled soon after `cancelled` is set, unless all is merged by then.
Merged merge(const std::filesystem::path& out, const std::vector<std::filesystem::path>& stores,
             const std::atomic<bool>* cancelled = nullptr);

}  // namespace ikbench::results
