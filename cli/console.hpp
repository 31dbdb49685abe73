// The terminal: progress with time left, Ctrl-C, and text from anywhere made harmless.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "experiments/runner.hpp"

namespace ikbench::cli {

// Text from anywhere as valid UTF-8 whose control characters are escapes or blanks, so that no name moves a cursor,
// colours a terminal or turns its writing round; newlines stay.
std::string printable(std::string_view text);

// A line on standard error, printable, after all that standard output was given before; that nobody can read it is no
// failure.
void say(std::string_view text);

// A program and its arguments as a shell would take them again.
std::string shell_command(std::string_view program, const std::vector<std::string>& arguments);

// Columns padded to their widest cell; the first row is the head.
std::string aligned(const std::vector<std::vector<std::string>>& rows);

// While it lives, a thread waits for SIGINT, SIGTERM and SIGHUP (where the caller has not said nohup), which therefore
// may do what a program may. They end the program with a sentence and 128 + the number of the signal, wherever it is,
// and no scratch folder stays; the two classes below change that. Made once, before any other thread.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

 private:
  std::thread thread_;
};

// While it lives, a first signal sets a flag and says so in these words; a second one ends the program.
class CancelOnSignal {
 public:
  explicit CancelOnSignal(std::string_view words = "Stopping after the current solve.");
  ~CancelOnSignal();
  CancelOnSignal(const CancelOnSignal&) = delete;
  CancelOnSignal& operator=(const CancelOnSignal&) = delete;

  const std::atomic<bool>& requested() const;
  // From here on a signal ends the program; says whether one came before, which has been answered and is to be obeyed.
  [[nodiscard]] bool end();
};

// Of a program that a signal has cancelled: 128 + its number.
int cancelled_exit_code();

// While it lives, a signal ends the program with these words.
class EndOnSignal {
 public:
  explicit EndOnSignal(std::string_view words);
  ~EndOnSignal();
  EndOnSignal(const EndOnSignal&) = delete;
  EndOnSignal& operator=(const EndOnSignal&) = delete;
};

// What to write of a progress, and when: on a terminal a bar that moves, in a log a line now and then.
class ProgressText {
 public:
  using Clock = std::chrono::steady_clock;
  enum class Medium { terminal, log };

  ProgressText(std::string title, Medium medium, Clock::time_point started);
  std::string at(Clock::time_point now,
                 const experiments::Progress& progress);  // empty where it is too soon after the last

 private:
  std::string title_;
  Medium medium_;
  Clock::time_point started_;
  Clock::time_point next_;
};

// The progress on standard error, with rate and time left; on a terminal it is wiped at the end.
class ProgressBar {
 public:
  explicit ProgressBar(std::string title);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  void show(const experiments::Progress& progress);

 private:
  bool on_terminal_;
  ProgressText text_;
};

// On a terminal a line that says what the program does, wiped at the end.
class Waiting {
 public:
  explicit Waiting(std::string_view words);
  ~Waiting();
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;
  void end();

 private:
  bool on_terminal_;
};

// out/<name>, the name with everything but letters, digits, '-', '_' and '.' replaced.
std::filesystem::path default_folder(std::string_view study);

}  // namespace ikbench::cli
