// Files that are either whole or not there: written beside their place under another name, then renamed. What is there
// and is no regular file (a device, a pipe) is written into.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace ikbench::results {

// Creates the folder where missing, keeps the owner and the permissions of a file that it replaces. A link is replaced
// and not followed: what somebody else may have put into a folder of results leads nowhere. A file that has other
// names, that the shell has open, or whose folder takes no new file is written in its place. std::invalid_argument, or
// std::runtime_error where a disk is full or fails, names the file and the system's reason. Halves of the same file
// that killed processes left are removed.
void write_file(const std::filesystem::path& file, std::string_view text);
// The same in parts, of which `contents` writes one after another. What it throws leaves the file as it was, where that
// is replaced.
using Write = std::function<void(std::string_view)>;
using Contents = std::function<void(const Write&)>;
void write_file(const std::filesystem::path& file, const Contents& contents);
// The same for a file that the user has named: links are followed.
void write_through(const std::filesystem::path& file, std::string_view text);
// A folder that is whole or not there; one that is there is empty. `fill` writes into another, which then gets its
// name.
void write_folder(const std::filesystem::path& folder, const std::function<void(const std::filesystem::path&)>& fill);
// Empty if the file cannot be read.
std::optional<std::string> read_file(const std::filesystem::path& file);

// A new folder inside another, for work that is not finished; gone at the end. Nobody else's link or file is in it.
class TemporaryFolder {
 public:
  // std::invalid_argument, or std::runtime_error as above, names the folder and the system's reason.
  explicit TemporaryFolder(const std::filesystem::path& parent);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;
};

// Removes those that this process has: before it ends at once.
void remove_temporary_folders();

// Removes the half-written files and scratch folders that killed processes left in a folder. Those of living processes
// stay: they are locked.
void remove_litter(const std::filesystem::path& folder);

}  // namespace ikbench::results
