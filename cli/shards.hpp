// The shards of a study: their folders, their progress, and what is missing of them.
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

// Throws std::invalid_argument if the study has fewer parts than shards; `option` asked for them.
void refuse_empty_shards(const experiments::Study& study, const std::string& option, int count);

// The stores that a place means: a file itself; a folder's store.sqlite; or, if it has none, those of the folders in
// it, by name. Throws std::invalid_argument if there is none, or if a folder cannot be read.
std::vector<std::filesystem::path> stores_in(const std::filesystem::path& place);

// The solves that the store lacks of a study, in sentences; none if it is complete. Adds the commands that solve them,
// if sessions of the study with as many runs have recorded theirs.
std::vector<std::string> missing_parts(const results::Store& store, const results::StudyEntry& study);

std::int64_t solves_missing(const results::Store& store, const results::StudyEntry& study);

struct ShardState {
  experiments::Shard shard = {};
  std::int64_t stored = 0, total = 0;  // solves of all studies
  bool is_running = false;             // a process writes to its store
  double rate = 0;                     // solves per second, if it is running
  std::string trouble = {};            // a sentence: why its solves are wrong or unknown
};

// The shards of one N, in the order of I. The shard with most runs defines the work.
struct Division {
  int count = 1;
  std::vector<ShardState> shards = {};
  std::int64_t total = 0;  // of all N shards, also those that have not begun

  std::int64_t stored() const;
};

// The divisions in FOLDER/shards/I-of-N, the one with most solves first. Throws std::invalid_argument if they cannot be
// read.
std::vector<Division> divisions(const std::filesystem::path& folder);

}  // namespace ikbench::cli
