// Threads that work side by side, their progress, a watch for times when the process stood still, and the queue through
// which records go to the store.
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

// The progress of a run.
struct Progress {
  std::int64_t done = 0;  // solves, including those that the store already had
  std::int64_t total = 0;
  std::int64_t reused = 0;                  // solves of `done` that the store already had
  std::vector<std::string> anomalies = {};  // at the end: one sentence per odd program or class
};

// Returns true if a worker has to stop, because another one threw or the user cancelled.
using StopRequested = std::function<bool()>;
// Calls work(index, worker, is_over) for each index below `count`, in ascending order, by the workers 0 to jobs - 1,
// each a thread. One job runs in this thread. Returns when all have ended, and rethrows an exception of one.
void parallel_for(std::size_t count, int jobs, const std::atomic<bool>* cancelled,
                  const std::function<void(std::size_t index, std::size_t worker, const StopRequested& is_over)>& work);

// Measures how long the whole process was suspended while the clock went on: by SIGSTOP, in a frozen container, on a
// sleeping machine. No signal announces that, so a thread looks at the clock often and counts the time that it missed.
class SuspensionWatch {
 public:
  using Clock = std::chrono::steady_clock;

  SuspensionWatch();
  ~SuspensionWatch();
  SuspensionWatch(const SuspensionWatch&) = delete;
  SuspensionWatch& operator=(const SuspensionWatch&) = delete;

  Clock::duration suspended();  // so far, in pauses of more than 0.2 s

 private:
  Clock::duration look();

  std::mutex mutex_;
  std::condition_variable end_;
  bool is_over_ = false;
  Clock::time_point last_ = Clock::now();
  Clock::duration suspended_{0};
  std::thread thread_;
};

// Passes records on, from one thread at a time, at least `patience` after the last time. Records that come meanwhile
// wait and are passed on all at once, so that no worker waits for another. After a failure the queue passes nothing on.
class RecordQueue {
 public:
  using Clock = std::chrono::steady_clock;
  using Consumer = std::function<void(std::vector<results::SolveRecord>&)>;  // the records are its own

  explicit RecordQueue(Consumer pass_on, Clock::duration patience = {})
      : pass_on_(std::move(pass_on)), flush_interval_(patience) {}
  void push(results::SolveRecord&& record);
  void flush();  // passes on what waits

 private:
  void pass_on(std::unique_lock<std::mutex>& lock);

  Consumer pass_on_;
  Clock::duration flush_interval_;
  Clock::time_point last_ = Clock::now();
  std::mutex mutex_;
  bool is_busy_ = false;
  std::vector<results::SolveRecord> waiting_, passed_;
};

}  // namespace ikbench::experiments
