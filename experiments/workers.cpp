#include "experiments/workers.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <utility>

namespace ikbench::experiments {

using namespace results;

namespace {

// Every worker passes this mutex at its start and end. Debian's oneTBB is built without the thread sanitizer, which
// therefore does not see how work is handed over and taken back; it sees this mutex.
class Door {
 public:
  Door() { pass(); }
  ~Door() { pass(); }
  Door(const Door&) = delete;
  Door& operator=(const Door&) = delete;

 private:
  static void pass() {
    static std::mutex mutex;
    const std::scoped_lock lock(mutex);
  }
};

}  // namespace

void work_together(int jobs, const std::function<void()>& worker) {
  if (jobs == 1) return worker();
  const auto work = [&](int) {
    const Door door;
    worker();
  };
  const Door door;
  // Without this, oneTBB has no more threads than processors, whatever is asked for.
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(jobs));
  tbb::task_arena(jobs).execute([&] { tbb::parallel_for(0, jobs, work); });
}

void RecordQueue::hand_in(SolveRecord&& record) {
  std::unique_lock lock(mutex_);
  waiting_.push_back(std::move(record));
  while (!is_busy_ && !waiting_.empty() && Clock::now() - last_ >= patience_) pass_on(lock);
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
  passed_.clear();  // and keeps its memory
  lock.lock();
  last_ = Clock::now();
  is_busy_ = false;
}

}  // namespace ikbench::experiments
