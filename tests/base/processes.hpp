// Actions in separate processes, which may be killed.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include "tests/common.hpp"

namespace ikbench {

// Runs `action` in a new process; its exit code is 0 if `action` returned true.
inline pid_t in_a_process(const std::function<bool()>& action) {
  const pid_t child = fork();
  if (child != 0) return child;
  try {
    _exit(action() ? 0 : 1);
  } catch (const std::exception& error) {
    fprintf(stderr, "%s\n", error.what());
    _exit(2);
  }
}

inline int exit_code(pid_t child) {
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace ikbench
