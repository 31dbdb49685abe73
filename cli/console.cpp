#include "cli/console.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <mutex>
#include <utility>

#include "analysis/show/text.hpp"
#include "base/files.hpp"
#include "base/names.hpp"

namespace ikbench::cli {

namespace {

// The state that the thread of SignalWatch reads and writes.
std::atomic<bool> cancel_requested{false}, may_cancel{false}, is_over{false};
std::atomic<int> last_signal{0};
std::mutex answering;

sigset_t watched_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  struct sigaction hangup {};
  if (sigaction(SIGHUP, nullptr, &hangup) == 0 && hangup.sa_handler != SIG_IGN) sigaddset(&set, SIGHUP);
  return set;
}

// Writes without the C streams, because another thread may hold their locks.
void write_at_once(const std::string& text) { static_cast<void>(!write(STDERR_FILENO, text.data(), text.size())); }

void watch(const sigset_t& set) {
  for (int number = 0; sigwait(&set, &number) == 0 && !is_over;) {
    const std::scoped_lock lock(answering);
    last_signal = number;
    if (may_cancel && !cancel_requested.exchange(true)) {
      write_at_once("\nStopping after the current solve. Interrupt again to stop at once.\n");
      continue;
    }
    write_at_once(may_cancel ? "\nStopped. Stored solves are kept.\n" : "\nStopped.\n");
    base::remove_temporary_folders();
    _exit(128 + number);
  }
}

// Writes to standard error. Every text except that of `write_at_once` goes through this function, so that earlier
// standard output comes first if both streams go into one file.
void write_error(const std::string& text) {
  std::fflush(stdout);
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

constexpr std::size_t max_columns = 100, min_columns = 40;

// Returns the columns of the terminal behind a stream; max_columns if the stream is no terminal.
std::size_t columns_of(int stream) {
  winsize size{};
  if (isatty(stream) == 0 || ioctl(stream, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return max_columns;
  return std::clamp<std::size_t>(size.ws_col, min_columns, max_columns);
}

// Returns rate and time left; empty before anything is done.
std::string pace(const Progress& progress, double elapsed) {
  const std::int64_t solved = progress.done - progress.reused;
  if (solved <= 0 || elapsed <= 0) return "";
  const double rate = static_cast<double>(solved) / elapsed;
  const auto left = static_cast<std::int64_t>(static_cast<double>(progress.total - progress.done) / rate);
  return fmt::format(", {:.{}f}/s, {}:{:02} left", rate, rate < 10 ? 1 : 0, left / 60, left % 60);
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result, line;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\n') {
      result += one_line(line) + '\n';
      line.clear();
    } else if (byte < 0x20 || byte == 0x7f) {
      line += fmt::format("\\x{:02x}", byte);
    } else {
      line += c;
    }
  }
  return result + one_line(line);
}

void print_message(std::string_view text) { write_error(wrapped(text, columns_of(STDERR_FILENO)) + '\n'); }

void warn(std::string_view text) { print_message(fmt::format("warning: {}", text)); }

void print_error(std::string_view text) { print_message(fmt::format("ikbench: {}", text)); }

void print_command(std::string_view command) { write_error(fmt::format("    {}\n", printable(command))); }

std::size_t terminal_width() { return columns_of(STDOUT_FILENO); }

std::string wrapped(std::string_view text, std::size_t width) {
  constexpr std::size_t indent = 2;
  const std::string shown = printable(text);
  std::string result;
  for (std::size_t at = 0; at <= shown.size();) {
    const std::size_t end = std::min(shown.find('\n', at), shown.size());
    const std::vector<std::string> lines =
        show::wrap_words(std::string_view(shown).substr(at, end - at), width, width - indent);
    if (at > 0) result += '\n';
    result += fmt::format("{}", fmt::join(lines, '\n' + std::string(indent, ' ')));
    at = end + 1;
  }
  return result;
}

std::string shell_command(std::string_view program, const std::vector<std::string>& arguments) {
  constexpr std::string_view harmless = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=.,:/+@%";
  std::string text(program);
  for (const std::string& argument : arguments) {
    text += ' ';
    if (!argument.empty() && argument.find_first_not_of(harmless) == std::string::npos) {
      text += argument;
      continue;
    }
    text += '\'';
    for (const char c : argument) text += c == '\'' ? "'\\''" : std::string(1, c);
    text += '\'';
  }
  return text;
}

std::string align_columns(Rows rows, std::size_t width) {
  for (auto& row : rows)
    for (std::string& cell : row) cell = one_line(printable(cell));
  return show::align_columns(rows, 2, width);
}

SignalWatch::SignalWatch() {
  const sigset_t set = watched_signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);  // later threads inherit the mask
  std::signal(SIGXFSZ, SIG_IGN);              // beyond `ulimit -f` a write then fails, with a message
  std::signal(SIGCHLD, SIG_DFL);              // a parent may ignore SIGCHLD, which would lose exit codes
  thread_ = std::thread([set] { watch(set); });
}

SignalWatch::~SignalWatch() {
  is_over = true;
  pthread_kill(thread_.native_handle(), SIGTERM);
  thread_.join();
}

CancelOnSignal::CancelOnSignal() {
  cancel_requested = false;
  may_cancel = true;
}

CancelOnSignal::~CancelOnSignal() { may_cancel = false; }

bool CancelOnSignal::end() {
  const std::scoped_lock lock(answering);
  may_cancel = false;
  return cancel_requested;
}

const std::atomic<bool>& CancelOnSignal::requested() const { return cancel_requested; }

int cancelled_exit_code() { return 128 + last_signal; }

ProgressBar::ProgressBar(std::string title, std::string noun)
    : ProgressBar(std::move(title), std::move(noun), isatty(STDERR_FILENO) != 0, Clock::now()) {}

ProgressBar::ProgressBar(std::string title, std::string noun, bool on_terminal, Clock::time_point started)
    : title_(printable(title)), noun_(std::move(noun)), on_terminal_(on_terminal), started_(started), next_(started) {
  if (!on_terminal_) next_ += std::chrono::seconds(30);
}

std::string ProgressBar::text_at(Clock::time_point now, const Progress& progress) {
  if (now < next_) return "";
  const std::string state = fmt::format("{}/{} {}{}", progress.done, progress.total, noun_,
                                        pace(progress, std::chrono::duration<double>(now - started_).count()));
  if (!on_terminal_) {
    next_ = now + std::chrono::seconds(30);
    return fmt::format("{}: {}\n", title_, state);
  }
  next_ = now + std::chrono::milliseconds(100);
  constexpr std::int64_t cells = 30;
  const std::int64_t full = progress.total == 0 ? cells : cells * progress.done / progress.total;
  return fmt::format("\r\x1b[K{} [{:#<{}}{:.<{}}] {}", title_, "", full, "", cells - full, state);
}

ProgressBar::~ProgressBar() {
  if (on_terminal_) write_error("\r\x1b[K");
}

void ProgressBar::show(const Progress& progress) {
  if (const std::string text = text_at(Clock::now(), progress); !text.empty()) write_error(text);
}

std::filesystem::path output_folder(std::string_view study, const std::string& out) {
  if (!out.empty()) return out;
  constexpr std::size_t max_length = 100;  // bytes
  std::string name(base::front(base::one_line(study), max_length));
  for (char& c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80 && std::isalnum(byte) == 0 && c != '-' && c != '_' && c != '.') c = '_';
  }
  if (name.empty() || name.front() == '.') name = '_' + name;
  return std::filesystem::path("out") / name;
}

}  // namespace ikbench::cli
