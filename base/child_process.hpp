// Another program, run without a shell. It has its own process group and none of our descriptors. It ends when our
// process ends, for whatever reason, and what it started ends with it, on Linux also what left its group.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ikbench::base {

using Clock = std::chrono::steady_clock;

// The reason why a program gives no answer; `why` is a sentence about "it".
struct Trouble {
  enum class Kind { crashed, timed_out, broke_protocol, declined } kind;
  std::string why;
};

class ChildProcess {
 public:
  static constexpr std::size_t longest_line = 1'000'000;  // bytes

  // Starts a program, found as a shell finds it, with its arguments in a folder (empty: the current one). It gets our
  // environment with these variables, "LC_ALL=C". Throws std::invalid_argument if it cannot be started.
  ChildProcess(std::vector<std::string> words, const std::filesystem::path& folder, std::vector<std::string> variables);
  // Runs a program to its end, of at most a minute. It reads nothing.
  struct Ran {
    bool succeeded = false;
    std::string output = {};  // both streams; or why it did not run
  };
  static Ran run(const std::vector<std::string>& words, const std::filesystem::path& folder,
                 std::vector<std::string> variables);
  ~ChildProcess() { end(std::chrono::seconds(1)); }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // Both throw Trouble at the deadline and when it has ended, and meanwhile read its standard error.
  void write(std::string_view text, Clock::time_point deadline);
  std::string read_line(Clock::time_point deadline);
  bool has_line();  // one can be read without waiting
  void end_input() { close_one(input_); }

  bool is_running();
  double cpu_seconds() const;  // of all its threads; 0 if unknown
  // Closes its standard input, waits for `patience`, then ends it and all that it started by force.
  void end(std::chrono::milliseconds patience);
  // Ends it after a trouble; returns how it ended by itself and its last words, " (exit code 3); its last words: x". If
  // it ended by itself, takes 0.1 s more, in which a signal to all processes of a job reaches ours, too.
  std::string end_after(Trouble::Kind trouble);

 private:
  static void close_one(int& descriptor);
  static void drain(int& from, std::string& into);
  // Waits until it can write (to `input`, if that is open) or has read something.
  void wait(int input, Clock::time_point deadline, const char* what);

  pid_t guard_ = -1;  // its parent, which ends it when our process is gone, and then as it did
  pid_t process_ = -1;
  int lifeline_ = -1;  // open as long as our process lives
  int input_ = -1, output_ = -1, errors_ = -1;
  int status_ = 0;  // as waitpid gives it
  bool has_ended_ = false;
  std::string read_, wrote_;  // output that is not taken yet; the end of its standard error
};

}  // namespace ikbench::base
