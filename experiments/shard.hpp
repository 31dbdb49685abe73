// A share of a study's solves, so that several machines solve it side by side.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/study.hpp"
#include "results/store.hpp"

namespace ikbench::experiments {

// What a study has to solve. Its parts are its runs; where no solve starts from the answer before it, the single
// targets of every run. A part is solved by all solvers, so that they are compared on one machine.
struct StudySize {
  int runs = 1;
  int points = 1;  // of a run
  int solvers = 1;
  bool is_chained = true;  // a solve starts from the answer before it
};

StudySize size_of(const Study& study);
StudySize size_of(const results::StudyEntry& study);  // of a store; what was imported is nobody's work here

// Shard I of N has the parts I, I + N, I + 2N, ...: more runs leave each part where it is.
struct Shard {
  int index = 1;  // I, from 1
  int count = 1;  // N

  std::string text() const;  // "I/N"
};

constexpr int most_shards = 100'000;

// "I/N"; else std::invalid_argument.
Shard shard_from(std::string_view text);

bool contains(Shard shard, const StudySize& size, int run, int point);
bool has_any(Shard shard, const StudySize& size, int run);  // some point of the run
std::int64_t parts_of(const StudySize& size);
std::int64_t solves_of(Shard shard, const StudySize& size);  // by all solvers
// How many solves of each of N shards the store has, without those that were imported.
std::vector<std::int64_t> stored_by_shard(int count, const results::StudyEntry& study, const results::Store& store);

}  // namespace ikbench::experiments
