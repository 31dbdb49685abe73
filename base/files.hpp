// Writes files that are either whole or absent: under another name in the same folder, then renamed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace ikbench::base {

// Writes a file of results. Creates the folder if it is missing, and keeps the permissions of a file that it replaces.
// A link, a pipe or a device is replaced and never opened, since a stranger may have put it into a folder of results.
// Throws as refuse_place, and std::invalid_argument if the file is an input (base/inputs.hpp).
void write_file(const std::filesystem::path& file, std::string_view text);
// Writes the same in parts, which `contents` passes one after another. If `contents` throws, a file that would be
// replaced stays as it was.
using Write = std::function<void(std::string_view)>;
using Contents = std::function<void(const Write&)>;
void write_file(const std::filesystem::path& file, const Contents& contents);
// Writes a file that the user named: follows a link, refuses a pipe or a device, and waits for the disk. The files of a
// report need no such wait, because the store makes them again.
void write_through(const std::filesystem::path& file, const Contents& contents);
// Throws that a place cannot be written or read: std::invalid_argument for a mistake of the user, such as a place that
// is not theirs; std::runtime_error otherwise, such as for a full disk or a limit. `error` is an errno.
[[noreturn]] void refuse_place(std::string_view verb, const std::filesystem::path& place, int error);
// Passes the bytes of a regular file, also behind a link, one part after another until `take` returns false, so that a
// large file needs little memory. Returns false if there is no such file. Throws as refuse_place if it cannot be read.
bool read_in_parts(const std::filesystem::path& file, const std::function<bool(std::string_view)>& take);
// Reads a regular file, also behind a link, until it has more than `enough` bytes. Returns nothing if there is no such
// file. Throws as refuse_place if the file cannot be read. A file that the user names is read by base/inputs.hpp.
std::optional<std::string> read_file(const std::filesystem::path& file, std::uintmax_t enough = UINTMAX_MAX);
// A new folder .ikbench-XXXXXX inside another, for unfinished work. The destructor removes it. A folder that a killed
// process left a day ago is removed when the next one is made. No link or file of others is in it.
class TemporaryFolder {
 public:
  // Creates the folder. Throws as refuse_place for the parent, or for `result`, the file or folder that will be made of
  // it.
  explicit TemporaryFolder(const std::filesystem::path& parent, const std::filesystem::path& result = {});
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// Removes all such folders of this process, for a sudden end. Afterwards no thread makes, removes or renames one.
void remove_temporary_folders();

}  // namespace ikbench::base
