// The terminal: its width, progress with time left, Ctrl-C, and harmless output of any text.
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

// What all commands speak of.
using namespace base;
using namespace results;
using namespace experiments;

// Makes any text valid UTF-8 with control characters as escapes or blanks, so that no name moves a cursor, colours a
// terminal or reverses its writing; newlines stay.
std::string printable(std::string_view text);

// Prints printable text on standard error, after all earlier standard output; a failure to print is ignored. Lines
// break between words.
void print_message(std::string_view text);
void warn(std::string_view text);         // says "warning: " and the text
void print_error(std::string_view text);  // says "ikbench: " and the text: what is wrong, and what to do

// Says a command in a line of its own that never breaks, to paste.
void print_command(std::string_view command);

// Columns of standard output: those of the terminal, but at most 100; 100 where it is no terminal.
std::size_t terminal_width();
// Printable text whose lines break between words; further lines are indented. Longer words stay whole.
std::string wrapped(std::string_view text, std::size_t width = terminal_width());

// A program and its arguments as a shell would take them again.
std::string shell_command(std::string_view program, const std::vector<std::string>& arguments);

using Rows = std::vector<std::vector<std::string>>;
// Pads columns to their widest cell; the first row is the head. If the rows are wider than `width`, the words of the
// widest columns are wrapped.
std::string align_columns(Rows rows, std::size_t width = terminal_width());

// While it lives, a thread waits for SIGINT, SIGTERM and SIGHUP (unless started by nohup), so their handling may use
// any function. They end the program with a sentence and 128 + the number of the signal, and remove scratch folders;
// CancelOnSignal changes that. Make it once, before any other thread.
class SignalWatch : boost::noncopyable {
 public:
  SignalWatch();
  ~SignalWatch();

 private:
  std::thread thread_;
};

// While it lives, a first signal sets a flag and says so; a second one ends the program.
class CancelOnSignal : boost::noncopyable {
 public:
  CancelOnSignal();
  ~CancelOnSignal();

  const std::atomic<bool>& requested() const;
  // Afterwards a signal ends the program. Returns true if one came before, which was announced and must be obeyed.
  [[nodiscard]] bool end();
};

// Thrown by what was cancelled, after it has said what is kept.
struct Cancelled {};
// The exit code of a cancelled program: 128 + the number of its signal.
int cancelled_exit_code();

// Shows a progress on standard error, with rate and time left: on a terminal as a moving bar, which is wiped at the
// end, in a log as a line now and then.
class ProgressBar : boost::noncopyable {
 public:
  using Clock = std::chrono::steady_clock;

  explicit ProgressBar(std::string title, std::string noun = "solves");
  ProgressBar(std::string title, std::string noun, bool on_terminal, Clock::time_point started);
  ~ProgressBar();
  void show(const experiments::Progress& progress);
  // What is to be shown; empty if it is too soon after the last text.
  std::string text_at(Clock::time_point now, const experiments::Progress& progress);

 private:
  std::string title_, noun_;
  bool on_terminal_;
  Clock::time_point started_, next_;
};

// `out`, or if it is empty out/<name>, where '_' replaces all of ASCII but letters, digits, '-', '_' and '.'.
std::filesystem::path output_folder(std::string_view study, const std::string& out);

}  // namespace ikbench::cli
