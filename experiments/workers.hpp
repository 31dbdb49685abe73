// Threads that work side by side, how far they are, how long they stood still, and the queue where they hand in their
// records.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "results/record.hpp"

namespace ikbench::experiments {

struct Progress {
  std::int64_t done = 0;  // solves, including those that the store already had
  std::int64_t total = 0;
  std::int64_t reused = 0;              // those of `done` that the store already had
  std::vector<std::string> notes = {};  // at the end: one sentence per odd program or class
};

// True if a worker has to stop: another one threw, or the user cancelled.
using IsOver = std::function<bool()>;
// Calls work(index, worker, is_over) for each index below `count`, in their order, by the workers 0 to jobs - 1, each a
// thread; one job runs in this thread. Returns when all have ended, and rethrows what one throws.
void share_out(std::size_t count, int jobs, const std::atomic<bool>* cancelled,
               const std::function<void(std::size_t index, std::size_t worker, const IsOver& is_over)>& work);

// Adds up how long the whole process stood still while the clock went on: stopped by SIGSTOP, in a frozen container, on
// a machine that was halted. Nobody tells it so; a thread of this class looks at the clock often, and misses its time.
class PauseWatch {
 public:
  using Clock = std::chrono::steady_clock;

  PauseWatch();
  ~PauseWatch();
  PauseWatch(const PauseWatch&) = delete;
  PauseWatch& operator=(const PauseWatch&) = delete;

  Clock::duration paused();  // so far, in pauses of more than 0.2 s

 private:
  Clock::duration look();

  std::mutex mutex_;
  std::condition_variable end_;
  bool is_over_ = false;
  Clock::time_point last_ = Clock::now();
  Clock::duration paused_{0};
  std::thread thread_;
};

// Passes records on, one thread at a time, `patience` after the last time or later. Records handed in meanwhile wait
// and are passed on all at once, so that no worker waits for another. After a failure it passes nothing on.
class RecordQueue {
 public:
  using Clock = std::chrono::steady_clock;
  using PassOn = std::function<void(std::vector<results::SolveRecord>&)>;  // the records are its own

  explicit RecordQueue(PassOn pass_on, Clock::duration patience = {})
      : pass_on_(std::move(pass_on)), patience_(patience) {}
  void hand_in(results::SolveRecord&& record);
  void flush();  // passes on what waits

 private:
  void pass_on(std::unique_lock<std::mutex>& lock);

  PassOn pass_on_;
  Clock::duration patience_;
  Clock::time_point last_ = Clock::now();
  std::mutex mutex_;
  bool is_busy_ = false;
  std::vector<results::SolveRecord> waiting_, passed_;
};

}  // namespace ikbench::experiments
