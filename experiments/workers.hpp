// Threads that work side by side, and the record_queue where they hand in what they made.
#pragma once

#include <functional>
#include <mutex>
#include <vector>

#include "results/record.hpp"

namespace ikbench::experiments {

// Calls `worker` `jobs` times, side by side, and returns when all have ended; one job is this thread's own. What a
// worker throws is thrown here.
void work_together(int jobs, const std::function<void()>& worker);

// Passes records on, one thread at a time. What is handed in meanwhile waits and is passed on next, all at once, by the
// thread that is at it, so that no worker ever waits for another's. Once passing on has failed it is not tried again.
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
