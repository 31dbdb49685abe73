// Another program, run without a shell: an external solver, a check, gnuplot. It has its own process group and no
// descriptors of ours but those that it is given. It ends when our process ends, for whatever reason. All that it
// started ends with it, on Linux even what left its group.
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

// The error for a program that gives no answer. `why` is a sentence about "it".
struct ProcessFailure {
  enum class Kind { crashed, timed_out, protocol_error, declined } kind;
  std::string why;
};

// A program that runs, and its standard input, output and error.
class ChildProcess {
 public:
  static constexpr std::size_t max_line_bytes = 1'000'000;  // bytes

  // Starts the program `words[0]`, found as a shell finds it, with the other words as arguments, in a folder (empty:
  // the current one). The program gets our environment with these variables, "LC_ALL=C", and the `inherited`
  // descriptors of ours as 3, 4, ..., which must be larger than those numbers. Throws std::invalid_argument if it
  // cannot be started.
  ChildProcess(std::vector<std::string> words, const std::filesystem::path& folder, std::vector<std::string> variables,
               const std::vector<int>& inherited = {});
  // Runs a program to its end, for at most a minute. It has no input.
  struct Ran {
    bool succeeded = false;
    std::string output = {};  // both streams, or why the program did not run
  };
  static Ran run(const std::vector<std::string>& words, const std::filesystem::path& folder,
                 std::vector<std::string> variables);
  ~ChildProcess() { end(std::chrono::seconds(1)); }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // Write a text, or read a line without its end. Both throw ProcessFailure at the deadline, or when the program has
  // ended. Meanwhile they read the program's standard error, so that it never waits for us.
  void write(std::string_view text, Clock::time_point deadline);
  std::string read_line(Clock::time_point deadline);
  bool has_line();  // true if a line can be read without waiting
  void end_input() { close_one(input_); }

  bool is_running();
  double cpu_seconds() const;  // [s] of all threads of the program and of who works for it; 0: not known
  // Names another process that does the program's work, so that its processor time counts.
  void set_worker(pid_t process) { worker_ = process; }
  // Closes the program's standard input, waits for `timeout`, then ends it by force with all that it started.
  void end(std::chrono::milliseconds timeout);
  // Ends the program after a failure. Returns how it ended by itself and its last words: " (exit code 3); its last
  // words: x". If it ended by itself, this takes 0.1 s more, in which a signal to all processes of a job also reaches
  // ours.
  std::string end_after(ProcessFailure::Kind failure);

 private:
  static void close_one(int& descriptor);
  static void drain(int& from, std::string& into);
  // Waits until a text can be written (to `input`, if that is open) or something was read.
  void wait(int input, Clock::time_point deadline, const char* what);

  pid_t guard_ = -1;  // parent of the program; ends it when our process is gone, then ends as it did
  pid_t process_ = -1;
  pid_t worker_ = -1;  // -1: the program itself
  int lifeline_ = -1;  // open while our process lives
  int input_ = -1, output_ = -1, errors_ = -1;
  int status_ = 0;  // as waitpid gives it
  bool has_ended_ = false;
  std::string read_, wrote_;  // output that was not taken yet; the end of standard error
};

}  // namespace ikbench::base
