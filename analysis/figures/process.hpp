// Runs another program without a shell.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ikbench::figures {

struct ProcessResult {
  bool succeeded = false;
  std::string output = {};  // its output, both streams; or why it could not start
};

// words[0] is the program, sought on the PATH; it works in `folder`, reads nothing, and its clock shows UTC.
ProcessResult run_process(const std::vector<std::string>& words, const std::filesystem::path& folder);

}  // namespace ikbench::figures
