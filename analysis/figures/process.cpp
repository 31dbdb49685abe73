#include "analysis/figures/process.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <optional>
#include <string_view>

namespace ikbench::figures {
namespace {

constexpr std::size_t most_output = 4096;
constexpr std::chrono::seconds patience{60};

// Reads a pipe until the other side closes it, and keeps the first bytes; nothing if that takes too long.
std::optional<std::string> read_all(int descriptor) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point deadline = Clock::now() + patience;
  std::string text;
  std::array<char, 4096> buffer;
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd waiting{.fd = descriptor, .events = POLLIN, .revents = 0};
    const int ready = left > 0 ? ::poll(&waiting, 1, static_cast<int>(left)) : 0;
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return std::nullopt;
    const ssize_t size = ::read(descriptor, buffer.data(), buffer.size());
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return text;
    text.append(buffer.data(), std::min(static_cast<std::size_t>(size), most_output - text.size()));
  }
}

bool wait_for(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) return false;
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& words, const std::filesystem::path& folder) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) return {false, fmt::format("cannot open a pipe: {}", std::strerror(errno))};

  std::vector<char*> arguments;
  std::vector<std::string> copies = words;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);

  std::string utc = "TZ=UTC0";
  std::vector<char*> variables{utc.data()};
  for (char** variable = environ; *variable != nullptr; ++variable) {
    if (!std::string_view(*variable).starts_with("TZ=")) variables.push_back(*variable);
  }
  variables.push_back(nullptr);

  sigset_t none;
  ::sigemptyset(&none);
  const pid_t us = ::getpid(), process = ::fork();
  if (process == 0) {  // nothing here needs a lock, which another thread may have
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
    const bool is_ready = ::getppid() == us && ::chdir(folder.c_str()) == 0 && ::dup2(nothing, STDIN_FILENO) >= 0 &&
                          ::dup2(pipe[1], STDOUT_FILENO) >= 0 && ::dup2(pipe[1], STDERR_FILENO) >= 0;
    ::sigprocmask(SIG_SETMASK, &none, nullptr);  // the program decides itself what signals do to it
    if (is_ready) ::execvpe(arguments[0], arguments.data(), variables.data());
    for (const std::string_view text : {std::string_view("cannot start "), std::string_view(arguments[0]),
                                        std::string_view(": "), std::string_view(::strerrordesc_np(errno))})
      static_cast<void>(::write(pipe[1], text.data(), text.size()) < 0);
    ::_exit(127);
  }
  ::close(pipe[1]);

  ProcessResult result;
  if (process < 0) {
    result.output = fmt::format("cannot start {}: {}", words[0], std::strerror(errno));
  } else {
    std::optional<std::string> output = read_all(pipe[0]);
    if (!output) ::kill(process, SIGKILL);
    result.succeeded = wait_for(process) && output;
    result.output = output ? std::move(*output) : fmt::format("{} took more than {} s", words[0], patience.count());
  }
  ::close(pipe[0]);
  return result;
}

}  // namespace ikbench::figures
