// Threads that work side by side, and the queue where they hand in their records.
#pragma once

#include <functional>
#include <mutex>
#include <vector>

#include "results/record.hpp"

namespace ikbench::experiments {

// Calls `worker` in `jobs` threads and returns when all have ended; one job runs in this thread. Rethrows what a worker
// throws.
void work_together(int jobs, const std::function<void()>& worker);

// Passes records on, one thread at a time. Records handed in meanwhile wait, and the busy thread passes them on next,
// all at once, so that no worker waits for another. After a failure it passes nothing on.
class RecordQueue {
 public:
  using PassOn = std::function<void(std::vector<results::SolveRecord>)>;

  explicit RecordQueue(PassOn pass_on) : pass_on_(std::move(pass_on)) {}
  void hand_in(results::SolveRecord record);

 private:
  PassOn pass_on_;
  std::mutex mutex_;
  bool is_busy_ = false;
  std::vector<results::SolveRecord> waiting_;
};

}  // namespace ikbench::experiments
