// The terminal: width, progress with time left, Ctrl-C, and output of any text that cannot harm a terminal. Every
// command writes through these functions or through fmt::print with `printable`.
#pragma once

#include <atomic>
#include <boost/core/noncopyable.hpp>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "experiments/workers.hpp"

namespace ikbench::cli {

// Commands use the names of these rooms without a prefix.
using namespace base;
using namespace results;
using namespace experiments;

// Returns the text as valid UTF-8, with escapes or blanks for control characters. No name in the text can then move a
// cursor, colour a terminal or reverse the direction of writing. Newlines stay.
std::string printable(std::string_view text);

// Prints text, made printable and wrapped, on standard error after all earlier standard output. A failure to print is
// ignored.
void print_message(std::string_view text);
void warn(std::string_view text);         // prints "warning: " and the text
void print_error(std::string_view text);  // prints "ikbench: " and the text, which says what is wrong and what to do

// Prints a command on one unbroken line, ready to paste.
void print_command(std::string_view command);

// Returns the columns of the terminal, from 40 to 100; 100 if standard output is no terminal.
std::size_t terminal_width();
// Returns the text, made printable, with lines that break between words. Continuation lines are indented, and a word
// longer than a line stays whole.
std::string wrapped(std::string_view text, std::size_t width = terminal_width());

// Returns a program and its arguments as a command, quoted for a shell.
std::string shell_command(std::string_view program, const std::vector<std::string>& arguments);

using Rows = std::vector<std::vector<std::string>>;
// Returns rows as a table whose columns are padded to their widest cell; the first row is the head. If the rows are
// wider than `width`, the words of the widest columns are wrapped.
std::string align_columns(Rows rows, std::size_t width = terminal_width());

// A thread that waits for SIGINT, SIGTERM and SIGHUP (not under nohup) until this object is destroyed. Because a thread
// handles the signals, any function may be called then. A signal ends the program with a sentence and exit code 128 +
// number, after temporary folders are removed, unless there is a CancelOnSignal. A program makes one SignalWatch,
// before any other thread, because later threads inherit the blocked signals.
class SignalWatch : boost::noncopyable {
 public:
  SignalWatch();
  ~SignalWatch();

 private:
  std::thread thread_;
};

// A guard that lets a command end a signal's work in order: until this object is destroyed, a first signal sets
// `requested` and prints a message, and a second one ends the program. The guard needs a SignalWatch.
class CancelOnSignal : boost::noncopyable {
 public:
  CancelOnSignal();
  ~CancelOnSignal();

  const std::atomic<bool>& requested() const;
  // Lets the next signal end the program. Returns true if a signal came before: a message has announced that the
  // command stops, so the command must stop.
  [[nodiscard]] bool end();
};

// The exception that a cancelled command throws, after the command has printed what is kept.
struct Cancelled {};
// Returns the exit code of a cancelled program: 128 + the number of the signal.
int cancelled_exit_code();

// A display of progress on standard error, with rate and time left. A terminal shows a moving bar, which the destructor
// wipes. A log gets a line every 30 s.
class ProgressBar : boost::noncopyable {
 public:
  using Clock = std::chrono::steady_clock;

  explicit ProgressBar(std::string title, std::string noun = "solves");
  ProgressBar(std::string title, std::string noun, bool on_terminal, Clock::time_point started);
  ~ProgressBar();
  void show(const experiments::Progress& progress);
  // Returns the text to show at this time; empty if the last text was shown too recently.
  std::string text_at(Clock::time_point now, const experiments::Progress& progress);

 private:
  std::string title_, noun_;
  bool on_terminal_;
  Clock::time_point started_, next_;
};

// Returns `out`, or out/NAME if `out` is empty. NAME is the study's name, in which '_' replaces each ASCII character
// that is not a letter, a digit, '-', '_' or '.'.
std::filesystem::path output_folder(std::string_view study, const std::string& out);

}  // namespace ikbench::cli
