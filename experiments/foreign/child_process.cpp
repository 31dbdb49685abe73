#include "experiments/foreign/child_process.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <thread>
#include <utility>

namespace ikbench::experiments {

namespace {

constexpr std::size_t kept_errors = 4000;  // bytes
constexpr std::size_t most_unread = 4 * ChildProcess::longest_line;

struct Pipe {
  Pipe() {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
      throw std::runtime_error(fmt::format("cannot open a pipe: {}", std::strerror(errno)));
  }
  ~Pipe() {
    for (const int end : ends) {
      if (end >= 0) ::close(end);
    }
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  int take(std::size_t end) { return std::exchange(ends.at(end), -1); }

  std::array<int, 2> ends{};  // the reading end, the writing end
};

// An environment variable with the number of the guard. The program and everything that it starts have it, in whatever
// group or session. This class and its readers take no memory and need no lock.
class Mark {
 public:
  explicit Mark(pid_t guard) {
    char* const end = std::to_chars(std::ranges::copy(name, text_.begin()).out, text_.end() - 1, guard).ptr;
    *end = '\0';
    size_ = static_cast<std::size_t>(end - text_.data());
  }
  std::string_view text() const { return {text_.data(), size_}; }
  std::string_view whole() const { return {text_.data(), size_ + 1}; }  // with its final zero

  static constexpr std::string_view name = "IKBENCH_GUARD=";

 private:
  std::array<char, 40> text_;
  std::size_t size_ = 0;
};

// Says whether a process of /proc started with the mark in its environment.
bool is_marked(int proc, const char* process, const Mark& mark) {
  constexpr std::string_view file_name = "/environ";
  std::array<char, 64> path{};
  const std::size_t digits = std::strlen(process);
  if (digits + file_name.size() >= path.size()) return false;
  std::ranges::copy(file_name, std::copy_n(process, digits, path.begin()));
  const int file = ::openat(proc, path.data(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  std::array<char, 8192> buffer;
  std::size_t kept = 0;  // the end of the last read, in which the mark may begin
  bool found = false;
  for (ssize_t size = 0; !found && (size = ::read(file, buffer.data() + kept, buffer.size() - kept)) > 0;) {
    const std::string_view text(buffer.data(), kept + static_cast<std::size_t>(size));
    found = text.find(mark.whole()) != std::string_view::npos;
    kept = std::min(text.size(), mark.whole().size() - 1);
    std::memmove(buffer.data(), text.data() + text.size() - kept, kept);
  }
  ::close(file);
  return found;
}

// Kills all marked processes and returns their number.
int kill_marked(const Mark& mark) {
  const int proc = ::open("/proc", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (proc < 0) return 0;
  int killed = 0;
  alignas(dirent64) std::array<char, 8192> entries;
  for (ssize_t size = 0; (size = ::getdents64(proc, entries.data(), entries.size())) > 0;) {
    for (ssize_t at = 0; at < size;) {
      const auto* const entry = reinterpret_cast<const dirent64*>(entries.data() + at);
      at += entry->d_reclen;
      pid_t process = 0;
      const char* const name = entry->d_name;
      std::from_chars(name, name + std::strlen(name), process);
      if (process <= 0 || !is_marked(proc, name, mark)) continue;
      ::kill(process, SIGKILL);
      ++killed;
    }
  }
  ::close(proc);
  return killed;
}

// Finds by its mark what left the session, as setsid does. It may start others meanwhile, so this repeats.
void kill_all_marked(const Mark& mark) {
  constexpr int most_rounds = 10;
  for (int round = 0; round < most_rounds && kill_marked(mark) > 0; ++round) {
  }
}

// A program may leave the group that it was started in, as coreutils' timeout does, and lead its own.
void signal_all(pid_t group, pid_t process, int signal) {
  if (::getpgid(process) == process) ::kill(-process, signal);
  ::kill(process, signal);
  ::kill(-group, signal);
}

// Starts a process that leads a group and waits until nobody holds the other end of the lifeline. It reads the number
// of the program's process from there. Then it ends all by force. It survives whatever happens to our process, and
// calls nothing that needs a lock.
pid_t start_guard(int lifeline) {
  const pid_t guard = ::fork();
  if (guard != 0) {
    if (guard > 0) ::setpgid(guard, guard);
    return guard;
  }
  ::setpgid(0, 0);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGPIPE}) ::signal(signal, SIG_IGN);
  ::dup2(lifeline, STDIN_FILENO);
  ::closefrom(STDIN_FILENO + 1);
  pid_t process = 0, ignored = 0;
  while (::read(STDIN_FILENO, &process, sizeof(process)) < 0 && errno == EINTR) {
  }
  while (::read(STDIN_FILENO, &ignored, sizeof(ignored)) < 0 && errno == EINTR) {
  }
  kill_all_marked(Mark(::getpid()));  // first, since the group that is ended next is the guard's own
  if (process > 0) signal_all(::getpid(), process, SIGKILL);
  ::kill(0, SIGKILL);
  ::_exit(0);
}

// While it lives, writing to a pipe without a reader is an error of write() in this thread, not a signal.
class WithoutPipeSignal {
 public:
  WithoutPipeSignal() {
    ::sigemptyset(&pipe_);
    ::sigaddset(&pipe_, SIGPIPE);
    ::pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~WithoutPipeSignal() {
    const timespec at_once{};
    if (!::sigismember(&before_, SIGPIPE)) {
      while (::sigtimedwait(&pipe_, nullptr, &at_once) < 0 && errno == EINTR) {
      }
    }
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  WithoutPipeSignal(const WithoutPipeSignal&) = delete;
  WithoutPipeSignal& operator=(const WithoutPipeSignal&) = delete;

 private:
  sigset_t pipe_{}, before_{};
};

std::vector<std::string> environment_of_child(pid_t guard) {
  std::vector<std::string> variables{std::string(Mark(guard).text()), "LC_ALL=C", "OMP_NUM_THREADS=1"};
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text = *variable;
    const auto begins = [&](std::string_view name) { return text.starts_with(name); };
    if (!begins(Mark::name) && !begins("LC_ALL=") && !begins("OMP_NUM_THREADS=")) variables.emplace_back(text);
  }
  return variables;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

// Returns an error number, or 0 if the process runs.
int spawn(pid_t& process, const Command& command, pid_t group, const std::array<int, 3>& descriptors) {
  std::vector<std::string> words = command.words, variables = environment_of_child(group);
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawnattr_init(&attributes);
  if (!command.folder.empty()) ::posix_spawn_file_actions_addchdir_np(&actions, command.folder.c_str());
  for (int i = 0; i < 3; ++i) {
    ::posix_spawn_file_actions_adddup2(&actions, descriptors[static_cast<std::size_t>(i)], i);
  }
  ::posix_spawn_file_actions_addclosefrom_np(&actions, STDERR_FILENO + 1);
  sigset_t none, all;
  ::sigemptyset(&none);
  ::sigfillset(&all);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &all);
  ::posix_spawnattr_setpgroup(&attributes, group);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  const int error = ::posix_spawnp(&process, words[0].c_str(), &actions, &attributes, pointers_to(words).data(),
                                   pointers_to(variables).data());
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  return error;
}

void close_one(int& descriptor) {
  if (descriptor >= 0) ::close(std::exchange(descriptor, -1));
}

void bury(pid_t process, int& status) {
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace

ChildProcess::ChildProcess(const Command& command) {
  Pipe input, output, errors, lifeline;
  guard_ = start_guard(lifeline.ends[0]);
  if (guard_ < 0) throw std::runtime_error(fmt::format("cannot start a process: {}", std::strerror(errno)));
  const int error = spawn(process_, command, guard_, {input.ends[0], output.ends[1], errors.ends[1]});
  if (error != 0) {
    int ignored = 0;
    ::kill(guard_, SIGKILL);
    bury(guard_, ignored);
    throw std::invalid_argument(fmt::format("cannot start \"{}\": {}", command.words[0], std::strerror(error)));
  }
  lifeline_ = lifeline.take(1);
  while (::write(lifeline_, &process_, sizeof(process_)) < 0 && errno == EINTR) {
  }
  input_ = input.take(1);
  output_ = output.take(0);
  errors_ = errors.take(0);
  for (const int descriptor : {input_, output_, errors_}) ::fcntl(descriptor, F_SETFL, O_NONBLOCK);
}

bool ChildProcess::is_running() {
  if (!has_ended_) has_ended_ = ::waitpid(process_, &status_, WNOHANG) == process_;
  return !has_ended_;
}

std::string ChildProcess::how_it_ended() const {
  if (!has_ended_) return "";
  return WIFSIGNALED(status_) ? fmt::format("signal {}", WTERMSIG(status_))
                              : fmt::format("exit code {}", WEXITSTATUS(status_));
}

double ChildProcess::cpu_seconds() const {
  clockid_t clock{};
  timespec time{};
  if (has_ended_ || ::clock_getcpuclockid(process_, &clock) != 0 || ::clock_gettime(clock, &time) != 0)
    return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void ChildProcess::drain_errors() {
  std::array<char, 4096> buffer;
  const ssize_t size = ::read(errors_, buffer.data(), buffer.size());
  if (size > 0) {
    last_errors_.append(buffer.data(), static_cast<std::size_t>(size));
    if (last_errors_.size() > kept_errors) last_errors_.erase(0, last_errors_.size() - kept_errors);
  } else if (size == 0 || (errno != EAGAIN && errno != EINTR)) {
    close_one(errors_);
  }
}

void ChildProcess::drain_output() {
  std::array<char, 65536> buffer;
  const ssize_t size = ::read(output_, buffer.data(), buffer.size());
  if (size > 0) {
    read_.append(buffer.data(), static_cast<std::size_t>(size));
  } else if (size == 0 || (errno != EAGAIN && errno != EINTR)) {
    close_one(output_);
  }
}

bool ChildProcess::wait(Wait purpose, Clock::time_point deadline) {
  constexpr long slice = 200;  // [ms] between checks that the process still runs
  const long left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
  if (left <= 0) return false;
  const bool has_room = read_.size() - taken_ < most_unread;
  std::array<pollfd, 3> files{pollfd{.fd = errors_, .events = POLLIN, .revents = 0},
                              pollfd{.fd = has_room ? output_ : -1, .events = POLLIN, .revents = 0},
                              pollfd{.fd = purpose == Wait::to_write ? input_ : -1, .events = POLLOUT, .revents = 0}};
  const int ready = ::poll(files.data(), files.size(), static_cast<int>(std::min(left, slice)));
  if (ready > 0 && files[0].revents != 0) drain_errors();
  if (ready > 0 && files[1].revents != 0) drain_output();
  if (ready == 0 && !is_running()) close_one(output_);  // its children may hold the other end
  return true;
}

bool ChildProcess::has_line() {
  const auto is_there = [&] { return read_.find('\n', taken_) != std::string::npos; };
  if (!is_there() && output_ >= 0) drain_output();
  return is_there();
}

ChildProcess::Outcome ChildProcess::write(std::string_view text, Clock::time_point deadline) {
  const WithoutPipeSignal no_signal;
  while (!text.empty()) {
    if (input_ < 0) return Outcome::ended;
    const ssize_t size = ::write(input_, text.data(), text.size());
    if (size >= 0) {
      text.remove_prefix(static_cast<std::size_t>(size));
    } else if (errno == EAGAIN) {
      if (!wait(Wait::to_write, deadline)) return Outcome::too_late;
    } else if (errno != EINTR) {
      return Outcome::ended;
    }
  }
  return Outcome::done;
}

ChildProcess::Outcome ChildProcess::read_line(std::string& line, Clock::time_point deadline) {
  for (std::size_t seen = taken_;;) {
    const std::size_t end = read_.find('\n', seen);
    if (end != std::string::npos && end - taken_ <= longest_line) {
      line.assign(read_, taken_, end - taken_);
      if (line.ends_with('\r')) line.pop_back();
      taken_ = end + 1;
      if (taken_ == read_.size()) {
        read_.clear();
        taken_ = 0;
      }
      return Outcome::done;
    }
    if (read_.size() - taken_ > longest_line) return Outcome::too_long;
    if (output_ < 0) return Outcome::ended;
    read_.erase(0, std::exchange(taken_, 0));
    seen = read_.size();
    if (!wait(Wait::to_read, deadline)) return Outcome::too_late;
  }
}

bool ChildProcess::ends_within(std::chrono::milliseconds patience) {
  const Clock::time_point deadline = Clock::now() + patience;
  while (is_running()) {
    if (Clock::now() >= deadline) return false;
    if (errors_ >= 0) drain_errors();  // a full pipe would block it
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

void ChildProcess::end(std::chrono::milliseconds patience) {
  if (guard_ < 0) return;
  close_one(input_);
  if (!ends_within(patience)) {
    signal_all(guard_, process_, SIGTERM);
    ends_within(std::chrono::seconds(1));
  }
  if (has_ended_) {
    ::kill(-guard_, SIGKILL);  // its children may be left, and the guard
  } else {
    signal_all(guard_, process_, SIGKILL);
  }
  kill_all_marked(Mark(guard_));
  if (!has_ended_) bury(process_, status_);
  has_ended_ = true;
  for (int i = 0; i < 100 && errors_ >= 0; ++i) {
    const std::size_t before = last_errors_.size();
    drain_errors();
    if (last_errors_.size() == before) break;
  }
  int ignored = 0;
  bury(guard_, ignored);
  guard_ = -1;
  for (int* descriptor : {&lifeline_, &output_, &errors_}) close_one(*descriptor);
}

}  // namespace ikbench::experiments
