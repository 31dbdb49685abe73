// A share of a study's solves, so that several machines can solve it side by side.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ikbench::experiments {

struct Study;

// The parts of a study are its runs, or, if no solve starts from the previous answer, the single targets of every run.
// All solvers solve a part on one machine, so that they can be compared. Shard I of N has the parts I, I + N, I + 2N,
// ...: more runs leave each part where it is.
struct Shard {
  int index = 1;  // I, from 1
  int count = 1;  // N

  std::string text() const;  // "I/N"
};

// Reads "I/N"; throws std::invalid_argument for anything else.
Shard shard_from(std::string_view text);

bool contains(Shard shard, const Study& study, int run, int point);
bool has_any(Shard shard, const Study& study, int run);  // true if the shard has a point of the run
std::int64_t parts_of(const Study& study);
std::int64_t solves_of(Shard shard, const Study& study);  // by all solvers

}  // namespace ikbench::experiments
