// A child process that speaks in lines. It has its own process group and none of our descriptors, and it ends when our
// process ends, for whatever reason.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ikbench::experiments {

using Clock = std::chrono::steady_clock;

// The program to start (found as a shell finds it), its arguments, and its working folder (empty: the current one). It
// gets our environment with LC_ALL=C and OMP_NUM_THREADS=1.
struct Command {
  std::vector<std::string> words;
  std::filesystem::path folder;
};

class ChildProcess {
 public:
  static constexpr std::size_t longest_line = 1'000'000;  // bytes

  // Throws std::invalid_argument if it cannot be started.
  explicit ChildProcess(const Command& command);
  ~ChildProcess() { end(std::chrono::milliseconds(0)); }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // Both wait until the deadline and meanwhile read what the program writes to standard error.
  enum class Outcome { done, ended, too_late, too_long };
  Outcome write(std::string_view text, Clock::time_point deadline);
  Outcome read_line(std::string& line, Clock::time_point deadline);
  bool has_line();  // true if a line can be read without waiting

  bool is_running();
  double cpu_seconds() const;                                      // of all its threads; NaN if unknown
  const std::string& last_errors() const { return last_errors_; }  // the end of its standard error
  std::string how_it_ended() const;                                // "exit code 3", "signal 11"; empty while it runs
  // Closes its standard input, waits for `patience`, then ends its whole group: first gently, after a second by force.
  void end(std::chrono::milliseconds patience);

 private:
  enum class Wait { to_read, to_write };
  // Waits until it can write or has read something. False at the deadline.
  bool wait(Wait purpose, Clock::time_point deadline);
  void drain_output();
  void drain_errors();
  bool ends_within(std::chrono::milliseconds patience);

  pid_t guard_ = -1;  // leads the group, and ends it when our process is gone
  pid_t process_ = -1;
  int lifeline_ = -1;  // open as long as our process lives
  int input_ = -1, output_ = -1, errors_ = -1;
  int status_ = 0;  // as waitpid gives it
  bool has_ended_ = false;
  std::string read_;  // output not taken yet, after `taken_` bytes
  std::size_t taken_ = 0;
  std::string last_errors_;
};

}  // namespace ikbench::experiments
