// A share of a study's solves, so that several machines can solve it side by side.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ikbench::experiments {

struct Study;

// The size of a study's work. Its parts are its runs, or, if no solve starts from the previous answer, the single
// targets of every run. All solvers solve a part on one machine, so that they can be compared.
struct StudySize {
  int runs = 1;
  int points = 1;  // per run
  int solvers = 1;
  bool is_chained = true;  // each solve starts from the previous answer
};

StudySize size_of(const Study& study);

// Shard I of N has the parts I, I + N, I + 2N, ...: more runs leave each part where it is.
struct Shard {
  int index = 1;  // I, from 1
  int count = 1;  // N

  std::string text() const;  // "I/N"
};

// Reads "I/N"; throws std::invalid_argument for anything else.
Shard shard_from(std::string_view text);

bool contains(Shard shard, const StudySize& size, int run, int point);
bool has_any(Shard shard, const StudySize& size, int run);  // true if the shard has a point of the run
std::int64_t parts_of(const StudySize& size);
std::int64_t solves_of(Shard shard, const StudySize& size);  // by all solvers

}  // namespace ikbench::experiments
