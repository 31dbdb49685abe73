// Threads that work side by side, their progress, a watch for times when the process was suspended, and the queue
// through which records go to the store. The runner of studies, the multiverse and `ikbench verify` use them. The watch
// costs a thread that wakes every 50 ms.
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
  std::vector<std::string> anomalies = {};  // at the end: a sentence per program or class that has some
};

// A function that returns true if a worker must stop, because another one threw or the user cancelled.
using StopRequested = std::function<bool()>;
// Calls work(index, worker, is_over) for each index below `count`, in ascending order, by the workers 0 to jobs - 1,
// each a thread. A single job runs in this thread. Returns when all workers have ended, and rethrows an exception of
// one.
void parallel_for(std::size_t count, int jobs, const std::atomic<bool>* cancelled,
                  const std::function<void(std::size_t index, std::size_t worker, const StopRequested& is_over)>& work);

// A watch that measures how long the process was suspended: by SIGSTOP, in a frozen container, on a sleeping machine.
// No signal announces a suspension, so a thread polls the clock and counts gaps above 0.2 s.
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

// A queue that passes records on, from one thread at a time, at least `flush_interval` after the last time. Records
// that come meanwhile wait and are passed on together, so that no worker waits for another. After a failure the queue
// passes nothing on.
class RecordQueue {
 public:
  using Clock = std::chrono::steady_clock;
  using Consumer = std::function<void(std::vector<results::SolveRecord>&)>;  // may move the records away

  explicit RecordQueue(Consumer pass_on, Clock::duration flush_interval = {})
      : pass_on_(std::move(pass_on)), flush_interval_(flush_interval) {}
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
