// Writes files that are either whole or absent: under another name beside their place, then renamed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace ikbench::base {

// Creates the folder if it is missing. Keeps the permissions of a replaced file. Replaces a link, a pipe or a device,
// and opens none, since somebody else may have put it into a folder of results. Throws as refuse_place, and
// std::invalid_argument if the file is an input (base/inputs.hpp).
void write_file(const std::filesystem::path& file, std::string_view text);
// The same in parts, which `contents` writes one after another. If it throws, a file that would be replaced stays as it
// was.
using Write = std::function<void(std::string_view)>;
using Contents = std::function<void(const Write&)>;
void write_file(const std::filesystem::path& file, const Contents& contents);
// The same for a file that the user named: follows a link, refuses a pipe or a device, and waits for the disk, which a
// report of forty files, which a store makes again, does not.
void write_through(const std::filesystem::path& file, const Contents& contents);
// Says that a place cannot be written or read: std::invalid_argument for a mistake of the user, as a place that is not
// theirs, std::runtime_error for others, as a full disk or a limit.
[[noreturn]] void refuse_place(std::string_view verb, const std::filesystem::path& place, int error);
// Reads a regular file, where a link leads too, until it has more than `enough` bytes; nothing if there is none. Throws
// as refuse_place if it cannot be read. A user's own: base/inputs.hpp.
std::optional<std::string> read_file(const std::filesystem::path& file, std::uintmax_t enough = UINTMAX_MAX);

// A new folder .ikbench-XXXXXX inside another, for unfinished work; removed at the end, and what a killed process left
// a day ago when the next is made. Nobody else's link or file is in it.
class TemporaryFolder {
 public:
  // Throws as refuse_place, for the parent, or the file or folder that becomes of it.
  explicit TemporaryFolder(const std::filesystem::path& parent, const std::filesystem::path& result = {});
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// Removes those of this process, for a sudden end: nothing after it makes, removes or renames such a folder.
void remove_temporary_folders();

}  // namespace ikbench::base
