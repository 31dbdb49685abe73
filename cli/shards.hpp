// Where the shards of a study are, how far they are, and what is missing of them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "experiments/shard.hpp"
#include "results/store.hpp"

namespace ikbench::cli {

// FOLDER/shards/I-of-N.
std::filesystem::path shard_folder(const std::filesystem::path& folder, experiments::Shard shard);

// std::invalid_argument where so many shards are more than the study has parts; `option` asked for them.
void refuse_empty_shards(const experiments::Study& study, const std::string& option, int count);

// The stores that are meant: a file is itself, a folder its store.sqlite, or without one those of the folders in it, in
// the order of their names. std::invalid_argument where there is none, or a folder cannot be read.
std::vector<std::filesystem::path> stores_in(const std::filesystem::path& place);

// What the store lacks of a study, in sentences; none where it lacks nothing. The commands that solve it are with them
// where sessions of the study, with as many runs, say how they were started.
std::vector<std::string> missing_parts(const results::Store& store, const results::StudyEntry& study);

struct ShardState {
  experiments::Shard shard = {};
  std::int64_t stored = 0, total = 0;  // solves of all studies
  bool is_running = false;             // somebody writes to its store
  double rate = 0;                     // solves per second, where it is running
  std::string trouble = {};            // in a sentence: why its solves are not those of the shard, or are not known
};

// The shards of one N, in the order of I. What they have to solve is what the one with most runs says.
struct Division {
  int count = 1;
  std::vector<ShardState> shards = {};
  std::int64_t total = 0;  // of all N, also of those that have not begun

  std::int64_t stored() const;
};

// Of FOLDER/shards/I-of-N, the one that has most solves first. std::invalid_argument where they cannot be read.
std::vector<Division> divisions(const std::filesystem::path& folder);

}  // namespace ikbench::cli
