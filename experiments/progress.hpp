// How far a long piece of work is.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ikbench::experiments {

struct Progress {
  std::int64_t done = 0;  // solves, including those that the store already had
  std::int64_t total = 0;
  std::int64_t reused = 0;              // those of `done` that the store already had
  std::vector<std::string> notes = {};  // at the end: one sentence per program about more than its solves
};

}  // namespace ikbench::experiments
