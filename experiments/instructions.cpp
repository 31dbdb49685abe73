#include "experiments/instructions.hpp"

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <limits>

namespace ikbench::experiments {

namespace {

// The counter of a thread, open until the thread ends.
class Counter {
 public:
  Counter() {
    perf_event_attr what{};
    what.size = sizeof what;
    what.type = PERF_TYPE_HARDWARE;
    what.config = PERF_COUNT_HW_INSTRUCTIONS;
    what.exclude_kernel = what.exclude_hv = 1;
    what.read_format = PERF_FORMAT_TOTAL_TIME_ENABLED | PERF_FORMAT_TOTAL_TIME_RUNNING;
    constexpr int this_thread = 0, any_processor = -1, no_group = -1;
    file_ = static_cast<int>(
        syscall(SYS_perf_event_open, &what, this_thread, any_processor, no_group, PERF_FLAG_FD_CLOEXEC));
  }
  ~Counter() {
    if (file_ >= 0) ::close(file_);
  }
  Counter(const Counter&) = delete;
  Counter& operator=(const Counter&) = delete;

  double value() const {
    std::array<std::uint64_t, 3> told{};  // count, nanoseconds enabled, nanoseconds counting
    const bool is_told = file_ >= 0 && ::read(file_, told.data(), sizeof told) == sizeof told;
    const bool is_whole = is_told && told[1] == told[2];
    return is_whole ? static_cast<double>(told[0]) : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  int file_ = -1;
};

}  // namespace

double thread_instructions() {
  thread_local const Counter counter;
  return counter.value();
}

}  // namespace ikbench::experiments
