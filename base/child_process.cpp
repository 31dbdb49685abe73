#include "base/child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/select.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <utility>

#include "base/names.hpp"

extern char** environ;  // the headers of some systems do not declare it

namespace ikbench::base {

namespace {

constexpr std::size_t kept_errors = 4000;  // bytes

#ifndef __GLIBC__
// Other C libraries have no call that closes all descriptors. So a forked process closes one after the other, and a
// started program closes them itself.
void closefrom(int first) {
  for (int descriptor = ::getdtablesize(); descriptor-- > first;) ::close(descriptor);
}
int posix_spawn_file_actions_addclosefrom_np(posix_spawn_file_actions_t*, int) { return 0; }
#endif
#ifdef __APPLE__  // a flag starts programs there without our descriptors
int pipe2(int* ends, int) { return ::pipe(ends); }
int clock_getcpuclockid(pid_t, clockid_t*) { return ENOSYS; }
constexpr short start_flags = POSIX_SPAWN_CLOEXEC_DEFAULT;
#else
constexpr short start_flags = 0;
#endif

struct Pipe {
  Pipe() {
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
      throw std::runtime_error(fmt::format("cannot open a pipe: {}; raise ulimit -n", std::strerror(errno)));
  }
  ~Pipe() {
    for (const int end : ends)
      if (end >= 0) ::close(end);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  int take(std::size_t end) { return std::exchange(ends.at(end), -1); }

  std::array<int, 2> ends{};  // the reading end, the writing end
};

// Starts a process that has these descriptors as 0, 1, 2, ... and no others. Returns an error number, or 0 if the
// process runs.
int spawn(pid_t& process, std::vector<std::string>& words, const std::filesystem::path& folder,
          std::vector<std::string>& own_variables, const std::vector<int>& descriptors) {
  std::vector<char*> arguments, variables;
  for (std::string& word : words) arguments.push_back(word.data());
  for (std::string& assignment : own_variables) variables.push_back(assignment.data());
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text = *variable, name = text.substr(0, text.find('=') + 1);
    const auto is_same = [&](const std::string& assignment) { return assignment.starts_with(name); };
    if (std::ranges::none_of(own_variables, is_same)) variables.push_back(*variable);
  }
  arguments.push_back(nullptr);
  variables.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawnattr_init(&attributes);
  if (!folder.empty()) ::posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  int count = 0;
  for (const int descriptor : descriptors) ::posix_spawn_file_actions_adddup2(&actions, descriptor, count++);
  posix_spawn_file_actions_addclosefrom_np(&actions, count);
  sigset_t none, all;
  sigemptyset(&none);  // macros on macOS
  sigfillset(&all);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &all);
  ::posix_spawnattr_setflags(&attributes,
                             start_flags | POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  const int error = ::posix_spawnp(&process, arguments[0], &actions, &attributes, arguments.data(), variables.data());
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  return error;
}

double cpu_seconds_of(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void wait_for_end(pid_t process) {
  while (::waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
  }
}

// Runs as the parent of the program. Waits until the program ends or our process is gone, which closes the lifeline;
// ends all that is left of the program, and ends as it did. The guard survives whatever happens to our process. It
// calls nothing that needs a lock except malloc, which C libraries keep usable after a fork.
template <class Spawn>
[[noreturn]] void guard(int lifeline, int reply, Spawn&& start) {
  ::setpgid(0, 0);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGPIPE}) ::signal(signal, SIG_IGN);
  ::signal(SIGCHLD, [](int) {});
#ifdef PR_SET_CHILD_SUBREAPER
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  ::prctl(PR_SET_DUMPABLE, 0);  // the program's core dump is enough
#endif
  sigset_t none, of_children;
  sigemptyset(&none);
  of_children = none;
  sigaddset(&of_children, SIGCHLD);
  ::sigprocmask(SIG_SETMASK, &of_children, nullptr);  // the signal comes only during pselect
  pid_t process = 0;
  const int error = start(process);
  const pid_t result = error == 0 ? process : -error;
  if (::write(reply, &result, sizeof(result)) < 0 || error != 0) ::_exit(0);
  ::dup2(lifeline, STDIN_FILENO);
  closefrom(STDIN_FILENO + 1);
  bool is_over = false;
  int status = 0;
  pid_t ended = 0;
  for (int tries = 0; ended >= 0 && tries < 1000;) {  // one second, since a process may wait for a disk for ever
    fd_set ends;
    FD_ZERO(&ends);
    FD_SET(STDIN_FILENO, &ends);
    if (!is_over) is_over = ::pselect(1, &ends, nullptr, nullptr, nullptr, &none) > 0;
    do {
      int child_status = 0;
      ended = ::waitpid(-1, &child_status, WNOHANG);
      if (ended == process) {
        is_over = true;
        status = child_status;
      }
    } while (ended > 0);
    if (!is_over) continue;
    ::kill(-process, SIGKILL);
    ::kill(process, SIGKILL);                              // the program may have left its group
    std::ifstream children("/proc/thread-self/children");  // also those whose parents have just ended
    for (pid_t child = 0; children >> child;) ::kill(child, SIGKILL);
    ::usleep(1000);
    ++tries;
  }
  if (!WIFSIGNALED(status)) ::_exit(WEXITSTATUS(status));
  ::signal(WTERMSIG(status), SIG_DFL);
  ::raise(WTERMSIG(status));
  ::_exit(1);
}

}  // namespace

ChildProcess::ChildProcess(std::vector<std::string> words, const std::filesystem::path& folder,
                           std::vector<std::string> variables, const std::vector<int>& inherited) {
  Pipe input, output, errors, lifeline, reply;
  guard_ = ::fork();
  if (guard_ == 0)
    guard(lifeline.ends[0], reply.ends[1], [&](pid_t& process) {
      std::vector<int> descriptors{input.ends[0], output.ends[1], errors.ends[1]};
      descriptors.insert(descriptors.end(), inherited.begin(), inherited.end());
      return spawn(process, words, folder, variables, descriptors);
    });
  if (guard_ < 0) throw std::runtime_error(fmt::format("no process starts: {}; raise ulimit -u", std::strerror(errno)));
  ::close(reply.take(1));
  pollfd of_guard{.fd = reply.ends[0], .events = POLLIN, .revents = 0};
  while (::poll(&of_guard, 1, 100) <= 0) ::kill(guard_, SIGCONT);  // the program may have stopped the guard
  while (::read(reply.ends[0], &process_, sizeof(process_)) < 0 && errno == EINTR) {
  }
  if (process_ < 0) {
    const int error = -process_;
    wait_for_end(guard_);
    std::error_code none;
    throw std::invalid_argument(fmt::format(
        "cannot start \"{0}\": {1}", words[0],
        error == ENOENT && std::filesystem::exists(folder / words[0], none)
            ? fmt::format("it is not on the PATH; a file in this folder is ./{}; a script needs its interpreter first",
                          words[0])
            : std::strerror(error)));
  }
  lifeline_ = lifeline.take(1);
  input_ = input.take(1);
  output_ = output.take(0);
  errors_ = errors.take(0);
  for (const int descriptor : {input_, output_, errors_}) ::fcntl(descriptor, F_SETFL, O_NONBLOCK);
}

ChildProcess::Ran ChildProcess::run(const std::vector<std::string>& words, const std::filesystem::path& folder,
                                    std::vector<std::string> variables) {
  try {
    ChildProcess process(words, folder, std::move(variables));
    process.end_input();
    const Clock::time_point deadline = Clock::now() + std::chrono::minutes(1);
    while (process.output_ >= 0) process.wait(-1, deadline, "it took more than 1 minute");
    process.end(std::chrono::seconds(1));
    return {WIFEXITED(process.status_) && WEXITSTATUS(process.status_) == 0, process.read_ + process.wrote_};
  } catch (const ProcessFailure& failure) {
    return {.output = fmt::format("{}: {}", words[0], failure.why)};
  } catch (const std::invalid_argument& error) {
    return {.output = error.what()};
  }
}

bool ChildProcess::is_running() {
  // An error means that the system does not keep how the guard ended.
  if (!has_ended_) has_ended_ = ::waitpid(guard_, &status_, WNOHANG) != 0;
  return !has_ended_;
}

double ChildProcess::cpu_seconds() const {
  if (has_ended_) return 0;
  return cpu_seconds_of(process_) + (worker_ > 0 ? cpu_seconds_of(worker_) : 0);
}

void ChildProcess::close_one(int& descriptor) {
  if (descriptor >= 0) ::close(std::exchange(descriptor, -1));
}

void ChildProcess::drain(int& from, std::string& into) {
  std::array<char, 8192> buffer;
  const ssize_t size = ::read(from, buffer.data(), buffer.size());
  if (size > 0)
    into.append(buffer.data(), static_cast<std::size_t>(size));
  else if (size == 0 || (errno != EAGAIN && errno != EINTR))
    close_one(from);
}

void ChildProcess::wait(int input, Clock::time_point deadline, const char* what) {
  constexpr long slice = 200;  // [ms] between checks that the process still runs
  const long left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
  if (left <= 0) throw ProcessFailure{ProcessFailure::Kind::timed_out, what};
  const bool has_room = read_.size() <= max_line_bytes;
  std::array<pollfd, 3> files{pollfd{.fd = errors_, .events = POLLIN, .revents = 0},
                              pollfd{.fd = has_room ? output_ : -1, .events = POLLIN, .revents = 0},
                              pollfd{.fd = input, .events = POLLOUT, .revents = 0}};
  const int ready = ::poll(files.data(), files.size(), static_cast<int>(std::min(left, slice)));
  if (ready > 0 && files[0].revents != 0) drain(errors_, wrote_);
  if (wrote_.size() > kept_errors) wrote_.erase(0, wrote_.size() - kept_errors);
  if (ready > 0 && files[1].revents != 0) drain(output_, read_);
  if (ready == 0 && !is_running()) close_one(output_);  // children of the program may hold the other end
}

bool ChildProcess::has_line() {
  if (output_ >= 0) drain(output_, read_);
  return read_.find('\n') != std::string::npos;
}

void ChildProcess::write(std::string_view text, Clock::time_point deadline) {
  // Without the signal, writing to a program that has ended is an error of write(), not the end of our process.
  [[maybe_unused]] static const auto before = ::signal(SIGPIPE, SIG_IGN);
  while (!text.empty()) {
    const ssize_t size = ::write(input_, text.data(), text.size());
    if (size >= 0)
      text.remove_prefix(static_cast<std::size_t>(size));
    else if (errno == EAGAIN)
      wait(input_, deadline, "it does not read its messages");
    else if (errno != EINTR)
      throw ProcessFailure{ProcessFailure::Kind::crashed, "it ended"};
  }
}

std::string ChildProcess::read_line(Clock::time_point deadline) {
  for (std::size_t seen = 0;;) {
    if (const std::size_t end = read_.find('\n', seen); end != std::string::npos && end <= max_line_bytes) {
      std::string line = read_.substr(0, end);
      read_.erase(0, end + 1);
      if (line.ends_with('\r')) line.pop_back();
      return line;
    }
    if (read_.size() > max_line_bytes)
      throw ProcessFailure{ProcessFailure::Kind::protocol_error, "it wrote a line of more than a million bytes"};
    if (output_ < 0) throw ProcessFailure{ProcessFailure::Kind::crashed, "it ended"};
    seen = read_.size();
    wait(-1, deadline, "it did not answer in time");
  }
}

void ChildProcess::end(std::chrono::milliseconds timeout) {
  if (guard_ < 0) return;
  close_one(input_);
  for (const auto until = Clock::now() + timeout; is_running() && Clock::now() < until;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  close_one(lifeline_);
  // The guard sees the closed lifeline within two seconds of running time. But the program may have stopped the guard,
  // and may do so again.
  for (const auto until = Clock::now() + std::chrono::seconds(5); is_running();) {
    ::kill(guard_, Clock::now() < until ? SIGCONT : SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (WIFSIGNALED(status_)) ::kill(-process_, SIGKILL);  // the guard may have been killed, but not the program
  if (errors_ >= 0) drain(errors_, wrote_);
  guard_ = -1;
  for (int* descriptor : {&output_, &errors_}) close_one(*descriptor);
}

std::string ChildProcess::end_after(ProcessFailure::Kind failure) {
  const bool by_itself = failure == ProcessFailure::Kind::crashed;
  end(std::chrono::seconds(by_itself ? 1 : 0));
  // A signal to all processes of a job may have reached the program before us. During this pause it ends our process,
  // or we hear it.
  if (by_itself) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  std::string text;
  if (by_itself && WIFSIGNALED(status_))
    text = fmt::format(" (signal {}{})", WTERMSIG(status_),
                       WTERMSIG(status_) == SIGKILL ? ": killed, or it closed its standard output" : "");
  if (by_itself && WIFEXITED(status_)) text = fmt::format(" (exit code {})", WEXITSTATUS(status_));
  std::string_view last = wrote_;
  last = last.substr(0, last.find_last_not_of("\n ") + 1);
  last = last.substr(last.find_last_of('\n') + 1);
  if (!last.empty()) text += fmt::format("; its last output: {}", one_line(front(last, 200)));
  return text;
}

}  // namespace ikbench::base
