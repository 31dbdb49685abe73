// Another program, run without a shell.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ikbench::figures {

struct ProcessResult {
  bool succeeded = false;
  std::string output;  // what it printed, both streams; or why it could not be started
};

// words[0] is the program, sought on the PATH; `folder` is where it works. It reads nothing, and its
// clock shows UTC.
ProcessResult run_process(const std::vector<std::string>& words, const std::filesystem::path& folder);

}  // namespace ikbench::figures
