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

void RecordQueue::hand_in(SolveRecord record) {
  std::unique_lock lock(mutex_);
  waiting_.push_back(std::move(record));
  if (is_busy_) return;
  is_busy_ = true;
  while (!waiting_.empty()) {
    std::vector<SolveRecord> records = std::exchange(waiting_, {});
    lock.unlock();
    pass_on_(std::move(records));
    lock.lock();
  }
  is_busy_ = false;
}

}  // namespace ikbench::experiments
