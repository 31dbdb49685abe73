// A program that runs beside this one and speaks lines: with an own process group, no descriptors of ours, and an end
// whenever ours comes, however that is.
#pragma once

#include <sys/types.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ikbench::experiments {

using Clock = std::chrono::steady_clock;

// What is started: a program, found as a shell would find it, its arguments, and the folder that it works in (empty:
// the current one). It gets our environment with LC_ALL=C and OMP_NUM_THREADS=1.
struct Command {
  std::vector<std::string> words;
  std::filesystem::path folder;
};

class ChildProcess {
 public:
  static constexpr std::size_t longest_line = 1'000'000;  // bytes

  // std::invalid_argument where it cannot be started.
  explicit ChildProcess(const Command& command);
  ~ChildProcess() { end(std::chrono::milliseconds(0)); }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // Both until the deadline. What the program writes to standard error is read meanwhile.
  enum class Outcome { done, ended, too_late, too_long };
  Outcome write(std::string_view text, Clock::time_point deadline);
  Outcome read_line(std::string& line, Clock::time_point deadline);
  bool has_line();  // that can be read without waiting

  bool is_running();
  double resident_bytes() const;                                   // of memory; 0 where nobody says
  double cpu_seconds() const;                                      // of all its threads; NaN where nobody says
  double waited_seconds() const;                                   // for a processor; NaN where nobody says
  const std::string& last_errors() const { return last_errors_; }  // the end of what it wrote to standard error
  std::string how_it_ended() const;                                // "exit code 3", "signal 11"; empty while it runs
  // Closes its standard input, waits so long, ends its whole group, first gently, and after a second by force.
  void end(std::chrono::milliseconds patience);

 private:
  struct Waiting {
    bool to_write;
  };
  // Waits until something can be written or was read. False at the deadline.
  bool wait(Waiting waiting, Clock::time_point deadline);
  void drain_output();
  void drain_errors();
  bool ends_within(std::chrono::milliseconds patience);

  pid_t guard_ = -1;  // leads the group, and ends it when this program is gone
  pid_t process_ = -1;
  int lifeline_ = -1;  // open as long as this program lives
  int input_ = -1, output_ = -1, errors_ = -1;
  int status_ = 0;  // as waitpid has it
  bool has_ended_ = false;
  std::string read_;       // and not taken yet
  std::size_t taken_ = 0;  // bytes of it
  std::string last_errors_;
};

}  // namespace ikbench::experiments
