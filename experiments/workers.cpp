#include "experiments/workers.hpp"

#include <future>
#include <utility>

namespace ikbench::experiments {

void parallel_for(std::size_t count, int jobs, const std::atomic<bool>* cancelled,
                  const std::function<void(std::size_t, std::size_t, const StopRequested&)>& work) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> has_failed{false};
  const StopRequested is_over = [&] { return has_failed || (cancelled != nullptr && *cancelled); };
  const auto work_as = [&](std::size_t worker) {
    try {
      for (std::size_t i = next++; i < count && !is_over(); i = next++) work(i, worker, is_over);
    } catch (...) {
      has_failed = true;
      throw;
    }
  };
  if (jobs == 1) return work_as(0);
  std::vector<std::future<void>> workers;  // the destructor of each waits for its end
  for (int i = 0; i < jobs; ++i)
    workers.push_back(std::async(std::launch::async, work_as, static_cast<std::size_t>(i)));
  for (std::future<void>& worker : workers) worker.get();
}

SuspensionWatch::SuspensionWatch()
    : thread_([this] {
        std::unique_lock lock(mutex_);
        while (!end_.wait_for(lock, std::chrono::milliseconds(50), [this] { return is_over_; })) look();
      }) {}

SuspensionWatch::~SuspensionWatch() {
  {
    const std::scoped_lock lock(mutex_);
    is_over_ = true;
  }
  end_.notify_one();
  thread_.join();
}

SuspensionWatch::Clock::duration SuspensionWatch::suspended() {
  const std::scoped_lock lock(mutex_);
  return look();
}

SuspensionWatch::Clock::duration SuspensionWatch::look() {
  const Clock::time_point now = Clock::now();
  if (const Clock::duration gap = now - last_; gap > std::chrono::milliseconds(200)) suspended_ += gap;
  last_ = now;
  return suspended_;
}

void RecordQueue::push(results::SolveRecord&& record) {
  std::unique_lock lock(mutex_);
  waiting_.push_back(std::move(record));
  while (!is_busy_ && !waiting_.empty() && Clock::now() - last_ >= flush_interval_) pass_on(lock);
}

void RecordQueue::flush() {
  std::unique_lock lock(mutex_);
  if (!is_busy_ && !waiting_.empty()) pass_on(lock);
}

void RecordQueue::pass_on(std::unique_lock<std::mutex>& lock) {
  is_busy_ = true;
  passed_.swap(waiting_);
  lock.unlock();
  pass_on_(passed_);
  passed_.clear();  // clear() keeps its memory
  lock.lock();
  last_ = Clock::now();
  is_busy_ = false;
}

}  // namespace ikbench::experiments
