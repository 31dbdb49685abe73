// Where the shards of a study are, how far they are, and what is missing of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/shard.hpp"
#include "results/store.hpp"

namespace ikbench::cli {

// FOLDER/shards/I-of-N.
std::filesystem::path shard_folder(const std::filesystem::path& folder, experiments::Shard shard);

// The stores that are meant: a file is itself, a folder its store.sqlite, or without one those of the folders in it, in
// the order of their names. std::invalid_argument where there is none.
std::vector<std::filesystem::path> stores_in(const std::filesystem::path& place);

// What the store lacks of a study, in sentences with the commands that solve it; none where it lacks nothing.
std::vector<std::string> missing_parts(const results::Store& store, const results::StudyEntry& study,
                                       const std::filesystem::path& out);

struct ShardState {
  experiments::Shard shard;
  std::int64_t stored = 0, total = 0;  // solves of all studies in its store
  bool is_open = false;                // another program has the store open
  double rate = 0;                     // solves per second of the last session, where it is open
};

// Those in FOLDER/shards/I-of-N, in the order of N and I. std::invalid_argument where there is none.
std::vector<ShardState> shard_states(const std::filesystem::path& folder);

}  // namespace ikbench::cli
